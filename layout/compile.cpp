#include <algorithm>

#include "layout/constraints/collision.h"
#include "layout/furnish.h"
#include "layout/problem.h"

namespace inhabit::layout {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Turns the document's constraints into terms: the `Out` of layout/constraint.h.
class Expansion {
 public:
  Expansion(const Scene& scene, Problem& problem) : scene_(scene), p_(problem) { link_partners(); }

  Anchor anchor(Ref r) const {
    if (r.kind == Ref::Kind::object) {
      const BoxData& b = p_.data.boxes[p_.box_of_object[r.index]];
      return ride(b.body, b.offset, b.turn);
    }
    const std::uint32_t body = p_.body_of_group[r.index];
    return body != kNone ? Anchor{body} : Anchor{r.index | Anchor::kGroup};
  }
  /// Like anchor(), for a rigid group at the centre of its bounding box.
  Anchor face_anchor(Ref r) const {
    return r.kind == Ref::Kind::group ? ride(anchor(r).body, group_bounds(r.index).center(), 0) : anchor(r);
  }
  Anchor ride(std::uint32_t body, Vec2 offset, double turn) const {
    if (offset == Vec2{} && turn == 0) return {body};
    p_.data.riders.push_back({offset, turn});
    return {body, static_cast<std::uint32_t>(p_.data.riders.size() - 1)};
  }
  std::vector<Ref> members(const Members& m) const {
    return m.all_of.none() ? m.list : scene_.groups[m.all_of.index].members;
  }
  /// Objects only; groups are replaced by the objects in them.
  std::vector<Ref> objects(const Members& m) const {
    std::vector<Ref> list;
    for (const Ref r : members(m)) collect(r, list);
    return list;
  }
  /// Objects and rigid groups; a group that is not rigid is replaced by its members.
  std::vector<Ref> solid_members(const Members& m) const {
    std::vector<Ref> list, todo = members(m);
    while (!todo.empty()) {
      const Ref r = todo.front();
      todo.erase(todo.begin());
      if (r.kind == Ref::Kind::group && p_.body_of_group[r.index] == kNone) {
        const auto& inner = scene_.groups[r.index].members;
        todo.insert(todo.begin(), inner.begin(), inner.end());
      } else {
        list.push_back(r);
      }
    }
    return list;
  }
  std::vector<Ref> all_objects() const {
    std::vector<Ref> list;
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) list.push_back({Ref::Kind::object, i});
    return list;
  }
  Vec3 size(Ref r) const {
    if (r.kind == Ref::Kind::object) return scene_.objects[r.index].size;
    const Vec2 s = group_bounds(r.index).size();
    return {s.y, s.x, 0};  // width is across the front, which looks along x
  }
  double mass(Ref r) const {
    if (r.kind == Ref::Kind::group) return group_sum(r, [this](Ref o) { return mass(o); });
    const Object& o = scene_.objects[r.index];
    return o.mass.value_or(std::max(1e-9, o.size.x * o.size.y * o.size.z));
  }
  double footprint(Ref r) const {
    if (r.kind == Ref::Kind::group) return group_sum(r, [this](Ref o) { return footprint(o); });
    return std::max(1e-9, scene_.objects[r.index].size.x * scene_.objects[r.index].size.y);
  }
  std::optional<View> view(Ref r) const { return scene_.objects[r.index].view; }
  Vec2 door_middle(Ref r) const {
    const Door& d = scene_.space.doors[r.index];
    const Wall& w = p_.room.walls()[static_cast<std::size_t>(d.wall)];
    return w.a + (d.from + d.width / 2) * w.along;
  }
  void hold_to_wall(Ref r) {
    std::vector<Ref> list;
    collect(r, list);
    for (const Ref o : list) p_.data.boxes[p_.box_of_object[o.index]].at_wall = true;
  }
  void collision(const scene::Collision& c) {
    if (c.members.empty()) {
      if (c.mode == 2) p_.collisions = false;
      if (c.mode == 1) set_bit(all_objects(), &BoxData::sphere);
    } else if (c.mode != 0) {
      set_bit(objects(c.members), c.mode == 2 ? &BoxData::off : &BoxData::sphere);
    }
  }

  template <class T>
  void add(T term, Ref a, Ref b) {
    term.slot = slot({T::kTraits.schedule, current_->stiffness.value_or(T::kTraits.stiffness)});
    term.gamma = current_->weight.value_or(T::kTraits.gamma);
    std::size_t type = 0, k = 0;
    for_each_type(TermTypes{}, [&]<class U>(std::type_identity<U>) {
      if constexpr (std::is_same_v<T, U>) type = k;
      ++k;
    });
    p_.origins[type].push_back({type_, a, b});
    std::get<std::vector<T>>(p_.terms).push_back(std::move(term));
  }
  void add_zone(Zone z, Ref owner, const Members& only, const Strength* s) {
    z.slot = slot({Zone::kTraits.schedule, s != nullptr ? s->stiffness.value_or(Zone::kTraits.stiffness) : Zone::kTraits.stiffness});
    z.gamma = s != nullptr ? s->weight.value_or(Zone::kTraits.gamma) : Zone::kTraits.gamma;
    for (const Ref o : objects(only)) z.only.push_back(p_.box_of_object[o.index]);
    if (owner.kind == Ref::Kind::object) {
      z.exempt = linked_[owner.index];
      z.low = p_.base_of_object[owner.index];
      z.high = z.low + std::max(scene_.objects[owner.index].size.z, 0.1);
    }
    std::ranges::sort(z.only);
    std::ranges::sort(z.exempt);
    p_.zones.push_back(std::move(z));
    p_.zone_owner.push_back(owner);
  }

