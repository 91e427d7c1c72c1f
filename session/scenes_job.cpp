#include "session/scenes_job.h"

#include "core/text.h"
#include "io/formats/scene_json.h"
#include "session/crowd_builder.h"
#include "session/crowd_scenes.h"
#include "session/document.h"
#include "session/exemplar_scenes.h"
#include "session/paper_scenes.h"
#include "session/scene_builder.h"
#include "session/table.h"

namespace inhabit::session {
namespace {

/// What is furnished as the exemplars teach it, and where those are.
void add_learned_scenes(Table& table) {
  for (const ExemplarScene& learned : exemplar_scenes()) {
    for (int k = 1; k <= learned.inputs; ++k) {
      const Scene scene = exemplar_input(learned, k);
      const Vec2 size = bounds(scene.space.outline).size();
      table.rows.push_back({scene.name, static_cast<double>(scene.objects.size()), Cell(), Cell(), size.x, size.y,
                            100 * floor_coverage(scene), learned.seconds, std::string(learned.sentence)});
    }
    const std::string name = "exemplar/" + std::string(learned.name);
    table.notes.push_back(name + ": five furnished rooms to learn from, " + name + "-1 to -" +
                          std::to_string(kExemplars));
  }
}

Table scenes_table() {
  Table table{"scenes", "", {}, {}, {}};
  table.columns = {{"name"},       {"objects", 0},    {"constraints", 0}, {"people", 0}, {"width m", 2},
                   {"depth m", 2}, {"coverage %", 0}, {"paper s", 2},     {"what"}};
  for (const PaperScene& paper : paper_scenes()) {
    const Scene scene = paper.build();
    const Vec2 size = bounds(scene.space.outline).size();
    table.rows.push_back({std::string(paper.name), static_cast<double>(scene.objects.size()),
                          static_cast<double>(scene.constraints.size()), Cell(), size.x, size.y,
                          100 * floor_coverage(scene), paper.published_seconds, std::string(paper.sentence)});
  }
  add_learned_scenes(table);
  for (const CrowdScene& crowd : crowd_scenes()) {
    const Scene scene = crowd.build();
    const Vec2 size = bounds(scene.space.outline).size();
    table.rows.push_back({std::string(crowd.name), Cell(), Cell(), static_cast<double>(people_asked(scene.crowd)),
                          size.x, size.y, Cell(), Cell(), std::string(crowd.sentence)});
  }
  return table;
}

}  // namespace

Result<std::string> scenes_job(const ScenesJob& job) {
  const PaperScene* paper = find_paper_scene(job.name);
  const CrowdScene* crowd = find_crowd_scene(job.name);
  if (!paper && !crowd) {
    std::vector<std::string_view> names;
    for (const BuiltinScene& scene : builtin_scenes()) {
      if (scene.name == job.name && !job.seats && !job.coverage && !job.seed) return std::string(scene.json);
      names.push_back(scene.name);
    }
    return Error{ErrorCode::not_found, "no built-in scene of this name" + did_you_mean(job.name, names), ""};
  }
  if (job.seats && job.name != "theater-1") return invalid("", "only theater-1 has a number of seats");
  if (job.coverage && job.name != "tight-bedroom") return invalid("", "only tight-bedroom has a coverage");
  if (job.seed && job.name != "tight-picnic") return invalid("", "only tight-picnic is drawn from a seed");
  if (job.seats) return io::write_scene(theater_1(*job.seats));
  if (job.coverage) return io::write_scene(tight_bedroom(*job.coverage));
  if (job.seed) return io::write_scene(tight_picnic(*job.seed));
  return io::write_scene(paper ? paper->build() : crowd->build());
}

std::string scenes_text() { return table_text(scenes_table()); }
std::string scenes_json() { return table_json(scenes_table()) + "\n"; }

}  // namespace inhabit::session
