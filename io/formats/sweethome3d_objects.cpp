#include <algorithm>
#include <cmath>

#include "io/formats/sweethome3d_scene.h"
#include "scene/kind.h"

namespace inhabit::io::sh3d {
namespace {

using scene::KindTrait;
using scene::Mount;
using scene::Object;
using scene::Ref;

constexpr double kRugHeight = 0.001;
constexpr double kThin = 0.03;   // metres: what is lower is walked over
constexpr double kSunk = 0.05;   // metres beyond the wall's face
constexpr double kTouch = 0.03;  // how far a base may be from the top that carries it

Ref object_ref(std::size_t i) { return {Ref::Kind::object, static_cast<std::uint32_t>(i)}; }

double top(const Object& o) { return o.position->z + o.size.z; }
Box box_of(const Object& o) { return make_box({o.position->xy(), *o.angle}, o.size); }

KindTrait trait_of(const Object& o) {
  const scene::KindRow* row = scene::find_kind(o.kind);
  return row == nullptr ? KindTrait::furniture : row->trait;
}

/// Where a thing is held: what hangs above the floor, by nothing below it, hangs from the ceiling or on a wall.
Mount mount_of(const Object& o, const scene::Space& space) {
  const KindTrait trait = trait_of(o);
  if (!o.on.none()) return Mount::floor;
  if (trait == KindTrait::ceiling) return Mount::ceiling;
  if (o.position->z <= 0.05) return Mount::floor;
  if (trait == KindTrait::wall) return Mount::wall;
  if (trait == KindTrait::building) return Mount::floor;
  const double reach = std::max(o.size.x, o.size.y) / 2 + 0.15;
  return nearest_on_ring(space.outline, o.position->xy()).distance <= reach ? Mount::wall : Mount::floor;
}

/// True when all corners of the upper footprint lie on the lower one, or at most 10 cm beside it; televisions are often
/// wider than what they stand on.
bool stands_within(const Object& upper, const Object& lower) {
  Box box = box_of(lower);
  if (!box.contains(upper.position->xy())) return false;
  const double overhang = upper.kind == "tv" ? 0.3 : 0.1;
  box.half_depth += overhang;
  box.half_width += overhang;
  const auto corners = box_of(upper).corners();
  return std::all_of(corners.begin(), corners.end(), [&](Vec2 c) { return box.contains(c); });
}

/// Objects of one room, with what is known of them besides.
class Furnisher {
 public:
  explicit Furnisher(RoomDraft& room) : room_(room), scene_(room.scene) {}

  void add(const Piece& piece, bool fixed) { add_piece(piece, fixed); }

  void finish() {
    find_carriers();
    for (Object& o : scene_.objects) o.mount = mount_of(o, scene_.space);
    fix_what_is_built_in();
    switch_collisions_off();
  }

 private:
  Ref add_piece(const Piece& piece, bool fixed) {
    if (!piece.visible) return {};
    fixed = fixed || !piece.movable;
    if (piece.type == Piece::Type::group) return add_group(piece, fixed);
    Object o;
    o.name = piece.name;
    const std::string_view kind = scene::kind_of(piece.name, piece.catalog_id, piece.height / 100);
    o.kind = kind.empty() ? scene::words_of(piece.name, ' ') : std::string(kind);
    std::string stem = o.kind.empty() ? "thing" : o.kind;
    std::replace(stem.begin(), stem.end(), ' ', '-');
    o.id = room_.ids.next(stem);
    o.size = {piece.width / 100, piece.depth / 100, piece.height / 100};
    // Rugs are walked over and stood on: a millimetre high, they collide with nothing.
    const bool flat = trait_of(o) == KindTrait::flat || piece.height / 100 < kThin;
    if (flat && piece.elevation <= 5) o.size.z = std::min(o.size.z, kRugHeight);
    const Vec2 p = metres(piece.p);
    o.position = Vec3{p.x, p.y, piece.elevation / 100};
    o.angle = turn_angle(piece.angle);
    o.fixed = fixed || trait_of(o) == KindTrait::building || piece.type == Piece::Type::opening;
    o.extras.emplace_back(kOriginKey, "{\"piece\":\"" + piece.path + "\"}");
    scene_.objects.push_back(std::move(o));
    // Where things stand on it: usually its top, but the seat of a chair lies lower.
    shelf_.push_back(piece.drop_on_top < 0 ? -1 : piece.elevation / 100 + piece.drop_on_top * piece.height / 100);
    return object_ref(scene_.objects.size() - 1);
  }

