#include "io/formats/geojson.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "io/json_text.h"
#include "io/plan_import.h"

namespace inhabit::io {
namespace {

/// How far a door may be drawn from the outline of its room, metres: the wall lies between.
constexpr double kReach = 0.3;
/// Pieces between walls that are smaller than this are no rooms, square metres.
constexpr double kSmallestRoom = 1.5;

struct Feature {
  Area area;
  std::string type, name;
};

class GeoReader {
 public:
  std::vector<Feature> features;
  std::optional<Error> error;

  bool read(JsonValue v, const Feature& about, int depth = 0) {
    if (!v.is(Json::object) || depth > 16) return fail(v, "is no GeoJSON object");
    const JsonValue type = v.find("type");
    if (type.none() || !type.is(Json::text)) return fail(v, "\"type\" is missing");
    if (type.text() == "FeatureCollection") return each(v, "features", about, depth);
    if (type.text() == "GeometryCollection") return each(v, "geometries", about, depth);
    if (type.text() == "Feature") return feature(v, depth);
    static constexpr std::string_view kOthers[] = {"Point", "LineString", "MultiPoint", "MultiLineString"};
    if (std::ranges::find(kOthers, type.text()) != std::end(kOthers)) return true;
    const JsonValue coordinates = v.find("coordinates");
    if (type.text() != "Polygon" && type.text() != "MultiPolygon") {
      static constexpr std::string_view kAll[] = {"FeatureCollection", "Feature", "GeometryCollection", "Polygon",
                                                  "MultiPolygon"};
      return fail(type, "unknown type " + quoted(type.text()) + did_you_mean(type.text(), kAll));
    }
    if (coordinates.none() || !coordinates.is(Json::array)) return fail(v, "\"coordinates\" is missing");
    if (type.text() == "Polygon") return polygon(coordinates, about);
    return std::all_of(coordinates.begin(), coordinates.end(), [&](JsonValue p) { return polygon(p, about); });
  }

