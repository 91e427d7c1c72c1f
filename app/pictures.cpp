#include "session/pictures.h"

#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"

namespace inhabit::app {
namespace {

struct Render {
  SceneArgument scene;
  std::string out;
  session::PictureOptions options;
  bool no_labels = false, quiet = false;
};

struct Convert {
  SceneArgument scene;
  std::string out;
  bool quiet = false;
};

int run(Render& r) {
  if (const core::Status good = session::check_picture_name(r.out); !good) return fail(r.out, good.error());
  r.options.labels = !r.no_labels;
  const std::optional<session::Document> document = open(r.scene, r.quiet);
  if (!document) return kError;
  return save(r.out, session::plan_picture(*document, r.out, r.options)) ? kDone : kError;
}

int run(const Convert& c) {
  const std::optional<session::Document> document = open(c.scene, c.quiet);
  if (!document) return kError;
  return save(c.out, session::write_document(*document, c.out)) ? kDone : kError;
}

}  // namespace

std::function<int()> set_up_render(CLI::App& verb) {
  const auto r = std::make_shared<Render>();
  add_scene(verb, r->scene);
  verb.add_option("-o,--output", r->out, "Picture: .svg, .png or .pdf")->type_name("FILE")->required();
  verb.add_option("--pixels", r->options.pixels, "Long side of a PNG, pixels")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  verb.add_flag("--no-labels", r->no_labels, "No names");
  verb.add_flag("--clearances", r->options.clearances, "Draw the free depth wanted before faces");
  verb.add_flag("--views", r->options.views, "Draw view cones");
  verb.add_flag("--door-zones", r->options.door_zones, "Draw what the doors sweep");
  verb.add_flag("--problems", r->options.problems, "Mark overlaps, what stands outside, blocked doors and clearances");
  verb.add_flag("-q,--quiet", r->quiet, "No warnings");
  verb.footer(
      "Examples:\n  inhabit render living-room -o room.svg\n  inhabit render room.json -o room.png --pixels 3000 "
      "--problems");
  return [r] { return run(*r); };
}

std::function<int()> set_up_convert(CLI::App& verb) {
  const auto c = std::make_shared<Convert>();
  add_scene(verb, c->scene);
  verb.add_option("OUT", c->out, "File to write; its extension says the format")->required();
  verb.add_flag("-q,--quiet", c->quiet, "No warnings");
  verb.footer("Examples:\n  inhabit convert home.sh3d room.json --room Bedroom\n  inhabit convert room.json room.sh3d");
  return [c] { return run(*c); };
}

}  // namespace inhabit::app
