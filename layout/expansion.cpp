#include <algorithm>

#include "layout/compile_parts.h"

namespace inhabit::layout {
namespace {

/// Turns the document's constraints into terms: the `Out` of layout/constraint.h.
class Expansion {
 public:
  Expansion(const Scene& scene, Problem& problem, Origins* origins) : scene_(scene), p_(problem), origins_(origins) {
    link_partners();
  }

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
    std::vector<Ref> list;
    for (const Ref r : members(m)) collect_solid(r, list);
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
    term.slot = slot_of(T::kTraits, *current_);
    std::size_t k = 0;
    for_each_type(TermTypes{}, [&]<class U>(std::type_identity<U>) {
      if (std::is_same_v<T, U> && origins_ != nullptr) (*origins_)[k].push_back({type_, a, b});
      ++k;
    });
    std::get<std::vector<T>>(p_.terms).push_back(std::move(term));
  }
  void add_zone(Zone z, Zone::Details details, Ref owner, const Members& only, const Strength& s) {
    z.slot = slot_of(Zone::kTraits, s);
    for (const Ref o : objects(only)) details.only.push_back(p_.box_of_object[o.index]);
    if (owner.kind == Ref::Kind::object) {
      details.exempt = linked_[owner.index];
      z.low = p_.base_of_object[owner.index];
      z.high = z.low + std::max(scene_.objects[owner.index].size.z, 0.1);
    }
    std::ranges::sort(details.only);
    std::ranges::sort(details.exempt);
    // Zones of one kind follow each other, and those of like objects are alike.
    if (last_details_ && *last_details_ == details) {
      z.details = last_details_;
    } else if (details != Zone::Details{}) {
      z.details = last_details_ = std::make_shared<const Zone::Details>(std::move(details));
    }
    p_.zones.push_back(std::move(z));
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

  std::uint32_t slot(Slot s) {
    const auto found = std::ranges::find(p_.slots, s);
    if (found != p_.slots.end()) return static_cast<std::uint32_t>(found - p_.slots.begin());
    p_.slots.push_back(s);
    return static_cast<std::uint32_t>(p_.slots.size() - 1);
  }

 private:
  std::uint32_t slot_of(const TermTraits& traits, const Strength& s) {
    return slot({traits.schedule, s.stiffness.value_or(traits.stiffness), s.weight.value_or(traits.gamma)});
  }
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
  void collect_solid(Ref r, std::vector<Ref>& list) const {
    if (r.kind == Ref::Kind::group && p_.body_of_group[r.index] == kNone) {
      for (const Ref m : scene_.groups[r.index].members) collect_solid(m, list);
    } else {
      list.push_back(r);
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
    int& used = set == &BoxData::off ? off_sets_ : sphere_sets_;
    const bool overflow = used >= Problem::kOverflowSet;
    const std::uint64_t bit = std::uint64_t{1} << (overflow ? Problem::kOverflowSet : used++);
    for (const Ref o : list) p_.data.boxes[p_.box_of_object[o.index]].*set |= bit;
    if (!overflow || set != &BoxData::off) return;
    for (const Ref o : list) {
      for (const Ref q : list) p_.off_pairs.emplace_back(p_.box_of_object[o.index], p_.box_of_object[q.index]);
    }
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
    for (int face = 0; face < 4; ++face)
      add_face_zone(r, face, depth[static_cast<std::size_t>(face)], {}, *current_, *this);
    const bool stacked =
        std::ranges::any_of(scene_.constraints.of<scene::Stacking>(), [r](const auto& c) { return c.object == r; });
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
    z.box = {w.a + (d.from + d.width / 2) * w.along + (depth / 2) * w.normal, w.normal, depth / 2, d.width / 2};
    z.radius = z.box.radius();
    z.high = d.height;
    // A door's own object (some scenes furnish one) and what is fixed may stand there.
    Zone::Details details;
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      if (scene_.objects[i].kind == "door" || scene_.objects[i].fixed) details.exempt.push_back(p_.box_of_object[i]);
    }
    add_zone(std::move(z), std::move(details), {}, {}, *current_);
  }

  const Scene& scene_;
  Problem& p_;
  Origins* origins_;
  const Strength* current_ = nullptr;
  std::string_view type_;
  int off_sets_ = 0, sphere_sets_ = 0;
  std::vector<std::vector<std::uint32_t>> linked_;
  std::shared_ptr<const Zone::Details> last_details_;
};

}  // namespace

void expand_constraints(const Scene& scene, Problem& problem, Origins* origins) {
  Expansion expansion(scene, problem, origins);
  problem.collision_slot = expansion.slot({pbd::Schedule::increasing, 0.8, problem.collision_gamma});
  expansion.run();
  std::ranges::sort(problem.off_pairs);
}

}  // namespace inhabit::layout
