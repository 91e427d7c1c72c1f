#include "io/formats/sweethome3d_plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/text.h"

namespace inhabit::io::sh3d {
namespace {

constexpr double kLargestLength = 1e7;  // 100 km in centimetres
constexpr double kLargestAngle = 1e4;
constexpr int kDeepestGroup = 32;
constexpr std::size_t kMostElements = 20000;  // pieces, walls, rooms: far beyond any home, and keeps n^2 steps short
constexpr std::size_t kMostPoints = 200000;

/// Reads attributes and remembers the first thing that is wrong.
struct Reader {
  std::string_view xml;
  std::optional<Error> error;
  std::size_t elements = 0, points = 0;

  void fail(const pugi::xml_node& node, const std::string& message) {
    if (error) return;
    error = invalid(place_in(xml, static_cast<std::size_t>(node.offset_debug())),
                    std::string("<").append(node.name()).append("> ").append(message));
  }

  double number(const pugi::xml_node& node, const char* name, std::optional<double> absent, double low, double high) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) {
      if (!absent) fail(node, std::string("has no ").append(name));
      return absent.value_or(0);
    }
    std::string_view text = attribute.value();
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string quoted = std::string(name).append("='").append(text.substr(0, 40)).append("'");
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      fail(node, quoted + " is no number");
      return 0;
    }
    if (value < low || value > high) {
      fail(node, quoted + " is outside [" + shortest(low) + ", " + shortest(high) + "]");
      return 0;
    }
    return value;
  }
  double length(const pugi::xml_node& node, const char* name, std::optional<double> absent = {}) {
    return number(node, name, absent, -kLargestLength, kLargestLength);
  }
  double size(const pugi::xml_node& node, const char* name) { return number(node, name, {}, 1e-6, kLargestLength); }
  double angle(const pugi::xml_node& node, const char* name) {
    return number(node, name, 0.0, -kLargestAngle, kLargestAngle);
  }
  double share(const pugi::xml_node& node, const char* name, double absent) {
    return number(node, name, absent, -1e6, 1e6);
  }
  bool flag(const pugi::xml_node& node, const char* name, bool absent) {
    const pugi::xml_attribute attribute = node.attribute(name);
    return attribute ? std::string_view(attribute.value()) == "true" : absent;
  }
  void count(const pugi::xml_node& node) {
    if (++elements > kMostElements) fail(node, "is one element too many; a home has at most 20000");
  }
};

std::vector<Piece> read_pieces(Reader& in, const pugi::xml_node& parent, const std::string& prefix, int depth);

Piece read_piece(Reader& in, const pugi::xml_node& node, std::string path, int depth) {
  const std::string_view tag = node.name();
  Piece p;
  p.type = tag == "furnitureGroup" ? Piece::Type::group
           : tag == "doorOrWindow" ? Piece::Type::opening
                                   : Piece::Type::furniture;
  p.path = std::move(path);
  p.catalog_id = node.attribute("catalogId").value();
  p.name = node.attribute("name").value();
  p.level = node.attribute("level").value();
  p.offset = static_cast<std::size_t>(node.offset_debug());
  const bool group = p.type == Piece::Type::group;
  // A group's own box is computed from its members by Sweet Home 3D, so that it may be missing.
  p.p = {in.length(node, "x", group ? std::optional(0.0) : std::nullopt),
         in.length(node, "y", group ? std::optional(0.0) : std::nullopt)};
  p.elevation = in.length(node, "elevation", 0.0);
  p.angle = in.angle(node, "angle");
  if (!group) {
    // Pieces turned about a horizontal axis say how large they are in the plan.
    p.width = in.size(node, node.attribute("widthInPlan") ? "widthInPlan" : "width");
    p.depth = in.size(node, node.attribute("depthInPlan") ? "depthInPlan" : "depth");
    p.height = in.size(node, node.attribute("heightInPlan") ? "heightInPlan" : "height");
  }
  p.drop_on_top = in.share(node, "dropOnTopElevation", 1);
  p.visible = in.flag(node, "visible", true);
  p.movable = in.flag(node, "movable", true);
  p.mirrored = in.flag(node, "modelMirrored", false);
  p.wall_thickness = in.share(node, "wallThickness", 1);
  p.wall_distance = in.share(node, "wallDistance", 0);
  if (p.type == Piece::Type::opening) {
    for (const pugi::xml_node& sash : node.children("sash")) {
      in.count(sash);
      p.sashes.push_back({in.share(sash, "xAxis", 0), in.share(sash, "yAxis", 0), in.share(sash, "width", 0),
                          in.angle(sash, "startAngle"), in.angle(sash, "endAngle")});
    }
  }
  if (group && depth >= kDeepestGroup) in.fail(node, "is nested too deeply in groups");
  if (group && !in.error) p.children = read_pieces(in, node, p.path + "/", depth + 1);
  return p;
}

std::vector<Piece> read_pieces(Reader& in, const pugi::xml_node& parent, const std::string& prefix, int depth) {
  std::vector<Piece> pieces;
  for (const pugi::xml_node& node : parent.children()) {
    if (!is_piece_element(node.name())) continue;
    in.count(node);
    if (in.error) break;
    pieces.push_back(read_piece(in, node, prefix + std::to_string(pieces.size()), depth));
  }
  return pieces;
}

