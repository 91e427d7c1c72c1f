#include "session/pictures.h"

#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/trajectory_document.h"

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
  session::TrajectoryOpenOptions trajectories;
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

int convert_trajectories(const Convert& c) {
  const std::string& name = c.scene.name;
  if (!c.scene.rooms.empty() || !c.scene.options.asset_database.empty() || c.scene.options.line != 0)
    return fail(name, core::invalid("", "holds trajectories: --room, --assets and --line are for scenes"));
  if (const core::Status possible = session::can_save_trajectories(c.out); !possible)
    return fail(c.out, possible.error());
  const core::Result<scene::Trajectories> trajectories = session::open_trajectories(name, c.trajectories);
  if (!trajectories) return fail(name, trajectories.error());
  if (!c.quiet)
    for (const std::string& remark : trajectories->remarks) complain(name + ": " + remark);
  const core::Status saved = session::save_trajectories(*trajectories, c.out);
  return saved ? kDone : fail(c.out, saved.error());
}

int run(const Convert& c) {
  if (session::holds_trajectories(c.scene.name)) return convert_trajectories(c);
  if (!c.trajectories.empty())
    return fail(c.scene.name, core::invalid("", "holds no trajectories: --unit, --fps and --homography are for those"));
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
  verb.get_option("SCENE")->description("A file of any format below, or the name of a built-in scene");
  add_trajectory_options(verb, c->trajectories);
  verb.add_option("OUT", c->out, "File to write; its extension says the format")->required();
  verb.add_flag("-q,--quiet", c->quiet, "No warnings");
  verb.footer(
      session::formats_text() +
      "\nExamples:\n  inhabit convert home.sh3d room.json --room Bedroom\n  inhabit convert room.json room.sh3d\n"
      "  inhabit convert bo-360-090-090.txt run.h5 --unit cm --fps 16");
  return [c] { return run(*c); };
}

}  // namespace inhabit::app
