#include "io/formats/procthor.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "io/json_text.h"
#include "io/plan_import.h"

namespace inhabit::io {
namespace {

/// What stands higher above the floor than this without a parent hangs on the wall, metres.
constexpr double kHangs = 0.1;
constexpr double kAtWall = 0.05;
constexpr double kThinnest = 1e-3;

/// `TVStand` as `tv_stand`.
std::string kind_of(std::string_view type) {
  const auto upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  std::string kind;
  for (std::size_t i = 0; i < type.size(); ++i) {
    const bool starts =
        upper(type[i]) && i > 0 && (!upper(type[i - 1]) || (i + 1 < type.size() && !upper(type[i + 1])));
    if (starts) kind += '_';
    kind += upper(type[i]) ? static_cast<char>(type[i] + 32) : type[i];
  }
  return kind;
}

class HouseReader {
 public:
  explicit HouseReader(const Assets& assets) : assets_(assets) {}

  std::vector<Scene> scenes;
  std::optional<Error> error;

  bool read(JsonValue house) {
    if (!house.is(Json::object)) return fail(house, "a house is an object");
    const JsonValue rooms = house.find("rooms");
    if (rooms.none() || !rooms.is(Json::array) || rooms.size() == 0) return fail(house, "there are no rooms in it");
    for (const JsonValue room : rooms) {
      if (!read_room(room)) return false;
    }
    return read_walls(house) && read_openings<Door>(house, "doors") && read_openings<Window>(house, "windows") &&
           read_objects(house.find("objects"), nullptr, 0);
  }

 private:
  struct Wall {
    Vec2 start, end;
  };

  bool fail(JsonValue at, std::string message) {
    if (!error) error = at.error(std::move(message));
    return false;
  }
  bool number(JsonValue object, std::string_view name, double& out) {
    const JsonValue v = object.find(name);
    if (v.none() || !v.is(Json::number)) return fail(object, quoted(name) + " is no number");
    if (!(std::abs(v.number()) <= 1e5))
      return fail(v, std::string(v.text().substr(0, 40)) + " is outside [-100000, 100000]");
    out = v.number();
    return true;
  }
  /// {x, y, z} of Unity as ours: y and z change places.
  bool point(JsonValue object, Vec3& out) {
    return number(object, "x", out.x) && number(object, "z", out.y) && number(object, "y", out.z);
  }
  std::string text(JsonValue object, std::string_view name) {
    const JsonValue v = object.find(name);
    return !v.none() && v.is(Json::text) ? std::string(v.text()) : "";
  }
  std::string unique_id(std::string id) {
    if (id.empty()) id = "object";
    for (int k = 2; !ids_.insert(id).second; ++k) {
      const std::size_t dash = id.rfind("--");
      id = id.substr(0, dash) + "--" + std::to_string(std::max<int>(k, static_cast<int>(ids_.size())));
    }
    return id;
  }

  bool read_room(JsonValue room) {
    const JsonValue polygon = room.find("floorPolygon");
    if (polygon.none() || !polygon.is(Json::array)) return fail(room, "\"floorPolygon\" is missing");
    Area area;
    for (const JsonValue corner : polygon) {
      Vec3 p;
      if (!point(corner, p)) return false;
      area.outline.push_back(p.xy());
    }
    area = tidied(std::move(area));
    if (const auto why = why_not_simple(area.outline)) return fail(polygon, *why);
    Scene& scene = scenes.emplace_back();
    scene.name = text(room, "roomType");
    scene.space.outline = std::move(area.outline);
    if (const std::string id = text(room, "id"); !id.empty()) scene.extras.emplace_back("x-room", json_text(id));
    return true;
  }

  bool read_walls(JsonValue house) {
    const JsonValue list = house.find("walls");
    if (list.none()) return true;
    double height = 0;
    for (const JsonValue wall : list) {
      const JsonValue polygon = wall.find("polygon");
      if (polygon.none() || polygon.size() < 2) continue;
      Vec3 corners[2], p;
      std::size_t i = 0;
      for (const JsonValue corner : polygon) {
        if (!point(corner, p)) return false;
        if (i < 2) corners[i++] = p;
        height = std::max(height, p.z);
      }
      walls_.try_emplace(text(wall, "id"), Wall{corners[0].xy(), corners[1].xy()});
    }
    for (Scene& scene : scenes) {
      if (height >= 0.1 && height <= 1e3) scene.space.height = height;
    }
    return true;
  }

