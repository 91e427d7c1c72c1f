#include <algorithm>

#include "layout/compile_parts.h"

namespace inhabit::layout {
namespace {

/// Height of every base: given, on what carries it, or by its mount.
Status set_bases(const Scene& scene, Problem& p) {
  const std::size_t n = scene.objects.size();
  std::vector<Ref> carrier(n);
  for (std::size_t i = 0; i < n; ++i) carrier[i] = scene.objects[i].on;
  for (const auto& c : scene.constraints.of<scene::Stacking>()) {
    if (c.object.kind == Ref::Kind::object && c.on.kind == Ref::Kind::object) carrier[c.object.index] = c.on;
  }
  p.base_of_object.assign(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::size_t> chain;
    for (std::size_t k = i; p.base_of_object[k] < 0;) {
      if (std::ranges::find(chain, k) != chain.end())
        return invalid("/objects/" + std::to_string(i),
                       "\"" + scene.objects[i].id + "\" stands on itself, by way of what carries it");
      chain.push_back(k);
      const Object& o = scene.objects[k];
      if (o.position || o.elevation || carrier[k].kind != Ref::Kind::object) break;
      k = carrier[k].index;
    }
    for (auto k = chain.rbegin(); k != chain.rend(); ++k) {
      const Object& o = scene.objects[*k];
      double z = o.position ? o.position->z : o.elevation.value_or(0);
      if (o.position || o.elevation) {
        // Given.
      } else if (carrier[*k].kind == Ref::Kind::object) {
        const std::size_t c = carrier[*k].index;
        z = p.base_of_object[c] + scene.objects[c].size.z;
      } else if (o.mount == Mount::ceiling) {
        z = std::max(0.0, scene.space.height - o.size.z);
      } else if (o.mount == Mount::wall) {
        z = std::max(0.0, std::min(1.2, scene.space.height - o.size.z));
      }
      p.base_of_object[*k] = std::max(0.0, z);
    }
  }
  return Done{};
}

/// The outermost rigid group that holds each object, or none.
std::vector<std::uint32_t> rigid_owner(const Scene& scene) {
  std::vector<std::uint32_t> of_object(scene.objects.size(), kNone), parent(scene.groups.size(), kNone);
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
    for (const Ref m : scene.groups[g].members) {
      if (m.kind == Ref::Kind::group) parent[m.index] = g;
    }
  }
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
    for (const Ref m : scene.groups[g].members) {
      if (m.kind != Ref::Kind::object) continue;
      std::size_t steps = 0;
      for (std::uint32_t k = g; k != kNone && steps <= scene.groups.size(); k = parent[k], ++steps) {
        if (scene.groups[k].rigid) of_object[m.index] = k;
      }
    }
  }
  return of_object;
}

/// Objects that stand centred on each other move as one: the lowest of each stack, or the object itself. Pinned objects
/// and members of rigid groups are held by the stacking constraint's projection instead. Requires: no stack contains
/// itself.
std::vector<std::uint32_t> stack_bottom(const Scene& scene, const std::vector<std::uint32_t>& rigid) {
  std::vector<std::uint32_t> below(scene.objects.size());
  for (std::uint32_t i = 0; i < below.size(); ++i) below[i] = i;
  const auto free = [&](Ref r) {
    return r.kind == Ref::Kind::object && rigid[r.index] == kNone && !scene.objects[r.index].fixed &&
           scene.objects[r.index].lock == Lock::none;
  };
  for (const auto& c : scene.constraints.of<scene::Stacking>()) {
    if (!c.anywhere && free(c.object) && free(c.on)) below[c.object.index] = c.on.index;
  }
  for (std::uint32_t i = 0; i < below.size(); ++i) {
    while (below[below[i]] != below[i]) below[i] = below[below[i]];
  }
  return below;
}

class BodyBuilder {
 public:
  BodyBuilder(const Scene& scene, Problem& p)
      : scene_(scene), p_(p), rigid_(rigid_owner(scene)), bottom_(stack_bottom(scene, rigid_)) {}

