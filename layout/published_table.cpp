#include <algorithm>

#include "geometry/polygon.h"
#include "layout/published_metrics.h"
#include "layout/solids.h"

/// All published measures of a scene in one table.
namespace inhabit::layout {
namespace {

struct Table {
  PublishedMetrics result;
  void add(std::string_view source, std::string_view name, std::optional<double> value, std::string_view unit = "") {
    result.measures.push_back({std::string(source), std::string(name), value, std::string(unit)});
  }
  /// A share of `all`, nothing of nothing.
  void rate(std::string_view source, std::string_view name, std::size_t part, std::size_t all) {
    add(source, name, all == 0 ? std::nullopt : std::optional(static_cast<double>(part) / static_cast<double>(all)));
  }
};

/// The objects among the members, those of one group named as a whole included.
std::vector<std::uint32_t> objects_of(const Scene& scene, const Members& members) {
  std::vector<Ref> refs = members.list;
  if (members.all_of.kind == Ref::Kind::group) {
    const auto& list = scene.groups[members.all_of.index].members;
    refs.insert(refs.end(), list.begin(), list.end());
  }
  std::vector<std::uint32_t> objects;
  for (const Ref ref : refs)
    if (ref.kind == Ref::Kind::object) objects.push_back(ref.index);
  return objects;
}

/// Distance between the surfaces of a box in the room and its nearest wall.
double wall_gap(const Scene& scene, const Box& box) {
  double gap = 1e300;
  for (const Vec2 corner : box.corners()) gap = std::min(gap, nearest_on_ring(scene.space.outline, corner).distance);
  return gap;
}

/// 4.1 Relations that the scene's own constraints ask for: at a wall, and facing something.
void relations(const Solids& solids, Table& table) {
  const Scene& scene = solids.scene;
  std::vector<const Solid*> solid_of(scene.objects.size(), nullptr);
  for (const Solid& solid : solids.list) solid_of[solid.object] = &solid;
  std::size_t walls = 0, at_wall = 0, faces = 0, facing = 0;
  for (const WallDistance& c : scene.constraints.of<WallDistance>()) {
    if (c.distance > 0.3) continue;  // not "against" the wall
    for (const std::uint32_t i : objects_of(scene, c.members)) {
      ++walls;
      at_wall += solid_of[i] != nullptr &&
                 sceneeval_relation(Relation::against_wall, wall_gap(scene, solid_of[i]->box)) >= 0.5;
    }
  }
  for (const Orientation& c : scene.constraints.of<Orientation>()) {
    if (c.relative != 0 || c.angle != 0 || c.to.kind != Ref::Kind::object) continue;
    const Solid* to = solid_of[c.to.index];
    for (const std::uint32_t i : objects_of(scene, c.members)) {
      ++faces;
      if (to == nullptr || solid_of[i] == nullptr) continue;
      const Box& box = solid_of[i]->box;
      facing += dot(box.front, unit(to->box.center - box.center)) >= std::cos(core::radians(30));
    }
  }
  table.rate("SceneEval", "against_wall", at_wall, walls);
  table.rate("SceneEval", "face_to", facing, faces);
}

void sceneeval(const Solids& solids, std::uint64_t seed, Table& table) {
  const Scene& scene = solids.scene;
  const std::size_t n = solids.list.size(), colliding = sceneeval_colliding(scene);
  table.rate("SceneEval", "collision_boxes", colliding, n);
  table.add("SceneEval", "collision_scene_boxes", colliding > 0 ? 1 : 0);
  table.rate("SceneEval", "out_of_bound", sceneeval_out_of_bound(scene, seed).size(), n);
  table.add("SceneEval", "navigability", sceneeval_navigability(scene));
  double sum = 0;
  const auto scores = sceneeval_accessibility(scene);
  for (const ObjectScore& s : scores) sum += s.score;
  table.add("SceneEval", "accessibility",
            scores.empty() ? std::nullopt : std::optional(sum / static_cast<double>(scores.size())));
  const auto openings = sceneeval_opening_clearance(scene);
  for (const bool door : {true, false}) {
    const auto of_kind = [&](const OpeningOcclusion& o) { return o.door == door; };
    const auto occluded = [&](const OpeningOcclusion& o) { return o.door == door && o.occluded; };
    table.rate("SceneEval", door ? "doors_occluded" : "windows_occluded",
               static_cast<std::size_t>(std::ranges::count_if(openings, occluded)),
               static_cast<std::size_t>(std::ranges::count_if(openings, of_kind)));
  }
  relations(solids, table);
}

}  // namespace

PublishedMetrics published_metrics(const Scene& scene, std::uint64_t seed) {
  const Solids solids(scene);
  const std::size_t n = solids.list.size();
  Table table;
  table.result.asked = scene.objects.size();
  table.result.placed = n;
  sceneeval(solids, seed, table);

  const PhyScene p = physcene(scene);
  table.rate("PhyScene", "col_obj", p.colliding, n);
  table.add("PhyScene", "col_scene", p.colliding > 0 ? 1 : 0);
  table.rate("PhyScene", "r_out", p.out, n);
  table.add("PhyScene", "walkable", p.walkable);
  table.add("PhyScene", "walkable_physcene_compat", p.walkable_physcene_compat);
  table.add("PhyScene", "walkable_doors", p.walkable_doors);
  table.add("PhyScene", "r_reach", n == 0 ? std::nullopt : std::optional(p.reach));
  const std::size_t beyond = layoutgpt_out_of_bound(scene);
  table.add("LayoutGPT", "oob_scene", beyond > 0 ? 1 : 0);
  const ReSpace r = respace(scene);
  table.add("ReSpace", "oob", r.oob, "m3");
  table.add("ReSpace", "mbl", r.mbl, "m3");
  table.add("ReSpace", "pbl", r.pbl, "m3");
  table.add("ReSpace", "valid", r.pbl <= 0.1 ? 1 : 0);
  const DiffuScene d = diffuscene(scene);
  table.add("DiffuScene", "mean_iou", d.mean_iou);
  table.add("DiffuScene", "intersecting_pairs", d.intersecting);
  table.add("DiffuScene", "symmetric_pairs",
            d.symmetric ? std::optional(static_cast<double>(*d.symmetric)) : std::nullopt);
  table.add("Infinigen", "freespace_2d", infinigen_freespace_2d(scene), "%");

  table.result.left_out = {
      {"SceneEval collision, support and opening clearance on meshes", "a scene holds boxes, not meshes"},
      {"PhyScene and ATISS category KL divergence", "compares sets of scenes"},
      {"LEGO-Net regularity and distance to truth", "needs the integer-relation search and a ground truth"},
      {"InstructScene iRecall, LayoutVLM scores", "need the instruction"},
      {"ProcTHOR reachable points, FID, KID, SCA", "need their own assets or renders"},
      {"Infinigen rotational and reflectional asymmetry", "judge declared sets of like objects"}};
  return std::move(table.result);
}

}  // namespace inhabit::layout
