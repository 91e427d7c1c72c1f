#pragma once
#include "core/rng.h"
#include "layout/contacts.h"
#include "layout/furnish.h"

/// For tests only: scenes in a few words, and the solver's view of them.
namespace inhabit::layout::testing {

inline Scene empty_room(double width, double depth) {
  Scene scene;
  scene.space.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  return scene;
}

/// An object of mass 1 without a position.
inline Ref add(Scene& scene, std::string id, Vec3 size) {
  Object o;
  o.id = std::move(id), o.size = size, o.mass = 1;
  scene.objects.push_back(std::move(o));
  return {Ref::Kind::object, static_cast<std::uint32_t>(scene.objects.size() - 1)};
}

/// The same standing at `p`, its front along `angle` (degrees).
inline Ref add(Scene& scene, std::string id, Vec3 size, Vec2 p, double angle = 90) {
  const Ref r = add(scene, std::move(id), size);
  scene.objects[r.index].position = Vec3{p.x, p.y, 0};
  scene.objects[r.index].angle = radians(angle);
  return r;
}

inline Ref add_group(Scene& scene, std::string id, std::vector<Ref> members, bool rigid = false) {
  Group g;
  g.id = std::move(id), g.members = std::move(members), g.rigid = rigid;
  scene.groups.push_back(std::move(g));
  return {Ref::Kind::group, static_cast<std::uint32_t>(scene.groups.size() - 1)};
}

inline Ref add_door(Scene& scene, int wall, double from, double width, Door::Swing swing = Door::Swing::in) {
  Door d;
  d.id = "door", d.wall = wall, d.from = from, d.width = width, d.swing = swing;
  scene.space.doors.push_back(d);
  return {Ref::Kind::door, static_cast<std::uint32_t>(scene.space.doors.size() - 1)};
}

inline Members list_of(std::vector<Ref> refs) { return {std::move(refs), {}}; }

/// A scene made ready for the solver, with everything where the scene says.
struct Ready {
  Scene scene;
  Problem problem;
  State x;

  explicit Ready(Scene s) : scene(std::move(s)), problem(*compile(scene)), x(problem.data, problem.room) {
    for (std::uint32_t b = 0; b < problem.data.bodies.size(); ++b)
      x.place(b, problem.start[b].p, problem.start[b].angle);
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  const Box& box(Ref r) const { return x.boxes[problem.box_of_object[r.index]]; }
  Vec2 at(Ref r) const { return box(r).center; }
  void project_zones(bool sphere = false) {
    Contacts contacts(problem);
    contacts.refresh(x);
    Direct sink{x};
    contacts.project_zones(x, std::vector<double>(problem.slots.size(), 1.0), sphere, sink);
  }
  void project_collisions(double k = 1) {
    Contacts contacts(problem);
    contacts.refresh(x);
    Direct sink{x};
    contacts.project_collisions(x, k, sink);
  }
};

}  // namespace inhabit::layout::testing
