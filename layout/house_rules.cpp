#include "layout/house_rules.h"

#include <algorithm>
#include <map>
#include <vector>

#include "layout/house_places.h"
#include "layout/house_table.h"
#include "scene/kind.h"

namespace inhabit::layout {
namespace {

constexpr double kNear = 0.3;                       // between a table and who is about it, metres
constexpr double kView = 1.2, kFarthestView = 4.5;  // of a television
constexpr double kWish = 0.5;                       // stiffness of a wish that may give way
constexpr double kWindowDepth = 0.15;               // that stays free of what would cover a window
constexpr double kCovers = 0.3;                     // of its height that may be covered

Ref ref(std::size_t i) { return {Ref::Kind::object, static_cast<std::uint32_t>(i)}; }

class Rules {
 public:
  explicit Rules(Scene& scene) : scene_(scene), bound_(scene.objects.size()) {
    for (const Object& o : scene.objects) {
      const std::string_view by_kind = kind_of(o.kind, "", o.size.z);
      kinds_.push_back(by_kind.empty() ? kind_of(o.name, "", o.size.z) : by_kind);
      free_.push_back(!o.fixed);
    }
    for (const Group& g : scene.groups) {
      if (g.rigid) hold(g);
    }
  }

  void add() {
    stack();
    seek();
    stand();
    row_up();
    hang_over();
    clear_windows();
    lay_rugs();
  }

 private:
  void hold(const Group& group) {
    for (const Ref m : group.members) {
      if (m.kind == Ref::Kind::object) free_[m.index] = false;
      if (m.kind == Ref::Kind::group && depth_ < 32) {
        ++depth_;
        hold(scene_.groups[m.index]);
        --depth_;
      }
    }
  }

  KindTrait trait(std::size_t i) const {
    const KindRow* row = find_kind(kinds_[i]);
    return row == nullptr ? KindTrait::furniture : row->trait;
  }
  /// Neither carried nor hung from the ceiling, and nobody holds it.
  bool on_its_own(std::size_t i) const {
    const Object& o = scene_.objects[i];
    return free_[i] && o.on.none() && o.mount != Mount::ceiling;
  }

  /// Walls and clearances. Furniture that seeks nothing stands at a wall, whatever it is; what does keeps to right
  /// angles.
  void stand() {
    WallDistance back;
    WallOrientation turned, square;
    const Bounds room = bounds(scene_.space.outline);
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      Object& o = scene_.objects[i];
      if (!on_its_own(i) || trait(i) == KindTrait::flat || trait(i) == KindTrait::ceiling) continue;
      const auto row =
          std::find_if(kStands.begin(), kStands.end(), [&](const Stand& s) { return s.kind == kinds_[i]; });
      if (row != kStands.end() && !o.clearance.any()) o.clearance = row->clearance;
      // In a hall the sofa stands where the television can be seen, not at the far wall.
      const bool apart = viewers_[i] && std::min(room.size().x, room.size().y) > kFarthestView + 1;
      const bool at_wall = o.mount == Mount::wall || (row != kStands.end() ? row->wall && !roams(i) : !bound_[i]);
      if (at_wall && !middle_[i] && !apart) {
        back.members.list.push_back(ref(i));
        turned.members.list.push_back(ref(i));
      } else if (middle_[i] || apart) {
        square.members.list.push_back(ref(i));
      }
    }
    if (!back.members.empty()) {
      scene_.constraints.add(back);
      scene_.constraints.add(turned);
    }
    if (square.members.empty()) return;
    square.stiffness = kWish, square.weight = 1;
    scene_.constraints.add(square);
  }
  /// A sofa or an armchair in the circle about a coffee table.
  bool roams(std::size_t i) const { return bound_[i] && circles_[i]; }

  /// Every thing that seeks another gets the best one with room: the nearest where both have a place, else the
  /// emptiest for its size.
  void seek() {
    middle_.assign(kinds_.size(), false), circles_.assign(kinds_.size(), false);
    viewers_.assign(kinds_.size(), false);
    for (const Seek& rule : kSeeks) {
      // With a sofa in the room the television is watched from there and from its sides.
      if (rule.kind == "armchair" && rule.bond == Bond::view && any("sofa")) continue;
      std::map<std::size_t, std::vector<std::size_t>> gathered;
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (kinds_[i] != rule.kind || bound_[i] || !on_its_own(i)) continue;
        const std::size_t other = choose(rule, i, gathered);
        if (other == kinds_.size()) continue;
        bound_[i] = true;
        gathered[other].push_back(i);
      }
      for (const auto& [other, members] : gathered) bind(rule, other, members);
    }
  }

