#include "layout/house_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "scene/kind.h"

namespace inhabit::layout {
namespace {

/// A thing's own wishes: its back at a wall or not, and free depth at its faces (front, back, left, right), metres.
struct Stand {
  std::string_view kind;
  bool wall = false;
  Clearance clearance;
};

constexpr std::array kStands = {
    Stand{"bed", true, {0.4, 0, 0, 0}},
    Stand{"bunk bed", true, {0.4, 0, 0, 0}},
    Stand{"wardrobe", true, {0.6, 0, 0, 0}},
    Stand{"dresser", true, {0.6, 0, 0, 0}},
    Stand{"chest", true, {0.4, 0, 0, 0}},
    Stand{"bookcase", true, {0.5, 0, 0, 0}},
    Stand{"cupboard", true, {0.5, 0, 0, 0}},
    Stand{"filing cabinet", true, {0.5, 0, 0, 0}},
    Stand{"desk", true, {0.6, 0, 0, 0}},
    Stand{"dressing table", true, {0.5, 0, 0, 0}},
    Stand{"sofa", true, {0.4, 0, 0, 0}},
    Stand{"tv stand", true, {0.5, 0, 0, 0}},
    Stand{"kitchen cabinet", true, {0.6, 0, 0, 0}},
    Stand{"counter", true, {0.6, 0, 0, 0}},
    Stand{"fridge", true, {0.6, 0, 0, 0}},
    Stand{"cooker", true, {0.6, 0, 0, 0}},
    Stand{"dishwasher", true, {0.6, 0, 0, 0}},
    Stand{"washing machine", true, {0.6, 0, 0, 0}},
    Stand{"chest freezer", true, {0.5, 0, 0, 0}},
    Stand{"sink", true, {0.6, 0, 0, 0}},
    Stand{"kitchen island", false, {0.6, 0, 0, 0}},
    Stand{"washbasin", true, {0.5, 0, 0, 0}},
    Stand{"toilet", true, {0.5, 0, 0, 0}},
    Stand{"bidet", true, {0.5, 0, 0, 0}},
    Stand{"bath", true, {0, 0, 0, 0}},
    Stand{"shower", true, {0.4, 0, 0, 0}},
    Stand{"piano", true, {0.6, 0, 0, 0}},
    Stand{"aquarium", true, {0.3, 0, 0, 0}},
    Stand{"coat rack", true, {0.3, 0, 0, 0}},
    Stand{"floor lamp", true, {}},
    Stand{"plant", true, {}},
    Stand{"trash can", true, {}},
    Stand{"upper cabinet", true, {}},
    Stand{"hood", true, {}},
    Stand{"radiator", true, {}},
    Stand{"mirror", true, {}},
    Stand{"picture", true, {}},
    Stand{"shelf", true, {}},
    Stand{"wall lamp", true, {}},
    Stand{"curtain", true, {}},
    Stand{"toilet paper", true, {}},
};

/// How a thing seeks another one out.
enum class Bond {
  seat,    ///< at its edge, looking at it
  beside,  ///< next to it
  view     ///< looks at it from a distance
};
struct Seek {
  std::string_view kind, other;
  Bond bond = Bond::seat;
  std::size_t at_most = 100;  ///< so many to one of the others
};

/// In order of preference: a chair takes the first row whose other exists and has room.
constexpr std::array kSeeks = {
    Seek{"office chair", "desk", Bond::seat, 1},    Seek{"chair", "dining table", Bond::seat, 8},
    Seek{"chair", "table", Bond::seat, 6},          Seek{"chair", "desk", Bond::seat, 1},
    Seek{"chair", "dressing table", Bond::seat, 1}, Seek{"office chair", "table", Bond::seat, 2},
    Seek{"piano bench", "piano", Bond::seat, 1},    Seek{"stool", "counter", Bond::seat, 6},
    Seek{"stool", "kitchen island", Bond::seat, 6}, Seek{"stool", "dressing table", Bond::seat, 1},
    Seek{"stool", "table", Bond::seat, 4},          Seek{"armchair", "coffee table", Bond::seat, 4},
    Seek{"ottoman", "armchair", Bond::beside, 1},   Seek{"sofa", "tv", Bond::view},
    Seek{"sofa", "tv stand", Bond::view},           Seek{"coffee table", "sofa", Bond::beside, 1},
    Seek{"side table", "sofa", Bond::beside, 2},    Seek{"bedside table", "bed", Bond::beside, 2},
    Seek{"pet bed", "sofa", Bond::beside, 1},
};

constexpr double kGap = 0.05;                       // metres between a seat and the edge that it stands at
constexpr double kLegroom = 0.45;                   // between a sofa and its coffee table
constexpr double kView = 1.2, kFarthestView = 4.5;  // of a television, metres
constexpr double kWish = 0.5;                       // stiffness of a wish that may give way

Ref ref(std::size_t i) { return {Ref::Kind::object, static_cast<std::uint32_t>(i)}; }

class Rules {
 public:
  explicit Rules(Scene& scene) : scene_(scene) {
    for (const Object& o : scene.objects) {
      const std::string_view by_kind = kind_of(o.kind, "", o.size.z);
      kinds_.push_back(by_kind.empty() ? kind_of(o.name, "", o.size.z) : by_kind);
    }
    free_.assign(scene.objects.size(), true);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) free_[i] = !scene.objects[i].fixed;
    for (const Group& g : scene.groups) {
      if (g.rigid) hold(g);
    }
  }