  template <class Opening>
  bool read_openings(JsonValue house, std::string_view name) {
    const JsonValue list = house.find(name);
    if (list.none()) return true;
    for (const JsonValue v : list) {
      const auto wall = walls_.find(text(v, "wall0"));
      if (wall == walls_.end()) return fail(v, "there is no wall " + quoted(text(v, "wall0")));
      const JsonValue hole = v.find("holePolygon");
      if (hole.none() || hole.size() < 2) return fail(v, "\"holePolygon\" has less than two corners");
      Vec3 a, b, *next = &a;
      for (const JsonValue corner : hole) {
        if (!point(corner, *next)) return false;
        if (next == &b) break;
        next = &b;
      }
      const Vec2 along = unit(wall->second.end - wall->second.start);
      Opening opening{unique_id(text(v, "id"))};
      const double low = std::min(a.z, b.z), high = std::max(a.z, b.z);
      opening.height = std::clamp(high - low, 0.01, 1e3);
      if constexpr (std::is_same_v<Opening, Window>) opening.sill = std::clamp(low, 0.0, 1e3);
      if constexpr (std::is_same_v<Opening, Door>)
        opening.swing = v.find("openable").none() || v.find("openable").boolean() ? Door::Swing::in : Door::Swing::none;
      place(opening, wall->second.start + a.x * along, wall->second.start + b.x * along);
    }
    return true;
  }
  /// Into every room that has a wall there: a door between two rooms is a door of both.
  template <class Opening>
  void place(Opening opening, Vec2 a, Vec2 b) {
    for (Scene& scene : scenes) {
      Space& space = scene.space;
      for (std::size_t k = 0; k < space.walls(); ++k) {
        const Vec2 start = space.wall_start(k), along = unit(space.wall_end(k) - start);
        if (std::abs(cross(along, a - start)) > kAtWall || std::abs(cross(along, b - start)) > kAtWall) continue;
        const double wall = length(space.wall_end(k) - start), s = dot(a - start, along), t = dot(b - start, along);
        const double from = std::max(std::min(s, t), 0.0), to = std::min(std::max(s, t), wall);
        if (to - from < 0.05) continue;
        opening.wall = static_cast<int>(k), opening.from = from, opening.width = to - from;
        if constexpr (std::is_same_v<Opening, Door>) {
          space.doors.push_back(opening);
        } else {
          space.windows.push_back(opening);
        }
        break;
      }
    }
  }

  std::size_t room_of(Vec2 p) const {
    std::size_t best = 0;
    double nearest = 1e300;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const Ring& outline = scenes[i].space.outline;
      if (contains(outline, p)) return i;
      if (const double d = nearest_on_ring(outline, p).distance; d < nearest) nearest = d, best = i;
    }
    return best;
  }