Room read_room(Reader& in, const pugi::xml_node& node) {
  Room room{node.attribute("level").value(), node.attribute("name").value(), {}, in.flag(node, "floorVisible", true)};
  for (const pugi::xml_node& point : node.children("point")) {
    if (++in.points > kMostPoints) in.fail(point, "is one point too many; a home has at most 200000");
    if (in.error) break;
    room.points.push_back({in.length(point, "x"), in.length(point, "y")});
  }
  return room;
}

}  // namespace

bool is_piece_element(std::string_view name) {
  return name == "pieceOfFurniture" || name == "doorOrWindow" || name == "light" || name == "shelfUnit" ||
         name == "furnitureGroup";
}

std::string place_in(std::string_view xml, std::size_t offset) {
  const std::string_view before = xml.substr(0, std::min(offset, xml.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return std::string("Home.xml, line ").append(std::to_string(line)).append(", column ").append(std::to_string(column));
}

/// The first reference to an entity that XML itself does not define; without a document type nothing else does.
std::size_t undefined_entity(std::string_view xml) {
  constexpr std::string_view kDefined[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;", "&#"};
  for (std::size_t i = 0; i < xml.size(); ++i) {
    const std::string_view rest = xml.substr(i);
    if (rest.starts_with("<!--")) i = std::min(xml.size(), xml.find("-->", i)) - 1;
    if (rest.starts_with("<![CDATA[")) i = std::min(xml.size(), xml.find("]]>", i)) - 1;
    if (rest.front() == '&' && std::ranges::none_of(kDefined, [&](std::string_view e) { return rest.starts_with(e); }))
      return i;
  }
  return std::string_view::npos;
}

Result<pugi::xml_document> parse_xml(std::string_view xml) {
  if (!is_utf8(xml)) return invalid("Home.xml", "is not UTF-8");
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(
      xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_declaration, pugi::encoding_utf8);
  if (!parsed) return invalid(place_in(xml, static_cast<std::size_t>(parsed.offset)), parsed.description());
  for (const pugi::xml_node& node : document.children()) {
    if (node.type() == pugi::node_doctype) return invalid("Home.xml", "a document type (DOCTYPE) is not accepted");
    if (node.type() != pugi::node_declaration) continue;
    std::string encoding = node.attribute("encoding").value();
    std::transform(encoding.begin(), encoding.end(), encoding.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (!encoding.empty() && encoding != "utf-8" && encoding != "utf8" && encoding != "us-ascii")
      return Error{ErrorCode::unsupported, "the encoding is " + encoding.substr(0, 40) + ", not UTF-8", "Home.xml"};
  }
  if (const std::size_t entity = undefined_entity(xml); entity != std::string_view::npos)
    return invalid(place_in(xml, entity), "an entity that is not defined, or an & that should be &amp;");
  if (!document.child("home")) return invalid("Home.xml", "has no <home> element; is this a home of Sweet Home 3D?");
  return document;
}

Result<Plan> read_plan(std::string_view xml) {
  const auto document = parse_xml(xml);
  if (!document) return document.error();
  const pugi::xml_node home = document->child("home");
  Reader in{xml, {}};
  Plan plan;
  plan.wall_height = in.number(home, "wallHeight", 250.0, 1, kLargestLength);
  plan.pieces = read_pieces(in, home, "", 0);
  for (const pugi::xml_node& node : home.children()) {
    const std::string_view tag = node.name();
    if (tag != "level" && tag != "wall" && tag != "room") continue;
    in.count(node);
    if (in.error) break;
    if (tag == "level") {
      plan.levels.push_back({node.attribute("id").value(), in.number(node, "height", 250.0, 1, kLargestLength)});
    } else if (tag == "wall") {
      plan.walls.push_back({node.attribute("level").value(),
                            {in.length(node, "xStart"), in.length(node, "yStart")},
                            {in.length(node, "xEnd"), in.length(node, "yEnd")},
                            in.number(node, "thickness", 7.5, 0, 1e5),
                            in.number(node, "arcExtent", 0.0, -2 * kPi, 2 * kPi)});
    } else {
      plan.rooms.push_back(read_room(in, node));
    }
  }
  if (in.error) return *in.error;
  return plan;
}

Ring center_line(const Wall& wall) {
  const Vec2 chord = wall.end - wall.start;
  const double length_of_chord = length(chord), extent = wall.arc_extent;
  if (std::abs(extent) < 1e-3 || std::abs(extent) > 2 * kPi - 1e-3 || length_of_chord < 1e-3)
    return {wall.start, wall.end};
  // A positive extent bulges to the screen's left of the wall, so that the centre lies to its right (below pi).
  const Vec2 right{-chord.y, chord.x};
  const Vec2 center = 0.5 * (wall.start + wall.end) + (0.5 / std::tan(extent / 2)) * right;
  const Vec2 arm = wall.start - center;
  const double steps = std::max(std::abs(extent) / radians(5), std::abs(extent) * length(arm) / 20);
  const int n = static_cast<int>(std::clamp(std::ceil(steps), 2.0, 360.0));
  Ring line;
  for (int i = 0; i <= n; ++i) line.push_back(center + rotate(arm, direction(extent * i / n)));
  line.back() = wall.end;
  return line;
}

}  // namespace inhabit::io::sh3d