  Ref add_group(const Piece& piece, bool fixed) {
    // Doors and windows stay in their walls, and so does what is grouped with them.
    const bool has_opening = std::any_of(piece.children.begin(), piece.children.end(),
                                         [](const Piece& c) { return c.type == Piece::Type::opening; });
    // A staircase, a railing, a fireplace made of boxes.
    const scene::KindRow* row = scene::find_kind(scene::kind_of(piece.name));
    const bool building = row != nullptr && row->trait == KindTrait::building;
    scene::Group group;
    group.rigid = true;
    Bounds box;
    for (const Piece& child : piece.children) {
      if (child.type == Piece::Type::opening) continue;
      const std::size_t before = scene_.objects.size();
      const Ref member = add_piece(child, fixed || has_opening || building);
      if (member.none()) continue;
      group.members.push_back(member);
      for (std::size_t i = before; i < scene_.objects.size(); ++i) {
        for (const Vec2 c : box_of(scene_.objects[i]).corners()) box.add(c);
      }
    }
    if (group.members.empty()) return {};
    const std::string words = scene::words_of(piece.name, '-');
    group.id = room_.ids.next(words.empty() ? std::string("group") : words);
    group.position = box.center();
    group.angle = 0;
    group.extras.emplace_back(kOriginKey, "{\"piece\":\"" + piece.path + "\"}");
    scene_.groups.push_back(std::move(group));
    return {Ref::Kind::group, static_cast<std::uint32_t>(scene_.groups.size() - 1)};
  }

  void find_carriers() {
    auto& objects = scene_.objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const double base = objects[i].position->z;
      if (base <= kThin) continue;
      double smallest = 1e300;
      for (std::size_t k = 0; k < objects.size(); ++k) {
        const Object& lower = objects[k];
        if (k == i || lower.size.z < kThin || lower.position->z >= base) continue;
        const bool at_top = std::abs(base - top(lower)) <= kTouch;
        const bool on_shelf = shelf_[k] >= 0 && std::abs(base - shelf_[k]) <= kTouch;
        const double area = lower.size.x * lower.size.y;
        if ((!at_top && !on_shelf) || area >= smallest || !stands_within(objects[i], lower)) continue;
        smallest = area;
        objects[i].on = object_ref(k);
      }
    }
  }

  /// What hangs or stands sunk into a wall (plants in a window's niche, a television in its recess) stays there, and so
  /// does what lies across several things (a worktop), and the rest of a rigid group of which something stays.
  void fix_what_is_built_in() {
    for (Object& o : scene_.objects) {
      if (o.position->z <= 0.05 || !o.on.none()) continue;
      if (o.mount == Mount::floor) o.fixed = true;
      for (const Vec2 c : box_of(o).corners()) {
        if (!contains(scene_.space.outline, c) && nearest_on_ring(scene_.space.outline, c).distance > kSunk)
          o.fixed = true;
      }
    }
    // Members stand before the groups that hold them, so that one pass up and one down reach all.
    auto& groups = scene_.groups;
    std::vector<bool> fixed(groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const Ref m : groups[g].members)
        fixed[g] = fixed[g] || (m.kind == Ref::Kind::object ? scene_.objects[m.index].fixed : fixed[m.index]);
    }
    for (std::size_t g = groups.size(); g-- > 0;) {
      for (const Ref m : groups[g].members) {
        if (!fixed[g]) break;
        if (m.kind == Ref::Kind::object) scene_.objects[m.index].fixed = true;
        if (m.kind == Ref::Kind::group) fixed[m.index] = true;
      }
    }
  }

  /// What stands inside its carrier (on a seat, in a basin) does not collide with it, and things that never move
  /// overlap as their owner wanted.
  void switch_collisions_off() {
    const auto& objects = scene_.objects;
    scene::Collision built;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Object& o = objects[i];
      if (o.fixed) built.members.list.push_back(object_ref(i));
      if (o.on.none() || o.position->z >= top(objects[o.on.index]) - 1e-3) continue;
      add_off({object_ref(i), o.on});
    }
    if (built.members.list.size() > 1) add_off(std::move(built.members.list));
  }

  void add_off(std::vector<Ref> members) {
    scene::Collision off;
    off.members.list = std::move(members);
    off.mode = 2;
    scene_.constraints.add(std::move(off));
  }

  RoomDraft& room_;
  scene::Scene& scene_;
  std::vector<double> shelf_;
};

}  // namespace

void place_furniture(RoomDraft& room) {
  Furnisher furnisher(room);
  for (const Piece* piece : room.furniture) furnisher.add(*piece, false);
  for (const Leaf& leaf : room.standing_openings) furnisher.add(*leaf.piece, leaf.fixed);
  furnisher.finish();
}

}  // namespace inhabit::io::sh3d
