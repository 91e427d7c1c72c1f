#include <algorithm>

#include "layout/compile_parts.h"
#include "layout/furnish.h"

namespace inhabit::layout {
namespace {

void find_followers(Problem& p) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto follows = [&](const Anchor& upper, const Anchor& lower) {
    if (upper.group() || lower.group() || upper.body == lower.body || p.data.bodies[upper.body].w <= 0) return;
    pairs.emplace_back(lower.body, upper.body);
  };
  for (const StackingTerm& c : p.of<StackingTerm>()) follows(c.upper, c.lower);
  for (const CenterTerm& c : p.of<CenterTerm>()) {
    if (c.on && c.target == CenterTerm::Target::point && c.members.size() == 1) follows(c.members.front(), *c.on);
  }
  p.followers = Lists<std::uint32_t>(p.data.bodies.size(), pairs);
}

/// Which terms and zones concern each body.
void index_terms(Problem& p) {
  std::vector<std::vector<TermId>> lists(p.data.bodies.size());
  std::uint32_t type = 0;
  for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
    const auto& list = p.of<T>();
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      anchors(list[i], [&](const Anchor& a) {
        const auto note = [&](std::uint32_t b) {
          if (lists[b].empty() || lists[b].back() != TermId(type, i)) lists[b].emplace_back(type, i);
        };
        if (!a.group()) return note(a.body);
        for (const std::uint32_t b : p.data.groups[a.index()].bodies) note(b);
      });
    }
    ++type;
  });
  p.touching_first.assign(1, 0);
  for (const auto& list : lists) {
    p.touching.insert(p.touching.end(), list.begin(), list.end());
    p.touching_first.push_back(static_cast<std::uint32_t>(p.touching.size()));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> riding;
  for (std::uint32_t z = 0; z < p.zones.size(); ++z) {
    if (p.zones[z].owner && !p.zones[z].owner->group()) {
      riding.emplace_back(p.zones[z].owner->body, z);
    } else {
      p.room_zones.push_back(z);
    }
  }
  p.zones_of_body = Lists<std::uint32_t>(p.data.bodies.size(), riding);
}

/// Gives back what growing vectors reserved: a large scene's problem lives as long as its document is open.
void trim(Problem& p) {
  for_each_type(TermTypes{},
                [&]<class T>(std::type_identity<T>) { std::get<std::vector<T>>(p.terms).shrink_to_fit(); });
  p.zones.shrink_to_fit(), p.touching.shrink_to_fit(), p.touching_first.shrink_to_fit();
  p.data.bodies.shrink_to_fit(), p.data.boxes.shrink_to_fit(), p.data.riders.shrink_to_fit(), p.start.shrink_to_fit();
  for (GroupData& g : p.data.groups) g.bodies.shrink_to_fit();
  for (CenterTerm& c : std::get<std::vector<CenterTerm>>(p.terms)) c.members.shrink_to_fit(), c.masses.shrink_to_fit();
}

}  // namespace

Result<Problem> compile(const Scene& scene, Origins* origins) {
  Problem p(scene);
  if (const Status s = build_bodies(scene, p); !s) return s.error();
  for (std::size_t b = 0; b < p.data.bodies.size(); ++b) {
    if (p.data.bodies[b].w == 0 && !p.has_start[b]) {
      const Object& o = scene.objects[p.data.boxes[p.data.bodies[b].first_box].object];
      return invalid("/objects/" + std::to_string(p.data.boxes[p.data.bodies[b].first_box].object),
                     "\"" + o.id + "\" is fixed but has no position");
    }
  }
  expand_constraints(scene, p, origins);
  index_terms(p);
  find_followers(p);
  trim(p);
  return p;
}

Placement placement_of(const Problem& p, const State& x) {
  Placement out;
  out.objects.resize(p.scene->objects.size());
  for (std::uint32_t i = 0; i < out.objects.size(); ++i) {
    const Box& b = x.boxes[p.box_of_object[i]];
    const BoxData& d = p.data.boxes[p.box_of_object[i]];
    out.objects[i] = {{b.center.x, b.center.y, p.base_of_object[i]}, wrap_angle(x.bodies[d.body].angle + d.turn)};
  }
  out.groups.resize(p.scene->groups.size());
  for (std::uint32_t g = 0; g < out.groups.size(); ++g) {
    const std::uint32_t body = p.body_of_group[g];
    out.groups[g] = body != kNone ? Pose{x.bodies[body].p, x.bodies[body].angle} : x.frames[g];
  }
  return out;
}

}  // namespace inhabit::layout
