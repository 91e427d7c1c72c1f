#include <algorithm>

#include "annealing/furniture.h"
#include "geometry/extents.h"

namespace inhabit::annealing {
namespace {

/// A person, as `check` has it: steps over what is flatter than a step, is this tall, asks for this depth at a door.
constexpr double kStepHeight = 0.05, kPersonHeight = 1.9, kPersonDepth = 0.6;
constexpr int kViewParts = 3;  ///< rectangles of a view, as Yu et al. fig. 5c

class Builder {
 public:
  Builder(const Scene& scene, const Targets& targets, Furniture& f) : scene_(scene), targets_(targets), f_(f) {}

  Status run() {
    const std::size_t n = scene_.objects.size();
    f_.apart_.assign(n * n, false), f_.bound_.assign(n * n, false);
    f_.carrier.assign(n, kNobody), f_.carriers.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) add_item(i);
    if (const Status s = add_groups(); !s) return s;
    if (const Status s = check_carriers(); !s) return s;
    if (const Status s = check_sizes(); !s) return s;
    for (std::uint32_t i = 0; i < n; ++i) add_spaces(i);
    for (const PairTarget& pair : targets_.pairs) add_pair(pair);
    add_circles();
    exempt_collisions();
    for (const Door& door : scene_.space.doors) add_door(door);
    add_paths();
    index();
    return Done{};
  }

 private:
  void add_item(std::uint32_t i) {
    const Object& o = scene_.objects[i];
    const ObjectTarget& target = targets_.objects[i];
    Item item;
    item.half_depth = o.size.y / 2, item.half_width = o.size.x / 2, item.height = o.size.z;
    item.radius = std::sqrt(item.half_depth * item.half_depth + item.half_width * item.half_width);
    item.hung = target.mount == Mount::wall;
    const bool pinned = o.fixed || o.lock == Lock::both;
    // "Ceiling fans are fixed" (Yu et al. 5), and so is what hangs on a wall, once it has a place there.
    const bool stays = o.position && (item.hung || target.mount == Mount::ceiling);
    item.moves = !pinned && o.lock != Lock::position && !stays;
    item.turns = !pinned && o.lock != Lock::angle && !stays && !item.hung;
    item.carried = target.carrier != kNobody;
    f_.carrier[i] = target.carrier;
    f_.carriers[i] = target.carriers;
    item.low = base(o, target);
    const auto face = static_cast<std::size_t>(target.back);
    constexpr std::array kTurns = {0.0, -kPi / 2, kPi, kPi / 2};
    item.back_turn = kTurns[face];
    item.back_half = target.back == Face::left || target.back == Face::right ? item.half_width : item.half_depth;
    if (target.wall && !item.hung) {
      item.has_wall = true;
      item.wall_distance = target.wall->distance, item.wall_angle = target.wall->angle;
      item.wall_angle_strength = angle_strength(target.wall->angle_deviation);
    }
    f_.items.push_back(item);
  }

  /// As the position-based solver has it.
  double base(const Object& o, const ObjectTarget& target) const {
    const double room = scene_.space.height;
    if (o.position) return std::max(0.0, o.position->z);
    if (o.elevation) return std::max(0.0, *o.elevation);
    if (target.mount == Mount::ceiling) return std::max(0.0, room - o.size.z);
    if (target.mount != Mount::wall) return 0;
    const double usual = target.prior != nullptr && target.prior->elevation > 0 ? target.prior->elevation : 1.2;
    return std::max(0.0, std::min(usual, room - o.size.z));
  }

