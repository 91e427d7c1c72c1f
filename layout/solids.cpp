#include "layout/solids.h"

namespace inhabit::layout {
namespace {

std::vector<Solid> placed(const Scene& scene) {
  std::vector<Solid> list;
  list.reserve(scene.objects.size());
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const Object& o = scene.objects[i];
    if (!o.position) continue;
    const Pose pose{o.position->xy(), o.angle.value_or(0)};
    list.push_back({i, make_box(pose, o.size), o.position->z, o.position->z + o.size.z});
  }
  return list;
}

std::vector<Bounds> bounds_of(const std::vector<Solid>& list) {
  std::vector<Bounds> all;
  all.reserve(list.size());
  for (const Solid& solid : list) all.push_back(bounds(solid.box));
  return all;
}

Floor floor_of(const Space& space) {
  std::vector<Ring> holes;
  for (const Hole& hole : space.holes) holes.push_back(hole.outline);
  return make_floor(space.outline, std::move(holes));
}

}  // namespace

Solids::Solids(const Scene& s)
    : scene(s), floor(floor_of(s.space)), relations(s), list(placed(s)), grid(bounds_of(list)) {}

}  // namespace inhabit::layout
