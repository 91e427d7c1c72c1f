#include <algorithm>
#include <charconv>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/jobs.h"
#include "session/learn_job.h"
#include "session/pictures.h"

namespace inhabit::app {
namespace {

struct Furnish {
  SceneArgument scene;
  session::FurnishJob job;
  std::string out, svg, png, pdf, trace, method = "pbd", scheme = "gauss-seidel", start = "given", priors;
  std::vector<std::string> weights;
  std::int64_t iterations = 0;
  bool no_relocation = false, json = false, quiet = false;
};

constexpr const char* kFooter =
    "With --variants K > 1, OUT gets a number for each suggestion (room-1.json, room-2.json, …) and a picture shows\n"
    "them all. Exit code 1: something overlaps or stands outside, or a constraint of SCENE is not kept (the table "
    "says\n"
    "which, and by how much). House rules may be missed; OUT says of them \"house_rules\": true, and check agrees.\n"
    "Examples:\n"
    "  inhabit furnish living-room -o room.json --svg room.svg\n"
    "  inhabit furnish tight-bedroom --variants 6 --png choices.png -o bedroom.json\n"
    "  inhabit furnish home.sh3d --room Bedroom --start placed --house-rules -o furnished.sh3d\n"
    "  inhabit furnish bedroom --method both --priors bedroom.priors.json --png bedroom.png\n"
    "  inhabit furnish picnic --trace energy.csv --quiet";

void add_method(CLI::App& verb, Furnish& f) {
  layout::Options& layout = f.job.layout;
  verb.add_option("--method", f.method,
                  "How: pbd = position-based projection; anneal = simulated annealing towards learned priors; both = "
                  "annealed, then settled by projection")
      ->check(CLI::IsMember({"pbd", "anneal", "both"}))
      ->capture_default_str();
  verb.add_option("--priors", f.priors, "What furnished rooms taught (inhabit learn); pbd takes them as constraints")
      ->type_name("FILE");
  verb.add_option("--seed", layout.seed, "Seed of every random choice; the same seed gives the same bytes")
      ->check(not_negative, "")
      ->capture_default_str();
  verb.add_option("--starts", layout.starts, "Random starts; the best one is kept")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  verb.add_option("--variants", f.job.variants, "Distinct suggestions, best first")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb.add_option("--threads", layout.threads, "Threads, 0 = all there are; never changes the result")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb.add_option("--scheme", f.scheme, "How corrections add up: gauss-seidel or averaged")
      ->check(CLI::IsMember({"gauss-seidel", "averaged"}))
      ->capture_default_str();
  verb.add_option("--start", f.start,
                  "Where free objects start: given (where SCENE has them), random, placed (afresh, one by one)")
      ->check(CLI::IsMember({"given", "random", "placed"}))
      ->capture_default_str();
  verb.add_option("--iterations", f.iterations,
                  "At most so many per start; when absent 20000, and for annealing 20000 for every object")
      ->check(CLI::Range(1, 1000000000));
  verb.add_flag("--no-relocation", f.no_relocation, "Projection alone, without moves between");
  verb.add_flag("--paper", layout.paper,
                "The papers' method to the letter: random starts, no relocation, no polishing");
  verb.add_flag("--house-rules", f.job.house_rules,
                "Rooms without constraints get the usual ones by kind (beds at walls, seats at tables)");
}

void add_annealing(CLI::App& verb, Furnish& f) {
  annealing::Options& anneal = f.job.anneal;
  verb.add_option("--weight", f.weights,
                  "Annealing: weight of a cost term, NAME=VALUE; may be repeated. accessibility, visibility, pathway, "
                  "wall-distance, wall-angle, pair-distance, pair-angle (the priors' otherwise), overlap, inside (per "
                  "metre)")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  verb.add_option("--hot", anneal.hot, "Annealing: first temperature, in units of the cost")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--cold", anneal.cold, "Annealing: last temperature")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  verb.add_option("--replicas", anneal.replicas, "Annealing: chains of each start that trade temperatures")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  verb.add_option("--path-width", anneal.path_width, "Annealing, priors: width of the pathways between doors, metres")
      ->check(CLI::Range(0.1, 10.0))
      ->capture_default_str();
}

void add_output(CLI::App& verb, Furnish& f) {
  verb.add_option("-o,--output", f.out, "Furnished scene, in the format of the extension")->type_name("FILE");
  verb.add_option("--svg", f.svg, "Plan as SVG")->type_name("FILE");
  verb.add_option("--png", f.png, "Plan as PNG")->type_name("FILE");
  verb.add_option("--pdf", f.pdf, "Plan as PDF")->type_name("FILE");
  verb.add_option("--trace", f.trace, "Energy per iteration as CSV, and its plot beside it (FILE.svg and FILE.png)")
      ->type_name("FILE");
  verb.add_flag("--json", f.json,
                "One JSON object on standard output and nothing else there; with the scenes unless -o is given");
  verb.add_flag("-q,--quiet", f.quiet, "No progress, no table");
}

bool write_scenes(const Furnish& f, const session::Document& document, const session::Furnished& furnished) {
  if (f.out.empty()) return true;
  if (f.job.variants == 1) return save(f.out, session::write_document(furnished.document(document), f.out));
  std::size_t count = 0;
  for (const session::FurnishedRoom& room : furnished.rooms) count = std::max(count, room.suggestions.size());
  for (std::size_t k = 0; k < count; ++k)
    if (!save(numbered_path(f.out, k + 1), session::write_document(furnished.document(document, k), f.out)))
      return false;
  return true;
}

bool write_pictures(const Furnish& f, const session::Document& document, const session::Furnished& furnished) {
  for (const std::string& path : {f.svg, f.png, f.pdf}) {
    if (path.empty()) continue;
    const bool sheet = f.job.variants > 1;
    if (!save(path, sheet ? session::sheet_picture(furnished, path)
                          : session::plan_picture(furnished.document(document), path)))
      return false;
  }
  return true;
}

bool write_trace(const Furnish& f, const session::Furnished& furnished) {
  if (f.trace.empty()) return true;
  for (std::size_t i = 0; i < furnished.rooms.size(); ++i) {
    const session::FurnishedRoom& room = furnished.rooms[i];
    const std::string path = furnished.rooms.size() > 1 ? numbered_path(f.trace, i + 1) : f.trace;
    const bool annealed = !room.anneal_trace.empty();
    if (!save(path, annealed ? session::trace_csv(room.anneal_trace) : session::trace_csv(room.trace))) return false;
    for (const char* extension : {".svg", ".png"}) {
      const std::string name = path + extension;
      if (!save(name, annealed ? session::trace_picture(room.anneal_trace, room.name, name)
                               : session::trace_picture(room.trace, room.name, name)))
        return false;
    }
  }
  return true;
}

/// What can be known to be wrong before minutes of work are spent.
bool names_are_good(const Furnish& f) {
  const std::pair<const std::string*, const char*> pictures[] = {{&f.svg, ".svg"}, {&f.png, ".png"}, {&f.pdf, ".pdf"}};
  for (const auto& [path, extension] : pictures)
    if (!path->empty() && !path->ends_with(extension)) {
      complain(*path + ": the name of this picture must end in " + extension);
      return false;
    }
  if (!f.trace.empty() && f.job.variants > 1) return complain("--trace needs --variants 1"), false;
  return std::ranges::all_of(std::initializer_list<std::string>{f.out, f.svg, f.png, f.pdf, f.trace}, can_save);
}

/// The priors file, and the weights given beside it.
bool read_priors(Furnish& f) {
  f.job.method = f.method == "anneal" ? session::Method::anneal
                 : f.method == "both" ? session::Method::both
                                      : session::Method::pbd;
  if (f.job.method != session::Method::pbd && f.priors.empty())
    return complain("--method " + f.method + " needs --priors FILE: learn them from furnished rooms (inhabit learn)"),
           false;
  if (!f.weights.empty() && f.job.method == session::Method::pbd)
    return complain("--weight is of annealing: --method anneal or both"), false;
  if (f.job.anneal.cold > f.job.anneal.hot) return complain("--cold is above --hot"), false;
  if (!f.priors.empty()) {
    core::Result<scene::Priors> priors = session::open_priors(f.priors);
    if (!priors) return fail(f.priors, priors.error()), false;
    f.job.anneal.weights.learned = priors->weights;
    f.job.priors = std::move(*priors);
  }
  for (const std::string& text : f.weights) {
    const std::size_t equals = text.find('=');
    double value = -1;
    const char *first = text.data() + std::min(equals, text.size() - 1) + 1, *last = text.data() + text.size();
    const auto read = std::from_chars(first, last, value);
    if (equals == std::string::npos || read.ec != std::errc{} || read.ptr != last || !(value >= 0))
      return complain("--weight " + text + " is not NAME=VALUE with a value of 0 or more"), false;
    if (const core::Status s = session::set_weight(f.job.anneal.weights, text.substr(0, equals), value); !s)
      return fail("--weight", s.error()), false;
  }
  return true;
}

int run(Furnish& f) {
  if (!names_are_good(f) || !read_priors(f)) return kError;
  layout::Options& layout = f.job.layout;
  layout.scheme = f.scheme == "averaged" ? layout::Scheme::averaged : layout::Scheme::gauss_seidel;
  layout.start = f.start == "random"   ? layout::Start::random
                 : f.start == "placed" ? layout::Start::placed
                                       : layout::Start::given;
  layout.relocation = !f.no_relocation;
  layout.trace = !f.trace.empty();
  if (f.iterations > 0) {
    f.job.anneal.iterations = f.iterations;
    layout.max_iterations = static_cast<int>(std::min<std::int64_t>(f.iterations, 10000000));
  }
  f.job.anneal.given = layout.start == layout::Start::given && !layout.paper;
  f.job.anneal.paper_moves = layout.paper;
  f.job.anneal.trace_every = f.trace.empty() ? 0 : std::max<std::int64_t>(64, f.iterations / 400);
  const std::optional<session::Document> document = open(f.scene, f.quiet);
  if (!document) return kError;
  if (!f.out.empty())
    if (const core::Result<std::string> possible = session::write_document(*document, f.out); !possible)
      return fail(f.out, possible.error());

  const Interruptible interruptible;
  layout.cancel = interruptible.cancel();
  core::Result<session::Furnished> furnished = [&] {
    ProgressLine line(!f.quiet && !f.json);
    layout.progress = line.reporter();
    return session::furnish_job(*document, f.job);
  }();
  layout.progress = nullptr;
  if (!furnished) return fail(f.scene.name, furnished.error());
  if (!write_scenes(f, *document, *furnished) || !write_pictures(f, *document, *furnished) ||
      !write_trace(f, *furnished))
    return kError;
  // Written files and a quiet run would hide it.
  for (const session::FurnishedRoom& room : furnished->rooms)
    if (room.error) complain(f.scene.name + ": " + room.name + " is left as it was: " + room.error->text());
  if (f.json)
    print(session::furnish_json(*furnished, f.out.empty()));
  else if (!f.quiet)
    print(session::furnish_text(*furnished));
  return furnished->as_asked() ? kDone : kInfeasible;
}

}  // namespace

std::function<int()> set_up_furnish(CLI::App& verb) {
  const auto f = std::make_shared<Furnish>();
  add_scene(verb, f->scene);
  add_output(verb, *f);
  add_method(verb, *f);
  add_annealing(verb, *f);
  verb.footer(kFooter);
  return [f] { return run(*f); };
}

}  // namespace inhabit::app