  bool any(std::string_view kind) const { return std::find(kinds_.begin(), kinds_.end(), kind) != kinds_.end(); }

  std::size_t choose(const Seek& rule, std::size_t i,
                     const std::map<std::size_t, std::vector<std::size_t>>& gathered) const {
    std::size_t best = kinds_.size();
    double least = 1e300;
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      // What is bound to this one does not lead it in turn.
      if (kinds_[k] != rule.other || k == i || leader_of(k) == i) continue;
      const auto found = gathered.find(k);
      const std::size_t taken = (found == gathered.end() ? 0 : found->second.size()) + guests_of(k, rule);
      if (taken >= rule.at_most) continue;
      const Object &a = scene_.objects[i], &b = scene_.objects[k];
      const double cost = a.position && b.position ? length(a.position->xy() - b.position->xy())
                                                   : 1e6 + static_cast<double>(taken + 1) / (b.size.x * b.size.y);
      if (cost < least) least = cost, best = k;
    }
    return best;
  }
  std::size_t leader_of(std::size_t i) const {
    const auto found = leaders_.find(i);
    return found == leaders_.end() ? kinds_.size() : found->second;
  }
  /// Those whom earlier rules have brought to the same side of it.
  std::size_t guests_of(std::size_t other, const Seek& rule) const {
    if (rule.bond == Bond::view) return 0;
    const auto found = guests_.find({other, rule.bond});
    return found == guests_.end() ? 0 : found->second;
  }

  void bind(const Seek& rule, std::size_t other, std::vector<std::size_t> members) {
    for (const std::size_t i : members) leaders_[i] = other;
    std::size_t& guests = guests_[{other, rule.bond}];
    const bool first = guests == 0;
    guests += members.size();
    // The places at a table are counted out once: stools come to where its chairs leave room.
    if (rule.bond == Bond::view || !first) return face(first ? Bond::view : Bond::circle, other, members);
    const std::vector<Place> places = places_at(rule, other, members);
    for (const Place& place : places) {
      if (members.empty()) break;
      const auto nearest = std::min_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
        return away(a, other, place) < away(b, other, place);
      });
      put(*nearest, other, place, false);
      members.erase(nearest);
    }
    if (!members.empty()) face(Bond::circle, other, members);
  }

  std::vector<Place> places_at(const Seek& rule, std::size_t other, const std::vector<std::size_t>& members) {
    const Vec3& size = scene_.objects[other].size;
    Vec3 guest = scene_.objects[members.front()].size;
    for (const std::size_t i : members) {
      guest.x = std::max(guest.x, scene_.objects[i].size.x);
      guest.y = std::max(guest.y, scene_.objects[i].size.y);
    }
    switch (rule.bond) {
      case Bond::flank:
        return flanks(size, guest);
      case Bond::wing:
        return wings(size, guest);
      case Bond::before: {
        Place place = before(size, guest, rule.gap);
        if (rule.turned) place.turn = kPi;
        return {place};
      }
      default:
        break;
    }
    // People sit on all sides of a table, at one side only when alone: its back is then free for a wall.
    const bool around = rule.bond == Bond::around;
    if (around && members.size() > 1) middle_[other] = true;
    return seats(size, guest, around && members.size() > 1 ? Sides::around : Sides::front, members.size(), rule.gap);
  }

  /// How far a thing is from a place, if both are known.
  double away(std::size_t i, std::size_t other, const Place& place) const {
    const Object &a = scene_.objects[i], &b = scene_.objects[other];
    if (!a.position || !b.position || !b.angle) return 0;
    return length(a.position->xy() - b.position->xy() - rotate(place.at, direction(*b.angle)));
  }

  /// At a place beside another thing, with the heading there. `stays`: the other is not moved to make room.
  void put(std::size_t i, std::size_t other, const Place& place, bool stays) {
    HeatPoint at;
    at.members.list = {ref(i)};
    at.point = place.at, at.on = ref(other), at.on_fixed = stays;
    Orientation facing;
    facing.members.list = {ref(i)};
    facing.to = ref(other), facing.relative = 1, facing.angle = place.turn;
    scene_.constraints.add(at);
    scene_.constraints.add(facing);
  }

  /// Somewhere about another thing, looking at it.
  void face(Bond bond, std::size_t other, const std::vector<std::size_t>& members) {
    Orientation facing;
    facing.to = ref(other);
    facing.stiffness = kWish;
    const Vec3& a = scene_.objects[other].size;
    for (const std::size_t i : members) {
      facing.members.list.push_back(ref(i));
      FocalDistance at;
      at.focal = ref(other);
      at.members.list = {ref(i)};
      at.focal_fixed = true;
      at.min = kView, at.max = kFarthestView;
      viewers_[i] = bond == Bond::view;
      if (bond == Bond::circle) {
        circles_[i] = true;
        const double reach = scene_.objects[i].size.y / 2;
        at.min = std::min(a.x, a.y) / 2 + reach, at.max = std::max(a.x, a.y) / 2 + reach + kNear;
      }
      scene_.constraints.add(at);
    }
    if (bond == Bond::view) {
      // Opposite the screen, not aslant.
      FocalSymmetry opposite;
      opposite.focal = ref(other);
      opposite.members.list = {ref(members.front())};
      opposite.stiffness = kWish;
      scene_.constraints.add(opposite);
    }
    scene_.constraints.add(facing);
  }

  /// Kitchen units side by side, as far as a wall is long.
  void row_up() {
    std::size_t last = kinds_.size();
    for (const std::string_view kind : kKitchenUnits) {
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (kinds_[i] != kind || !on_its_own(i) || scene_.objects[i].mount != Mount::floor) continue;
        if (last != kinds_.size()) {
          Distance next;
          next.between = {ref(last), ref(i)};
          next.max = (scene_.objects[last].size.x + scene_.objects[i].size.x) / 2 + 0.05;
          next.stiffness = 0.2, next.weight = 0.3;  // a row breaks at every corner
          scene_.constraints.add(next);
        }
        last = i;
      }
    }
  }

  /// A hood over the cooker, upper cabinets over lower units: flush with their backs.
  void hang_over() {
    std::vector<bool> taken(kinds_.size());
    for (const std::string_view kind : {std::string_view("hood"), std::string_view("upper cabinet")}) {
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const Object& upper = scene_.objects[i];
        if (kinds_[i] != kind || !on_its_own(i) || upper.mount != Mount::wall) continue;
        const double base = upper.position ? upper.position->z : upper.elevation.value_or(1.2);
        std::size_t best = kinds_.size();
        for (const std::string_view lower : kKitchenUnits) {
          if (kind == "hood" && lower != "cooker") continue;
          for (std::size_t k = 0; k < kinds_.size() && best == kinds_.size(); ++k) {
            const Object& o = scene_.objects[k];
            const bool low = o.mount == Mount::floor && o.on.none() && o.size.z < base;
            if (kinds_[k] == lower && low && !taken[k] && o.size.x > 0.7 * upper.size.x && at_wall(o)) best = k;
          }
        }
        if (best == kinds_.size()) continue;
        taken[best] = true;
        const double flush = (upper.size.y - scene_.objects[best].size.y) / 2;
        put(i, best, {{flush, 0}, 0}, true);
      }
    }
  }
  /// False for what stands fixed in the middle of the room.
  bool at_wall(const Object& o) const {
    if (!o.fixed || !o.position || !o.angle) return true;
    const Vec2 back = o.position->xy() - (o.size.y / 2) * direction(*o.angle);
    return nearest_on_ring(scene_.space.outline, back).distance < 0.15;
  }

  /// What is higher than a window's sill, or hangs, keeps out from before it.
  void clear_windows() {
    for (const Window& w : scene_.space.windows) {
      if (w.wall < 0 || static_cast<std::size_t>(w.wall) >= scene_.space.walls()) continue;
      const auto wall = static_cast<std::size_t>(w.wall);
      const Vec2 along = unit(scene_.space.wall_end(wall) - scene_.space.wall_start(wall));
      const Vec2 a = scene_.space.wall_start(wall) + w.from * along, b = a + w.width * along;
      const Vec2 in = kWindowDepth * perp(along);
      KeepOut free;
      free.polygon = {a, b, b + in, a + in};
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const Object& o = scene_.objects[i];
        if (!on_its_own(i) || kinds_[i] == "curtain" || kinds_[i] == "radiator" || kinds_[i] == "plant") continue;
        const double base = o.position ? o.position->z : o.elevation.value_or(o.mount == Mount::wall ? 1.2 : 0);
        const double covered = std::min(base + o.size.z, w.sill + w.height) - std::max(base, w.sill);
        if (covered > kCovers * w.height) free.members.list.push_back(ref(i));
      }
      if (!free.members.empty() && w.sill > 0.05) scene_.constraints.add(free);
    }
  }

  /// What others carry: a television in the middle of its stand, the rest anywhere, all looking the same way.
  void stack() {
    std::vector<bool> has_screen(kinds_.size());
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const Object& o = scene_.objects[i];
      if (o.on.kind != Ref::Kind::object || !free_[i] || stacked(i)) continue;
      const bool screen = kinds_[i] == "tv" && !has_screen[o.on.index];
      if (!screen && !at_top(o)) continue;
      Stacking s;
      s.object = ref(i);
      s.on = o.on;
      s.anywhere = !screen;
      s.weight = 20;  // nothing hangs over an edge where it could lie
      if (screen) has_screen[o.on.index] = true;
      scene_.constraints.add(s);
      if (kinds_[o.on.index] == "bed" && words_of(o.kind, ' ').find("pillow") != std::string::npos) {
        put(i, o.on.index, {{(o.size.y - scene_.objects[o.on.index].size.y) / 2 + 0.05, 0}, 0}, true);
      } else if (screen || kinds_[i] == "desktop computer") {
        Orientation same;
        same.members.list = {ref(i)};
        same.to = o.on, same.relative = 1;
        scene_.constraints.add(same);
      }
    }
  }

  bool stacked(std::size_t i) const {
    const auto& all = scene_.constraints.of<Stacking>();
    return std::any_of(all.begin(), all.end(), [&](const Stacking& s) { return s.object == ref(i); });
  }
  /// False for what lies lower than its carrier's top, on a seat or in a basin.
  bool at_top(const Object& o) const {
    if (!o.position || !scene_.objects[o.on.index].position) return true;
    const Object& lower = scene_.objects[o.on.index];
    return std::abs(o.position->z - lower.position->z - lower.size.z) < 0.05;
  }

  /// Rugs are walked over and stood on: a millimetre high, they collide with nothing. They lie where people gather.
  void lay_rugs() {
    std::vector<bool> taken(kinds_.size());
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      if (trait(i) != KindTrait::flat) continue;
      Object& rug = scene_.objects[i];
      rug.size.z = std::min(rug.size.z, 0.001);
      if (!on_its_own(i)) continue;
      bool laid = false;
      for (const Under& under : kUnderRugs) {
        for (std::size_t k = 0; k < kinds_.size() && !laid; ++k) {
          if (kinds_[k] != under.other || taken[k]) continue;
          taken[k] = laid = true;
          put(i, k, {{under.ahead * scene_.objects[k].size.y, 0}, 0}, true);
        }
      }
      if (laid) continue;
      WallOrientation square;
      square.members.list = {ref(i)};
      square.stiffness = kWish, square.weight = 1;
      scene_.constraints.add(square);
    }
  }

  Scene& scene_;
  std::vector<std::string_view> kinds_;
  std::vector<bool> free_, bound_;
  std::vector<bool> middle_;   ///< tables with people on all sides
  std::vector<bool> circles_;  ///< seats about something
  std::vector<bool> viewers_;  ///< seats before a television
  std::map<std::size_t, std::size_t> leaders_;
  std::map<std::pair<std::size_t, Bond>, std::size_t> guests_;
  int depth_ = 0;
};

}  // namespace

void add_house_rules(Scene& scene) {
  const std::size_t neutral = scene.constraints.of<Collision>().size() + scene.constraints.of<Stacking>().size();
  if (scene.constraints.size() > neutral) return;
  Rules(scene).add();
}

}  // namespace inhabit::layout
