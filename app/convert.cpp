#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/trajectory_document.h"

namespace inhabit::app {
namespace {

struct Convert {
  SceneArgument scene;
  session::TrajectoryOpenOptions trajectories;
  std::string out;
  bool quiet = false;
};

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