  Status run() {
    p_.body_of_object.resize(scene_.objects.size());
    p_.box_of_object.resize(scene_.objects.size());
    p_.body_of_group.assign(scene_.groups.size(), kNone);
    std::vector<std::vector<std::uint32_t>> members(scene_.groups.size()), stacks(scene_.objects.size());
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      if (rigid_[i] != kNone) members[rigid_[i]].push_back(i);
      if (bottom_[i] != i) stacks[bottom_[i]].push_back(i);
    }
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      if (bottom_[i] != i) continue;
      if (rigid_[i] == kNone) {
        stack(i, stacks[i]);
      } else if (members[rigid_[i]].front() == i) {
        if (const Status s = compound(rigid_[i], members[rigid_[i]]); !s) return s;
      }
    }
    loose_groups();
    return Done{};
  }

 private:
  double mass(const Object& o) const { return o.mass.value_or(std::max(1e-9, o.size.x * o.size.y * o.size.z)); }

  void add_box(std::uint32_t i, std::uint32_t body, Vec2 offset, double turn) {
    const Object& o = scene_.objects[i];
    BoxData b;
    b.body = body, b.object = i, b.offset = offset, b.turn = turn;
    b.half_depth = o.size.y / 2, b.half_width = o.size.x / 2;
    b.radius = std::sqrt(b.half_depth * b.half_depth + b.half_width * b.half_width);
    b.low = p_.base_of_object[i], b.high = b.low + o.size.z;
    p_.box_of_object[i] = static_cast<std::uint32_t>(p_.data.boxes.size());
    p_.body_of_object[i] = body;
    p_.data.boxes.push_back(b);
    BodyData& d = p_.data.bodies[body];
    ++d.boxes;
    d.area += o.size.x * o.size.y;
    d.radius = std::max(d.radius, length(offset) + b.radius);
  }

  void add_body(double mass, bool moves, bool turns, const Pose& pose, bool has_position, bool has_angle) {
    BodyData d;
    d.mass = mass, d.w = moves ? 1 / mass : 0, d.turns = turns;
    d.first_box = static_cast<std::uint32_t>(p_.data.boxes.size());
    p_.data.bodies.push_back(d);
    p_.start.push_back(pose);
    p_.has_start.push_back(has_position);
    p_.has_angle.push_back(has_angle);
  }

  /// An object with what stands centred on it.
  void stack(std::uint32_t i, const std::vector<std::uint32_t>& above) {
    const Object& o = scene_.objects[i];
    const bool pinned = o.fixed || o.lock == Lock::both;
    double total = mass(o);
    for (const std::uint32_t k : above) total += mass(scene_.objects[k]);
    add_body(total, !pinned && o.lock != Lock::position, !pinned && o.lock != Lock::angle,
             {o.position ? o.position->xy() : Vec2{}, o.angle.value_or(0)}, o.position.has_value(),
             o.angle.has_value());
    const auto body = static_cast<std::uint32_t>(p_.data.bodies.size() - 1);
    add_box(i, body, {}, 0);
    for (const std::uint32_t k : above) {
      const auto angle = scene_.objects[k].angle;
      add_box(k, body, {}, o.angle && angle ? wrap_angle(*angle - *o.angle) : 0);
    }
  }

  Status compound(std::uint32_t g, const std::vector<std::uint32_t>& members) {
    const Group& group = scene_.groups[g];
    double total = 0;
    bool pinned = false;
    Bounds extent;
    for (const std::uint32_t i : members) {
      const Object& o = scene_.objects[i];
      if (!o.position || !o.angle)
        return invalid("/groups/" + std::to_string(g),
                       "the rigid group \"" + group.id +
                           "\" takes its shape from its members' positions and angles, and \"" + o.id + "\" has none");
      total += mass(o);
      pinned = pinned || o.fixed || o.lock != Lock::none;
      for (const Vec2 c : make_box({o.position->xy(), *o.angle}, o.size).corners()) extent.add(c);
    }
    const Pose frame{group.position.value_or(extent.center()), group.angle.value_or(0)};
    const auto body = static_cast<std::uint32_t>(p_.data.bodies.size());
    add_body(total, !pinned, !pinned, frame, group.position.has_value() || pinned,
             group.position.has_value() || pinned);
    const Vec2 r = direction(frame.angle);
    for (const std::uint32_t i : members) {
      const Object& o = scene_.objects[i];
      add_box(i, body, rotate_back(o.position->xy() - frame.p, r), wrap_angle(*o.angle - frame.angle));
    }
    mark(g, body);
    return Done{};
  }

  void mark(std::uint32_t g, std::uint32_t body) {
    p_.body_of_group[g] = body;
    for (const Ref m : scene_.groups[g].members) {
      if (m.kind == Ref::Kind::group) mark(m.index, body);
    }
  }

  void loose_groups() {
    p_.data.groups.resize(scene_.groups.size());
    for (std::uint32_t g = 0; g < scene_.groups.size(); ++g) {
      if (p_.body_of_group[g] != kNone) continue;
      GroupData& data = p_.data.groups[g];
      gather(g, data.bodies);
      std::ranges::sort(data.bodies);
      data.bodies.erase(std::unique(data.bodies.begin(), data.bodies.end()), data.bodies.end());
      bool moves = true;
      for (const std::uint32_t b : data.bodies)
        data.mass += p_.data.bodies[b].mass, moves = moves && p_.data.bodies[b].w > 0;
      data.w = moves && data.mass > 0 ? 1 / data.mass : 0;
    }
  }

  void gather(std::uint32_t g, std::vector<std::uint32_t>& bodies) {
    for (const Ref m : scene_.groups[g].members) {
      if (m.kind == Ref::Kind::object) bodies.push_back(p_.body_of_object[m.index]);
      if (m.kind == Ref::Kind::group) gather(m.index, bodies);
    }
  }

  const Scene& scene_;
  Problem& p_;
  std::vector<std::uint32_t> rigid_, bottom_;
};

}  // namespace

Status build_bodies(const Scene& scene, Problem& problem) {
  if (const Status s = set_bases(scene, problem); !s) return s;
  return BodyBuilder(scene, problem).run();
}

}  // namespace inhabit::layout
