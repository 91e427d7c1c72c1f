#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/sweethome3d.h"
#include "io/formats/sweethome3d_plan.h"

/// The steps between a plan and its scenes.
namespace inhabit::io::sh3d {

/// The key under which scenes and objects keep where they came from: `{"room": 3}`, `{"piece": "12/0"}`.
constexpr std::string_view kOriginKey = "x-sh3d";

/// Readable ids, each given once: "bed-1", "bed-2".
class Ids {
 public:
  std::string next(std::string_view name);

 private:
  std::map<std::string, int, std::less<>> given_;
};

/// A piece, and whether something above it keeps it from moving.
struct Leaf {
  const Piece* piece = nullptr;
  bool fixed = false;
};

/// One room on its way to become a scene.
struct RoomDraft {
  scene::Scene scene;
  Ring polygon;  ///< as drawn, metres, counter-clockwise; empty when it is no polygon
  const Room* room = nullptr;
  double area = 0;
  Ids ids;
  std::vector<const Piece*> furniture;  ///< top-level pieces and groups that stand here
  std::vector<Leaf> standing_openings;  ///< doors that stand in the room and in no wall of it
};

/// Outline, holes and height of every room; a polygon that cannot be a room has an empty outline.
std::vector<RoomDraft> draft_rooms(const Plan& plan, std::vector<std::string>& warnings);

/// Puts a door or window into every room whose outline it touches; false when there is none.
bool place_opening(const Piece& opening, std::vector<RoomDraft>& rooms);

/// Adds the furniture of the draft to its scene as objects and groups, with `on`, mounts and collisions switched off.
void place_furniture(RoomDraft& room);

/// True for a door, false for a window.
bool is_door(const Piece& opening);

/// Name and place of a piece, for people: `"Bed" at (320, 145) cm on level0`.
std::string describe(const Piece& piece);

}  // namespace inhabit::io::sh3d
