#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/jobs.h"

namespace inhabit::app {
namespace {

struct Check {
  SceneArgument scene;
  layout::CheckOptions options;
  std::string metrics;
  bool json = false, quiet = false;
};

constexpr const char* kFooter =
    "Depths are metres, shares 0 to 1, residuals metres or degrees. Exit code 1: something overlaps or stands "
    "outside,\nor a constraint is not kept (by more than 5 cm or 5 degrees) in a scene without \"house_rules\".\n"
    "Examples:\n"
    "  inhabit check room.json\n"
    "  inhabit check home.sh3d --json --metrics published";

int run(Check& c) {
  c.options.published = c.metrics == "published";
  const std::optional<session::Document> document = open(c.scene, c.quiet || c.json);
  if (!document) return kError;
  const session::Checked checked = session::check_job(*document, c.options);
  if (c.json)
    print(session::check_json(checked));
  else if (!c.quiet)
    print(session::check_text(checked));
  return checked.as_asked() ? kDone : kInfeasible;
}

}  // namespace

std::function<int()> set_up_check(CLI::App& verb) {
  const auto c = std::make_shared<Check>();
  add_scene(verb, c->scene);
  verb.add_option("--metrics", c->metrics, "published: add the measures of the literature, computed as it does")
      ->check(CLI::IsMember({"published"}));
  verb.add_flag("--all-collisions", c->options.all_collisions, "Also count overlaps that the scene switches off");
  verb.add_option("--threads", c->options.threads, "Threads, 0 = all there are")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb.add_flag("--json", c->json, "One JSON object on standard output and nothing else there");
  verb.add_flag("-q,--quiet", c->quiet, "The exit code alone");
  verb.footer(kFooter);
  return [c] { return run(*c); };
}

}  // namespace inhabit::app
