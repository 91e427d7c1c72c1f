#include <algorithm>

#include "io/formats/sweethome3d_scene.h"

namespace inhabit::io {
namespace sh3d {
namespace {

/// All pieces below, groups opened; `seen` is false for what is invisible or in an invisible group.
void each_leaf(const Piece& piece, bool seen, bool fixed, const auto& visit) {
  seen = seen && piece.visible;
  fixed = fixed || !piece.movable;
  if (piece.type != Piece::Type::group) return visit(piece, seen, fixed);
  for (const Piece& child : piece.children) each_leaf(child, seen, fixed, visit);
}

/// The room that p stands in: on its level, one with a floor before one with only a ceiling, the smallest of those;
/// else one at most 5 cm away, for what is sunk into a wall.
RoomDraft* room_at(std::vector<RoomDraft>& rooms, const std::string& level, Vec2 p) {
  RoomDraft* best = nullptr;
  for (RoomDraft& r : rooms) {
    if (r.room->level != level || r.scene.space.outline.empty() || !contains(r.polygon, p)) continue;
    const auto rank = [](const RoomDraft& d) { return std::pair(!d.room->floor_visible, d.area); };
    if (best == nullptr || rank(r) < rank(*best)) best = &r;
  }
  if (best != nullptr) return best;
  double nearest = 0.05;
  for (RoomDraft& r : rooms) {
    if (r.room->level != level || r.scene.space.outline.empty()) continue;
    const double d = nearest_on_ring(r.polygon, p).distance;
    if (d < nearest) nearest = d, best = &r;
  }
  return best;
}

/// The middle of the furniture in a piece or group; the level of the first of it. Nothing when there is none to see.
struct Middle {
  Vec2 p;
  std::string level;
  std::size_t count = 0;
};
Middle middle_of(const Piece& piece) {
  Bounds box;
  Middle middle{{}, piece.level, 0};
  each_leaf(piece, true, false, [&](const Piece& leaf, bool seen, bool) {
    if (!seen || leaf.type == Piece::Type::opening) return;
    box.add(metres(leaf.p));
    if (middle.level.empty()) middle.level = leaf.level;
    ++middle.count;
  });
  if (middle.count > 0) middle.p = box.center();
  return middle;
}

/// A door that stands in a room and in none of its walls.
bool stand_opening(const Piece& piece, std::vector<RoomDraft>& drafts) {
  RoomDraft* room = room_at(drafts, piece.level, metres(piece.p));
  if (room == nullptr) return false;
  const auto& holes = room->scene.space.holes;
  if (!contains(room->scene.space.outline, metres(piece.p)) ||
      std::any_of(holes.begin(), holes.end(), [&](const auto& h) { return contains(h.outline, metres(piece.p)); }))
    return false;
  room->standing_openings.push_back({&piece, true});
  return true;
}

}  // namespace
}  // namespace sh3d

Result<Sh3dRooms> read_rooms(const Sh3dHome& home) {
  using namespace sh3d;
  const auto plan = read_plan(home.xml);
  if (!plan) return plan.error();
  Sh3dRooms out;
  std::vector<RoomDraft> drafts = draft_rooms(*plan, out.warnings);
  for (const Piece& piece : plan->pieces) {
    each_leaf(piece, true, false, [&](const Piece& leaf, bool seen, bool) {
      ++out.pieces;
      if (!seen) {
        out.hidden.push_back(describe(leaf));
      } else if (leaf.type == Piece::Type::opening && !place_opening(leaf, drafts) && !stand_opening(leaf, drafts)) {
        out.outside.push_back(describe(leaf));
      }
    });
    if (piece.type == Piece::Type::opening) continue;
    const Middle middle = middle_of(piece);
    if (middle.count == 0) continue;
    if (RoomDraft* room = room_at(drafts, middle.level, middle.p)) {
      room->furniture.push_back(&piece);
      continue;
    }
    each_leaf(piece, true, false, [&](const Piece& leaf, bool seen, bool) {
      if (seen && leaf.type != Piece::Type::opening) out.outside.push_back(describe(leaf));
    });
  }
  for (RoomDraft& draft : drafts) {
    if (draft.scene.space.outline.empty()) continue;
    place_furniture(draft);
    out.scenes.push_back(std::move(draft.scene));
  }
  return out;
}

Result<std::vector<scene::Scene>> rooms(const Sh3dHome& home) {
  auto read = read_rooms(home);
  if (!read) return read.error();
  return std::move(read->scenes);
}

}  // namespace inhabit::io