  /// Members of a rigid group ride on its first one.
  Status add_groups() {
    for (std::uint32_t g = 0; g < scene_.groups.size(); ++g) {
      if (!scene_.groups[g].rigid) continue;
      std::vector<std::uint32_t> members;
      collect(g, members);
      bool pinned = false;
      for (const std::uint32_t i : members) {
        if (!scene_.objects[i].position || !scene_.objects[i].angle)
          return invalid("/groups/" + std::to_string(g), "the rigid group \"" + scene_.groups[g].id +
                                                             "\" takes its shape from its members' positions and "
                                                             "angles, and \"" +
                                                             scene_.objects[i].id + "\" has none");
        pinned = pinned || scene_.objects[i].fixed || scene_.objects[i].lock != Lock::none;
      }
      for (const std::uint32_t i : members) {
        Item& item = f_.items[i];
        item.carried = false;
        if (pinned) item.moves = item.turns = false;
        if (i != members.front()) item.attached = true, f_.carrier[i] = members.front();
        for (const std::uint32_t j : members) exempt(i, j);
      }
    }
    return Done{};
  }
  void collect(std::uint32_t group, std::vector<std::uint32_t>& members) const {
    for (const Ref m : scene_.groups[group].members) {
      if (m.kind == Ref::Kind::object) members.push_back(m.index);
      if (m.kind == Ref::Kind::group) collect(m.index, members);
    }
  }
  void exempt(std::uint32_t i, std::uint32_t j) {
    const std::size_t n = scene_.objects.size();
    f_.apart_[i * n + j] = f_.apart_[j * n + i] = true;
    bind(i, j);
  }
  void bind(std::uint32_t i, std::uint32_t j) {
    const std::size_t n = scene_.objects.size();
    f_.bound_[i * n + j] = f_.bound_[j * n + i] = true;
  }

  Status check_carriers() const {
    const std::size_t n = scene_.objects.size();
    for (std::uint32_t i = 0; i < n; ++i) {
      std::size_t steps = 0;
      for (std::uint32_t k = i; k != kNobody; k = f_.carrier[k])
        if (++steps > n)
          return invalid("/objects/" + std::to_string(i),
                         "\"" + scene_.objects[i].id + "\" stands on itself, by way of what carries it");
    }
    return Done{};
  }

  Status check_sizes() const {
    const Extents room(scene_.space.outline);
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      const Object& o = scene_.objects[i];
      if (f_.items[i].moves && !f_.items[i].carried && room.too_small_for(o.size.x, o.size.y))
        return invalid("", "\"" + o.id + "\" is larger than the room in every orientation");
      if (o.fixed && !o.position)
        return invalid("/objects/" + std::to_string(i), "\"" + o.id + "\" is fixed but has no position");
    }
    return Done{};
  }

  void add_space(Space space) {
    space.radius = space.local.radius();
    f_.spaces.push_back(space);
  }

  void add_spaces(std::uint32_t i) {
    const Item& item = f_.items[i];
    const ObjectTarget& target = targets_.objects[i];
    const double hd = item.half_depth, hw = item.half_width;
    Space space;
    space.owner = i;
    space.low = kStepHeight, space.high = std::max(item.height, kPersonHeight);
    for (std::size_t face = 0; face < 4; ++face) {
      const double h = target.access[face] / 2;
      if (h <= 0) continue;
      const bool side = face == 1 || face == 3;
      const double away = (side ? hw : hd) + h;
      constexpr std::array<Vec2, 4> kOutward = {Vec2{-1, 0}, Vec2{0, 1}, Vec2{1, 0}, Vec2{0, -1}};
      space.local = {away * kOutward[face], {1, 0}, side ? hd : h, side ? h : hw};
      add_space(space);
    }
    if (!target.view || target.view->distance <= 0 || target.view->angle <= 0) return;
    space.kind = Space::Kind::view;
    space.low = 0, space.high = item.height;
    const double part = target.view->distance / kViewParts;
    // Together they hold the whole cone, whose sides `check` looks at, too: each is as wide as the cone at its far end.
    const SinCos half = sin_cos(std::min(target.view->angle / 2, 1.4));
    for (int k = 0; k < kViewParts; ++k) {
      const double widest = std::min((k + 1) * part * half.sin / half.cos, target.view->distance * half.sin);
      space.local = {{hd + (k + 0.5) * part, 0}, {1, 0}, part / 2, widest};
      add_space(space);
    }
  }

  void add_pair(const PairTarget& pair) {
    Relation r{pair.first, pair.second, pair.mode.distance, pair.mode.bearing, pair.mode.facing};
    r.bearing_strength = pair.concentric ? 0 : angle_strength(pair.mode.bearing_deviation);
    r.facing_strength = angle_strength(pair.mode.facing_deviation);
    f_.relations.push_back(r);
    bind(pair.first, pair.second);
  }