 private:
  bool fail(JsonValue at, std::string message) {
    if (!error) error = at.error(std::move(message));
    return false;
  }
  bool each(JsonValue v, std::string_view list, const Feature& about, int depth) {
    const JsonValue items = v.find(list);
    if (items.none() || !items.is(Json::array)) return fail(v, quoted(list) + " is missing");
    return std::all_of(items.begin(), items.end(), [&](JsonValue item) { return read(item, about, depth + 1); });
  }
  bool feature(JsonValue v, int depth) {
    const JsonValue geometry = v.find("geometry"), properties = v.find("properties");
    if (geometry.none() || geometry.is(Json::null)) return true;
    Feature about;
    if (!properties.none()) {
      if (const JsonValue type = properties.find("type"); !type.none() && type.is(Json::text)) about.type = type.text();
      if (const JsonValue name = properties.find("name"); !name.none() && name.is(Json::text)) about.name = name.text();
    }
    return read(geometry, about, depth + 1);
  }
  bool polygon(JsonValue rings, const Feature& about) {
    if (!rings.is(Json::array) || rings.size() == 0) return fail(rings, "a polygon is a list of rings");
    Feature f{{}, about.type, about.name};
    bool first = true;
    for (const JsonValue v : rings) {
      Ring ring;
      if (!v.is(Json::array)) return fail(v, "a ring is a list of positions");
      for (const JsonValue position : v) {
        if (!corner(position, ring)) return false;
      }
      if (ring.size() < 4 || ring.front() != ring.back())
        return fail(v, "a ring has four positions or more and ends where it starts");
      (first ? f.area.outline : f.area.holes.emplace_back()) = std::move(ring);
      first = false;
    }
    features.push_back(std::move(f));
    return true;
  }
  bool corner(JsonValue v, Ring& ring) {
    if (!v.is(Json::array) || v.size() < 2) return fail(v, "a position is two numbers or more");
    Vec2 p;
    std::size_t i = 0;
    for (const JsonValue number : v) {
      if (!number.is(Json::number)) return fail(number, "is no number");
      if (!(std::abs(number.number()) <= 1e9)) return fail(number, "is too large for a coordinate");
      if (i == 0) p.x = number.number();
      if (i == 1) p.y = number.number();
      ++i;
    }
    ring.push_back(p);
    return true;
  }
};

/// True when the document's `crs` names WGS84 in degrees; nothing when it has none.
std::optional<bool> says_degrees(JsonValue root) {
  const JsonValue crs = root.find("crs");
  if (crs.none() || !crs.is(Json::object)) return std::nullopt;
  const JsonValue properties = crs.find("properties");
  const JsonValue name = properties.none() ? properties : properties.find("name");
  if (name.none() || !name.is(Json::text)) return std::nullopt;
  const std::string_view text = name.text();
  return text.ends_with("CRS84") || text.ends_with(":4326");
}

Bounds bounds_of(const std::vector<Feature>& features) {
  Bounds all;
  for (const Feature& f : features) {
    for (const Vec2 p : f.area.outline) all.add(p);
  }
  return all;
}

bool is_degrees(JsonValue root, const Bounds& all) {
  const bool in_range = all.min.x >= -180 && all.max.x <= 180 && all.min.y >= -90 && all.max.y <= 90;
  const std::optional<bool> said = says_degrees(root);
  if (said) return *said && in_range;
  return in_range && all.size().x <= 0.2 && all.size().y <= 0.2;
}

/// Degrees to metres about `middle` (radii of curvature of the WGS84 ellipsoid).
void project(std::vector<Feature>& features, Vec2 middle) {
  constexpr double kA = 6378137, kE2 = 0.00669437999014;
  const SinCos lat = sin_cos(radians(middle.y));
  const double w = 1 - kE2 * lat.sin * lat.sin;
  const double n = kA / std::sqrt(w), m = kA * (1 - kE2) / (w * std::sqrt(w));
  const auto move = [&](Ring& ring) {
    for (Vec2& p : ring) p = {n * lat.cos * radians(p.x - middle.x), m * radians(p.y - middle.y)};
  };
  for (Feature& f : features) {
    move(f.area.outline);
    for (Ring& hole : f.area.holes) move(hole);
  }
}

bool is_one_of(std::string_view type, std::initializer_list<std::string_view> types) {
  return std::ranges::find(types, type) != types.end();
}

bool is_room(const Feature& f) { return is_one_of(f.type, {"room", "bathroom", "hallway", "unit"}); }
bool is_no_room(const Feature& f) {
  return is_one_of(
      f.type, {"wall", "door", "window", "stairs", "elevator", "escalator", "inaccessible_space", "floor_opening"});
}

/// What the walls and the rooms that somebody drew leave of the building.
std::vector<Feature> rooms_between_walls(const std::vector<Feature>& features) {
  std::vector<Area> building;
  std::vector<Ring> taken;
  for (const Feature& f : features) {
    if (f.type == "building_outline") building.push_back(f.area);
    if (!is_no_room(f) && !is_room(f)) continue;
    // A wall may run round a room: then its holes are not wall.
    if (f.area.holes.empty()) {
      taken.push_back(f.area.outline);
      continue;
    }
    for (const Area& part : difference({f.area}, {}, 0)) taken.push_back(part.outline);
  }
  std::vector<Feature> rooms;
  for (Area& area : difference(building, taken, 1e-3)) {
    if (signed_area(area.outline) >= kSmallestRoom) rooms.push_back({std::move(area), "room", ""});
  }
  return rooms;
}

std::vector<Feature> choose_rooms(const std::vector<Feature>& features) {
  std::vector<Feature> rooms;
  const auto copy_all = [&](auto wanted) { std::ranges::copy_if(features, std::back_inserter(rooms), wanted); };
  copy_all(is_room);
  std::ranges::move(rooms_between_walls(features), std::back_inserter(rooms));
  if (rooms.empty()) copy_all([](const Feature& f) { return f.type == "building_outline"; });
  if (rooms.empty()) copy_all([](const Feature&) { return true; });
  return rooms;
}

}  // namespace

Result<std::vector<Scene>> read_geojson(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  GeoReader reader;
  if (!reader.read(document->root(), {})) return *reader.error;
  std::vector<Feature>& features = reader.features;
  if (features.empty()) return invalid("", "there is no polygon in it");
  std::string origin;
  if (const Bounds all = bounds_of(features); is_degrees(document->root(), all)) {
    const Vec2 middle = all.center();
    project(features, middle);
    origin = std::string(R"({"lon": )") + number_text(middle.x) + R"(, "lat": )" + number_text(middle.y) + "}";
  }
  std::vector<DrawnOpening> openings;
  for (Feature& f : features) {
    if (is_one_of(f.type, {"door", "window"})) openings.push_back({f.area.outline, f.type == "window"});
  }
  std::vector<Scene> scenes;
  std::optional<Error> first_error;
  for (Feature& room : choose_rooms(features)) {
    Result<std::vector<Scene>> parts = scenes_of({std::move(room.area)}, room.name);
    if (!parts) {
      if (!first_error) first_error = parts.error();
      continue;
    }
    for (Scene& scene : *parts) {
      add_openings(scene.space, openings, kReach);
      if (!origin.empty()) scene.extras.emplace_back("x-origin", origin);
      if (!room.type.empty()) scene.extras.emplace_back("x-type", json_text(room.type));
      scenes.push_back(std::move(scene));
    }
  }
  if (scenes.empty()) return first_error.value_or(invalid("", "there is no polygon in it"));
  return scenes;
}

}  // namespace inhabit::io