  /// Children stay in the room of their parents, on whose index they refer to.
  struct Parent {
    std::size_t room = 0;
    std::uint32_t index = 0;
  };
  bool read_objects(JsonValue list, const Parent* parent, int depth) {
    if (list.none() || list.is(Json::null)) return true;
    if (!list.is(Json::array) || depth > 16) return fail(list, "is no list of objects");
    for (const JsonValue v : list) {
      if (!read_object(v, parent, depth)) return false;
    }
    return true;
  }
  bool read_object(JsonValue v, const Parent* parent, int depth) {
    if (!v.is(Json::object)) return fail(v, "is no object");
    const std::string asset_id = text(v, "assetId");
    const auto asset = assets_.find(asset_id);
    if (asset == assets_.end()) return fail(v, "the asset database does not know " + quoted(asset_id));
    const JsonValue position = v.find("position"), rotation = v.find("rotation");
    if (position.none()) return fail(v, "\"position\" is missing");
    Vec3 p;
    double yaw = 0;
    if (!point(position, p) || (!rotation.none() && !number(rotation, "y", yaw))) return false;
    Object o{unique_id(text(v, "id")), asset->second.kind};
    o.size = asset->second.size;
    p.z -= o.size.z / 2;
    if (std::abs(p.z) < 1e-3) p.z = 0;  // stands on the floor, to within what their physics engine leaves
    o.position = p;
    o.angle = radians(std::round(std::remainder(90 - yaw, 360.0) * 1e9) / 1e9);
    o.extras.emplace_back("x-asset", json_text(asset_id));
    if (!rotation.none()) note_tilt(rotation, o);
    const Parent self{parent != nullptr ? parent->room : room_of(p.xy()), 0};
    std::vector<Object>& objects = scenes[self.room].objects;
    if (parent != nullptr) {
      o.on = {Ref::Kind::object, parent->index};
    } else if (p.z > kHangs) {
      o.mount = Mount::wall;
    }
    objects.push_back(std::move(o));
    const Parent here{self.room, static_cast<std::uint32_t>(objects.size() - 1)};
    return read_objects(v.find("children"), &here, depth + 1);
  }
  static void note_tilt(JsonValue rotation, Object& o) {
    const JsonValue x = rotation.find("x"), z = rotation.find("z");
    const double about_x = !x.none() && x.is(Json::number) ? x.number() : 0,
                 about_z = !z.none() && z.is(Json::number) ? z.number() : 0;
    if (std::abs(about_x) > 1 || std::abs(about_z) > 1)
      o.extras.emplace_back("x-tilt", std::string("[") + number_text(about_x) + ", " + number_text(about_z) + "]");
  }

  const Assets& assets_;
  std::map<std::string, Wall, std::less<>> walls_;
  std::set<std::string> ids_;
};

Result<std::vector<Scene>> read_house(std::string_view text, const Assets& assets) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  HouseReader reader(assets);
  if (!reader.read(document->root())) return *reader.error;
  return std::move(reader.scenes);
}

std::string_view next_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line.find_first_not_of(" \t\r") == std::string_view::npos ? std::string_view{} : line;
}

/// One document per line, and not one document over many lines: its first line is a whole document and not the only
/// one.
bool has_house_per_line(std::string_view text) {
  std::string_view line;
  while (line.empty() && !text.empty()) line = next_line(text);
  return line.find_last_not_of(" \t\r") != std::string_view::npos && line[line.find_last_not_of(" \t\r")] == '}' &&
         line[0] == '{' && text.find('{') != std::string_view::npos && JsonDocument::parse(line).ok();
}

}  // namespace

Result<Assets> read_procthor_assets(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  const JsonValue root = document->root();
  if (!root.is(Json::object)) return root.error("an asset database is an object");
  Assets assets;
  for (const JsonValue type : root) {
    for (const JsonValue asset : type) {
      const JsonValue id = asset.find("assetId"), box = asset.find("boundingBox");
      if (id.none() || !id.is(Json::text) || box.none())
        return asset.error("\"assetId\" or \"boundingBox\" is missing");
      double size[3] = {};
      const std::string_view names[3] = {"x", "z", "y"};
      for (int k = 0; k < 3; ++k) {
        const JsonValue v = box.find(names[k]);
        if (v.none() || !v.is(Json::number) || !(v.number() >= 0 && v.number() <= 1e3))
          return box.error("is no box within [0, 1000] m");
        size[k] = std::max(v.number(), kThinnest);
      }
      assets.insert_or_assign(std::string(id.text()), Asset{{size[0], size[1], size[2]}, kind_of(type.key())});
    }
  }
  return assets;
}

Result<std::vector<Scene>> read_procthor(std::string_view text, const Assets& assets, std::size_t line) {
  if (!has_house_per_line(text)) {
    if (line > 1) return invalid("", "there is only one house in it");
    return read_house(text, assets);
  }
  std::vector<Scene> scenes;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view house = next_line(text);
    if (house.empty() || (line != 0 && line != number)) continue;
    Result<std::vector<Scene>> rooms = read_house(house, assets);
    if (!rooms)
      return invalid("line " + std::to_string(number) + (rooms.error().where.empty() ? "" : ", ") + rooms.error().where,
                     rooms.error().message);
    std::ranges::move(*rooms, std::back_inserter(scenes));
  }
  if (scenes.empty()) return invalid("", "there is no line " + std::to_string(line) + " in it");
  return scenes;
}

}  // namespace inhabit::io
