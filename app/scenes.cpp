#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/scenes_job.h"

namespace inhabit::app {
namespace {

struct Scenes {
  session::ScenesJob job;
  std::string out;
  bool json = false;
};

int run(const Scenes& s) {
  if (s.job.name.empty()) {
    if (!s.out.empty() || s.job.seats || s.job.coverage || s.job.seed) {
      complain("which scene? inhabit scenes lists them");
      return kError;
    }
    print(s.json ? session::scenes_json() : session::scenes_text());
    return kDone;
  }
  const core::Result<std::string> scene = session::scenes_job(s.job);
  if (!scene) return fail(s.job.name, scene.error());
  if (!s.out.empty()) return save(s.out, scene) ? kDone : kError;
  print(*scene);
  return kDone;
}

}  // namespace

std::function<int()> set_up_scenes(CLI::App& verb) {
  const auto s = std::make_shared<Scenes>();
  verb.add_option("NAME", s->job.name, "Print this scene as JSON; all scenes are listed when absent");
  verb.add_option("-o,--output", s->out, "Write the scene here instead")->type_name("FILE");
  verb.add_option("--seats", s->job.seats, "theater-1: number of seats")->check(CLI::Range(1, 1000000));
  verb.add_option("--coverage", s->job.coverage, "tight-bedroom: share of the floor that is covered, 0.1 to 0.95")
      ->check(CLI::Range(0.1, 0.95));
  verb.add_option("--seed", s->job.seed, "tight-picnic: the seed that its numbers of things are drawn from")
      ->check(not_negative, "");
  verb.add_flag("--json", s->json, "The list as JSON");
  verb.footer("Examples:\n  inhabit scenes\n  inhabit scenes theater-1 --seats 1600 -o theater.json");
  return [s] { return run(*s); };
}

}  // namespace inhabit::app
