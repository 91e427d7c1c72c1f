#include <cstdlib>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/bench_job.h"
#include "session/pictures.h"

namespace inhabit::app {
namespace {

struct Bench {
  std::vector<std::string> groups;
  session::BenchOptions options;
  std::string scheme = "gauss-seidel", plots, against;
  bool json = false, quiet = false, no_relocation = false;
};

int run(Bench& b) {
  if (!b.against.empty()) {
    std::erase(b.groups, "layout");
    b.groups.push_back("against");
  }
  session::BenchOptions& options = b.options;
  options.layout.scheme = b.scheme == "averaged" ? layout::Scheme::averaged : layout::Scheme::gauss_seidel;
  options.layout.relocation = !b.no_relocation;
  if (const char* data = std::getenv("INHABIT_DATA"); options.data.empty() && data) options.data = data;
  if (!b.plots.empty() && !can_save(b.plots + "/plot.svg")) return kError;
  const Interruptible interruptible;
  options.cancel = interruptible.cancel();
  const core::Result<session::BenchAnswer> answer = [&] {
    ProgressLine line(!b.quiet);
    options.progress = line.reporter();
    return session::bench_job(b.groups, options);
  }();
  options.progress = nullptr;
  if (!answer) return fail("bench", answer.error());
  print(b.json ? session::bench_json(*answer) : session::bench_text(*answer));
  for (const session::BenchCurve& curve : answer->curves) {
    if (b.plots.empty()) break;
    const std::string path = b.plots + "/" + curve.id + ".svg";
    if (!save(path, session::curve_picture(curve, path))) return kError;
  }
  for (const session::BenchSheet& sheet : answer->sheets) {
    if (b.plots.empty()) break;
    const std::string path = b.plots + "/" + sheet.id + ".png";
    if (!save(path, session::sheet_picture(sheet, path))) return kError;
  }
  return kDone;
}

}  // namespace

std::function<int()> set_up_bench(CLI::App& verb) {
  const auto b = std::make_shared<Bench>();
  verb.add_option("GROUP", b->groups, "What to measure; all of layout when absent")->expected(0, -1);
  CLI::Option* seeds =
      verb.add_option("--seeds", b->options.seeds, "Seeds per scene; realism and learned take 5 when absent")
          ->check(CLI::Range(1, 100000))
          ->capture_default_str();
  verb.add_option("--set", b->options.set, "realism, emergence: a parameter of the model, NAME=VALUE; may be repeated");
  verb.add_option("--max-seats", b->options.max_seats, "growth: the largest theatre, up to 100000")
      ->check(CLI::Range(25, 100000))
      ->capture_default_str();
  verb.add_option("--max-people", b->options.max_people, "crowd: the largest crowd of the growth, up to 1000000")
      ->check(CLI::Range(1000, 1000000))
      ->capture_default_str();
  verb.add_option("--seconds", b->options.seconds, "crowd: simulated time, at most; as each scene says when absent")
      ->check(CLI::PositiveNumber);
  verb.add_option("--threads", b->options.threads, "crowd: threads; all there are when absent")
      ->check(CLI::Range(1, 1024));
  verb.add_option(
          "--data", b->options.data,
          "rooms, learned, measures, realism: folder that holds rooms/ and pedestrians/ (or the environment variable "
          "INHABIT_DATA)")
      ->type_name("DIR");
  verb.add_option("--scheme", b->scheme, "gauss-seidel or averaged")
      ->check(CLI::IsMember({"gauss-seidel", "averaged"}))
      ->capture_default_str();
  verb.add_flag("--no-relocation", b->no_relocation, "Projection alone");
  verb.add_flag("--paper", b->options.layout.paper, "The papers' method to the letter");
  verb.add_option("--against", b->against, "anneal: layout beside simulated annealing instead (the group against)")
      ->check(CLI::IsMember({"anneal"}));
  verb.add_option("--plots", b->plots, "Write the curves into this folder as SVG, and sheets of rooms as PNG")
      ->type_name("DIR");
  verb.add_flag("--json", b->json, "One JSON object on standard output and nothing else there");
  verb.add_flag("-q,--quiet", b->quiet, "No progress");
  verb.footer("Groups:\n  layout      every group about furniture but against and anneal\n" +
              session::bench_group_lines() +
              "Times are of one start on one thread unless a column says otherwise.\n"
              "Examples:\n  inhabit bench layout\n  inhabit bench table1 --seeds 20 --json\n  inhabit bench layout "
              "--against anneal --plots plots\n  inhabit bench growth "
              "--max-seats 100000 --plots plots");
  return [b, seeds] {
    b->options.seeds_given = seeds->count() > 0;
    return run(*b);
  };
}

}  // namespace inhabit::app