  void add() {
    stand();
    seek();
    stack();
    walk_over();
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

  /// Walls and clearances.
  void stand() {
    WallDistance back;
    WallOrientation turned;
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const auto row =
          std::find_if(kStands.begin(), kStands.end(), [&](const Stand& s) { return s.kind == kinds_[i]; });
      if (row == kStands.end() || !free_[i] || !scene_.objects[i].on.none()) continue;
      Object& o = scene_.objects[i];
      if (!o.clearance.any()) o.clearance = row->clearance;
      if (!row->wall) continue;
      back.members.list.push_back(ref(i));
      turned.members.list.push_back(ref(i));
    }
    // Whatever else hangs on a wall has its back there.
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const Object& o = scene_.objects[i];
      if (o.mount != Mount::wall || !free_[i] || listed(back.members, i)) continue;
      back.members.list.push_back(ref(i));
      turned.members.list.push_back(ref(i));
    }
    if (back.members.empty()) return;
    scene_.constraints.add(back);
    scene_.constraints.add(turned);
  }

  static bool listed(const Members& members, std::size_t i) {
    return std::find(members.list.begin(), members.list.end(), ref(i)) != members.list.end();
  }

  /// Every thing that seeks another gets the best one with room: the nearest where both have a place, else the
  /// emptiest.
  void seek() {
    std::vector<bool> bound(kinds_.size());
    for (const Seek& rule : kSeeks) {
      std::map<std::size_t, std::vector<std::size_t>> gathered;
      for (std::size_t i = 0; i < kinds_.size(); ++i) {
        if (kinds_[i] != rule.kind || bound[i] || !free_[i]) continue;
        const std::size_t other = choose(rule, i, gathered);
        if (other == kinds_.size()) continue;
        bound[i] = true;
        gathered[other].push_back(i);
      }
      for (const auto& [other, members] : gathered) bind(rule.bond, other, members);
    }
  }

  std::size_t choose(const Seek& rule, std::size_t i,
                     const std::map<std::size_t, std::vector<std::size_t>>& gathered) const {
    std::size_t best = kinds_.size();
    double least = 1e300;
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      if (kinds_[k] != rule.other || k == i) continue;
      const auto found = gathered.find(k);
      const std::size_t taken = found == gathered.end() ? 0 : found->second.size();
      if (taken >= rule.at_most) continue;
      const Object &a = scene_.objects[i], &b = scene_.objects[k];
      const double cost =
          a.position && b.position ? length(a.position->xy() - b.position->xy()) : 1e6 + static_cast<double>(taken);
      if (cost < least) least = cost, best = k;
    }
    return best;
  }

  void bind(Bond bond, std::size_t other, const std::vector<std::size_t>& members) {
    Orientation facing;
    facing.to = ref(other);
    facing.stiffness = kWish;
    for (const std::size_t i : members) {
      facing.members.list.push_back(ref(i));
      FocalDistance at = reach(bond, scene_.objects[other].size, scene_.objects[i].size);
      at.focal = ref(other);
      at.members.list = {ref(i)};
      // What is gathered round stays where it is: the chairs come to the table.
      at.focal_fixed = true;
      scene_.constraints.add(at);
    }
    if (bond != Bond::beside) scene_.constraints.add(facing);
  }

  /// Between which distances of the centres a thing of size `b` is at the edge of one of size `a`, on whichever side.
  static FocalDistance reach(Bond bond, const Vec3& a, const Vec3& b) {
    FocalDistance at;
    const double near = std::min(a.x, a.y) / 2, far = std::max(a.x, a.y) / 2;
    if (bond == Bond::view) {
      at.min = kView;
      at.max = kFarthestView;
      return at;
    }
    if (bond == Bond::seat) {
      at.min = near + b.y / 2;
      at.max = far + b.y / 2 + kGap;
      return at;
    }
    at.max = std::hypot(far + std::max(b.x, b.y) / 2, near) + kLegroom;
    at.stiffness = kWish;
    return at;
  }

  void stack() {
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const Object& o = scene_.objects[i];
      if (o.on.none() || !free_[i] || stacked(i) || !at_top(o)) continue;
      Stacking s;
      s.object = ref(i);
      s.on = o.on;
      s.anywhere = true;
      scene_.constraints.add(s);
    }
  }

  bool stacked(std::size_t i) const {
    const auto& all = scene_.constraints.of<Stacking>();
    return std::any_of(all.begin(), all.end(), [&](const Stacking& s) { return s.object == ref(i); });
  }
  /// False for what lies lower than its carrier's top, on a seat or in a basin.
  bool at_top(const Object& o) const {
    if (o.on.kind != Ref::Kind::object || !o.position || !scene_.objects[o.on.index].position) return true;
    const Object& lower = scene_.objects[o.on.index];
    return std::abs(o.position->z - lower.position->z - lower.size.z) < 0.05;
  }

  /// Rugs are walked over and stood on: a millimetre high, they collide with nothing.
  void walk_over() {
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      const KindRow* row = find_kind(kinds_[i]);
      if (row == nullptr || row->trait != KindTrait::flat) continue;
      scene_.objects[i].size.z = std::min(scene_.objects[i].size.z, 0.001);
    }
  }

  Scene& scene_;
  std::vector<std::string_view> kinds_;
  std::vector<bool> free_;
  int depth_ = 0;
};

}  // namespace

void add_house_rules(Scene& scene) {
  const std::size_t neutral = scene.constraints.of<Collision>().size() + scene.constraints.of<Stacking>().size();
  if (scene.constraints.size() > neutral) return;
  Rules(scene).add();
}

}  // namespace inhabit::layout