  void run() {
    const auto all = [&]<class K>(std::type_identity<K>) {
      for (const K& c : scene_.constraints.of<K>()) {
        current_ = &c, type_ = K::kName;
        if constexpr (std::is_same_v<K, scene::Collision>) {
          collision(c);
        } else {
          expand(c, *this);
        }
      }
    };
    for_each_type(ConstraintKinds{}, all);
    const Strength defaults;
    current_ = &defaults;
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) object_defaults({Ref::Kind::object, i});
    for (std::uint32_t g = 0; g < scene_.groups.size(); ++g) group_defaults(g);
    for (const Door& d : scene_.space.doors) door_zone(d);
  }

  std::uint32_t slot(StiffnessSlot s) {
    const auto found = std::ranges::find(p_.slots, s);
    if (found != p_.slots.end()) return static_cast<std::uint32_t>(found - p_.slots.begin());
    p_.slots.push_back(s);
    return static_cast<std::uint32_t>(p_.slots.size() - 1);
  }

 private:
  template <class F>
  double group_sum(Ref r, F f) const {
    std::vector<Ref> list;
    collect(r, list);
    double sum = 0;
    for (const Ref o : list) sum += f(o);
    return sum;
  }
  void collect(Ref r, std::vector<Ref>& list) const {
    if (r.kind == Ref::Kind::object) {
      list.push_back(r);
    } else if (r.kind == Ref::Kind::group) {
      for (const Ref m : scene_.groups[r.index].members) collect(m, list);
    }
  }
  /// Bounding box of a rigid group in its particle's frame.
  Bounds group_bounds(std::uint32_t group) const {
    Bounds b;
    std::vector<Ref> list;
    collect({Ref::Kind::group, group}, list);
    for (const Ref o : list) {
      const BoxData& d = p_.data.boxes[p_.box_of_object[o.index]];
      for (const Vec2 c : Box{d.offset, direction(d.turn), d.half_depth, d.half_width}.corners()) b.add(c);
    }
    return b;
  }
  void set_bit(const std::vector<Ref>& list, std::uint64_t BoxData::*set) {
    const std::uint64_t bit = std::uint64_t{1} << (bits_++ % 64);
    for (const Ref o : list) p_.data.boxes[p_.box_of_object[o.index]].*set |= bit;
  }
  void link(Ref a, Ref b) {
    std::vector<Ref> as, bs;
    collect(a, as), collect(b, bs);
    for (const Ref i : as) {
      for (const Ref j : bs) {
        linked_[i.index].push_back(p_.box_of_object[j.index]);
        linked_[j.index].push_back(p_.box_of_object[i.index]);
      }
    }
  }
  /// Objects bound to each other may stand in each other's accessible space: a chair at its table.
  void link_partners() {
    linked_.resize(scene_.objects.size());
    for (const auto& c : scene_.constraints.of<scene::Distance>()) link(c.between[0], c.between[1]);
    for (const auto& c : scene_.constraints.of<scene::FocalDistance>())
      for (const Ref m : members(c.members)) link(m, c.focal);
    for (const auto& c : scene_.constraints.of<scene::Orientation>())
      for (const Ref m : members(c.members)) link(m, c.to);
    for (const auto& c : scene_.constraints.of<scene::Stacking>()) link(c.object, c.on);
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) link({Ref::Kind::object, i}, scene_.objects[i].on);
  }
  void object_defaults(Ref r) {
    const Object& o = scene_.objects[r.index];
    const std::array depth = {o.clearance.back, o.clearance.left, o.clearance.front, o.clearance.right};
    for (int face = 0; face < 4; ++face) add_face_zone(r, face, depth[static_cast<std::size_t>(face)], "accessibility", {}, nullptr, *this);
    const bool stacked = std::ranges::any_of(scene_.constraints.of<scene::Stacking>(), [r](const auto& c) { return c.object == r; });
    if (!o.on.none() && !stacked) {
      scene::Stacking s;
      s.object = r, s.on = o.on, s.anywhere = true;
      type_ = "stacking";
      expand(s, *this);
    }
  }
  void group_defaults(std::uint32_t g) {
    const Group& group = scene_.groups[g];
    if (!group.curve || group.rigid) return;
    CurveTerm term;
    term.group = g, term.curve = *group.curve, term.spacing = group.spacing;
    for (const Ref m : group.members) term.members.push_back(anchor(m));
    type_ = "curve";
    if (!term.members.empty()) add(std::move(term), {Ref::Kind::group, g}, {});
  }
  /// The quarter disc of the leaf as its square, and a person's depth in front of the opening: the larger of the two.
  void door_zone(const Door& d) {
    const Wall& w = p_.room.walls()[static_cast<std::size_t>(d.wall)];
    const double depth = d.swing == Door::Swing::in ? std::max(d.width, 0.6) : 0.6;
    Zone z;
    z.type = "door";
    z.box = {w.a + (d.from + d.width / 2) * w.along + (depth / 2) * w.normal, w.normal, depth / 2, d.width / 2};
    z.radius = z.box.radius();
    z.high = d.height;
    // A door's own object (some scenes furnish one) and what is fixed may stand there.
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      if (scene_.objects[i].kind == "door" || scene_.objects[i].fixed) z.exempt.push_back(p_.box_of_object[i]);
    }
    add_zone(std::move(z), {}, {}, nullptr);
  }

  const Scene& scene_;
  Problem& p_;
  const Strength* current_ = nullptr;
  std::string_view type_;
  int bits_ = 0;
  std::vector<std::vector<std::uint32_t>> linked_;
};

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
        return invalid("/objects/" + std::to_string(i), "\"" + scene.objects[i].id + "\" stands on itself, by way of what carries it");
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