  void add_circles() {
    for (const PairTarget& pair : targets_.pairs) {
      if (!pair.concentric) continue;
      const auto same = [&](const Circle& c) { return c.first == pair.first; };
      auto found = std::ranges::find_if(f_.circles, same);
      if (found == f_.circles.end()) found = f_.circles.insert(f_.circles.end(), {pair.first, {}});
      found->seconds.push_back(pair.second);
    }
    std::erase_if(f_.circles, [](const Circle& c) { return c.seconds.size() < 2; });
  }

  void exempt_collisions() {
    for (const Collision& c : scene_.constraints.of<Collision>()) {
      if (c.mode != 2) continue;
      std::vector<std::uint32_t> members;
      for (const Ref m : c.members.all_of.none() ? c.members.list : std::vector{c.members.all_of}) {
        if (m.kind == Ref::Kind::object) members.push_back(m.index);
        if (m.kind == Ref::Kind::group) collect(m.index, members);
      }
      if (c.members.empty()) f_.apart_.assign(f_.apart_.size(), true);
      const std::size_t n = scene_.objects.size();
      for (const std::uint32_t i : members)
        for (const std::uint32_t j : members) f_.apart_[i * n + j] = true;
    }
  }

  /// "Doors are furniture objects" with a space of their own: what the leaf sweeps, and a person's depth.
  void add_door(const Door& door) {
    const auto at = frame(scene_.space, door);
    if (!at) return;
    const double depth = door.swing == Door::Swing::in ? std::max(door.width, kPersonDepth) : kPersonDepth;
    Space space;
    space.local = {at->jamb + door.width / 2 * at->along + depth / 2 * at->inward, at->inward, depth / 2,
                   door.width / 2};
    space.low = kStepHeight, space.high = door.height;
    add_space(space);
  }

  void add_paths() {
    const std::vector<Door>& doors = scene_.space.doors;
    for (std::size_t a = 0; a < doors.size(); ++a) {
      for (std::size_t b = a + 1; b < doors.size(); ++b) {
        const auto from = frame(scene_.space, doors[a]), to = frame(scene_.space, doors[b]);
        if (!from || !to) continue;
        Path path;
        path.from = from->jamb + doors[a].width / 2 * from->along, path.from_inward = from->inward;
        path.to = to->jamb + doors[b].width / 2 * to->along, path.to_inward = to->inward;
        path.first_space = static_cast<std::uint32_t>(f_.spaces.size());
        Space space;
        space.kind = Space::Kind::path;
        space.low = kStepHeight, space.high = kPersonHeight;
        for (std::uint32_t k = 0; k < kPathParts; ++k) add_space(space);
        f_.paths.push_back(path);
      }
    }
  }

  void index() {
    const std::size_t n = f_.items.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spaces, relations, circles;
    for (std::uint32_t s = 0; s < f_.spaces.size(); ++s)
      if (f_.spaces[s].owner != kNobody) spaces.emplace_back(f_.spaces[s].owner, s);
    for (std::uint32_t r = 0; r < f_.relations.size(); ++r) {
      relations.emplace_back(f_.relations[r].first, r);
      relations.emplace_back(f_.relations[r].second, r);
    }
    for (std::uint32_t k = 0; k < f_.circles.size(); ++k) {
      circles.emplace_back(f_.circles[k].first, k);
      for (const std::uint32_t i : f_.circles[k].seconds) circles.emplace_back(i, k);
    }
    f_.spaces_of = Lists<std::uint32_t>(n, spaces);
    f_.relations_of = Lists<std::uint32_t>(n, relations);
    f_.circles_of = Lists<std::uint32_t>(n, circles);
    for (std::uint32_t i = 0; i < n; ++i)
      if ((f_.items[i].moves || f_.items[i].turns) && !f_.items[i].attached) f_.walkers.push_back(i);
    double sum = 0;
    for (const Wall& wall : f_.room.walls()) f_.wall_sums.push_back(sum += wall.length);
  }

  const Scene& scene_;
  const Targets& targets_;
  Furniture& f_;
};

}  // namespace

Result<Furniture> compile(const Scene& scene, const Targets& targets, const Weights& weights) {
  Furniture f(scene);
  f.weights = weights;
  if (const Status s = Builder(scene, targets, f).run(); !s) return s.error();
  return f;
}

}  // namespace inhabit::annealing
