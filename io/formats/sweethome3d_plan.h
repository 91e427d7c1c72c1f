#pragma once
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/polygon.h"
#include "scene/scene.h"

/// Home.xml as plain data in the plan's own frame and units: centimetres, y down, radians clockwise on the screen.
namespace inhabit::io::sh3d {
using namespace core;
using namespace geometry;

/// A leaf of a door: it turns about `axis` (fractions of width and depth) from angle `start` to `end`.
struct Sash {
  double x_axis = 0, y_axis = 0, width = 0, start = 0, end = 0;
};

struct Piece {
  enum class Type { furniture, opening, group } type = Type::furniture;
  std::string path;  ///< place among the piece elements of its parent: "3", inside a group "3/0"
  std::string catalog_id, name, level;
  Vec2 p;
  double elevation = 0, angle = 0, width = 0, depth = 0, height = 0;
  double drop_on_top = 1;  ///< where things stand on it, share of its height; negative: nowhere
  bool visible = true, movable = true, mirrored = false;
  double wall_thickness = 1, wall_distance = 0;  ///< shares of the depth, openings only
  std::vector<Sash> sashes;
  std::vector<Piece> children;
  std::size_t offset = 0;  ///< of its element's name in the text
};

struct Wall {
  std::string level;
  Vec2 start, end;
  double thickness = 0, arc_extent = 0;
};

struct Room {
  std::string level, name;
  Ring points;
  bool floor_visible = true;
};

struct Level {
  std::string id;
  double height = 250;
};

struct Plan {
  double wall_height = 250;
  std::vector<Level> levels;
  std::vector<Piece> pieces;
  std::vector<Wall> walls;
  std::vector<Room> rooms;
};

/// True for the elements that are furniture of any sort.
bool is_piece_element(std::string_view name);

/// `Home.xml, line 3, column 7`.
std::string place_in(std::string_view xml, std::size_t offset);

/// Parses the text; no document type is accepted, so entities cannot expand.
Result<pugi::xml_document> parse_xml(std::string_view xml);

/// Reads and checks the plan. Every number must be finite and of a plausible size.
Result<Plan> read_plan(std::string_view xml);

/// The wall's centre line as points: two, or more for a round wall (at most 5 degrees or 20 cm each).
Ring center_line(const Wall& wall);

/// Plan centimetres to our metres and back.
constexpr Vec2 metres(Vec2 p) { return {p.x / 100, -p.y / 100}; }
constexpr Vec2 centimetres(Vec2 p) { return {p.x * 100, -p.y * 100}; }
/// The plan's angle of a thing whose front faces `angle` in our frame, and the reverse: the map is its own inverse.
inline double turn_angle(double angle) { return wrap_angle(-angle - kPi / 2); }

}  // namespace inhabit::io::sh3d