/// Objects that stand centred on each other move as one: the lowest of each stack, or the object itself. Pinned objects and
/// members of rigid groups are held by the stacking constraint's projection instead. Requires: no stack contains itself.
std::vector<std::uint32_t> stack_bottom(const Scene& scene, const std::vector<std::uint32_t>& rigid) {
  std::vector<std::uint32_t> below(scene.objects.size());
  for (std::uint32_t i = 0; i < below.size(); ++i) below[i] = i;
  const auto free = [&](Ref r) {
    return r.kind == Ref::Kind::object && rigid[r.index] == kNone && !scene.objects[r.index].fixed && scene.objects[r.index].lock == Lock::none;
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
             {o.position ? o.position->xy() : Vec2{}, o.angle.value_or(0)}, o.position.has_value(), o.angle.has_value());
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
        return invalid("/groups/" + std::to_string(g), "the rigid group \"" + group.id + "\" takes its shape from its members' positions and angles, and \"" +
                                                           o.id + "\" has none");
      total += mass(o);
      pinned = pinned || o.fixed || o.lock != Lock::none;
      for (const Vec2 c : make_box({o.position->xy(), *o.angle}, o.size).corners()) extent.add(c);
    }
    const Pose frame{group.position.value_or(extent.center()), group.angle.value_or(0)};
    const auto body = static_cast<std::uint32_t>(p_.data.bodies.size());
    add_body(total, !pinned, !pinned, frame, group.position.has_value() || pinned, group.position.has_value() || pinned);
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
      for (const std::uint32_t b : data.bodies) data.mass += p_.data.bodies[b].mass, moves = moves && p_.data.bodies[b].w > 0;
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

void find_followers(Problem& p) {
  p.followers.resize(p.data.bodies.size());
  const auto follows = [&](const Anchor& upper, const Anchor& lower) {
    if (upper.group() || lower.group() || upper.body == lower.body || p.data.bodies[upper.body].w <= 0) return;
    p.followers[lower.body].push_back(upper.body);
  };
  for (const StackingTerm& c : p.of<StackingTerm>()) follows(c.upper, c.lower);
  for (const CenterTerm& c : p.of<CenterTerm>()) {
    if (c.on && c.target == CenterTerm::Target::point && c.members.size() == 1) follows(c.members.front(), *c.on);
  }
}

/// Which terms and zones concern each body.
void index_terms(Problem& p) {
  std::vector<std::vector<TermId>> lists(p.data.bodies.size());
  std::uint16_t type = 0;
  for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
    const auto& list = p.of<T>();
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      anchors(list[i], [&](const Anchor& a) {
        const auto note = [&](std::uint32_t b) {
          if (lists[b].empty() || lists[b].back().type != type || lists[b].back().index != i) lists[b].push_back({type, i});
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
  p.zones_of_body.resize(p.data.bodies.size());
  for (std::uint32_t z = 0; z < p.zones.size(); ++z) {
    if (p.zones[z].owner && !p.zones[z].owner->group()) {
      p.zones_of_body[p.zones[z].owner->body].push_back(z);
    } else {
      p.room_zones.push_back(z);
    }
  }
}

}  // namespace

Result<Problem> compile(const Scene& scene) {
  Problem p(scene);
  if (const Status s = set_bases(scene, p); !s) return s.error();
  if (const Status s = BodyBuilder(scene, p).run(); !s) return s.error();
  for (std::size_t b = 0; b < p.data.bodies.size(); ++b) {
    if (p.data.bodies[b].w == 0 && !p.has_start[b]) {
      const Object& o = scene.objects[p.data.boxes[p.data.bodies[b].first_box].object];
      return invalid("/objects/" + std::to_string(p.data.boxes[p.data.bodies[b].first_box].object),
                     "\"" + o.id + "\" is fixed but has no position");
    }
  }
  Expansion expansion(scene, p);
  p.collision_slot = expansion.slot({pbd::Schedule::increasing, 0.8});
  expansion.run();
  index_terms(p);
  find_followers(p);
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
