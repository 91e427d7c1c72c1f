#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/text.h"
#include "io/formats/sweethome3d_archive.h"
#include "io/formats/sweethome3d_edit.h"
#include "io/formats/sweethome3d_new.h"
#include "io/formats/sweethome3d_scene.h"

namespace inhabit::io {
namespace sh3d {
namespace {

constexpr double kSamePlace = 1e-4;  // centimetres
constexpr double kSameAngle = 1e-6;  // radians: 0.1 micrometre at 10 cm

/// A pose in the plan: centimetres, radians.
struct Spot {
  Vec2 p;
  double elevation = 0, angle = 0;
};

/// A rigid move in the plan.
struct Move {
  Vec2 from, to;
  double turn = 0, rise = 0;
  Spot operator()(const Spot& s) const {
    return {to + rotate(s.p - from, direction(turn)), s.elevation + rise, s.angle + turn};
  }
};

using Targets = std::map<std::string, Spot, std::less<>>;

std::optional<nlohmann::json> origin_of(const scene::Extras& extras) {
  for (const auto& [key, text] : extras) {
    if (key != kOriginKey) continue;
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_object()) return json;
  }
  return std::nullopt;
}

Spot spot_of(const Piece& piece) { return {piece.p, piece.elevation, piece.angle}; }

bool same_place(const Spot& a, const Spot& b) {
  return std::abs(a.p.x - b.p.x) <= kSamePlace && std::abs(a.p.y - b.p.y) <= kSamePlace;
}
bool same_angle(const Spot& a, const Spot& b) { return std::abs(wrap_angle(a.angle - b.angle)) <= kSameAngle; }
bool same_height(const Spot& a, const Spot& b) { return std::abs(a.elevation - b.elevation) <= kSamePlace; }

/// Collects the edits of pieces that moved.
class Mover {
 public:
  Mover(std::string_view xml, const Targets& targets) : xml_(xml), targets_(targets) {}

  /// Moves everything below the piece; the rigid move that its first moved member made.
  std::optional<Move> visit(const Piece& piece) {
    if (piece.type != Piece::Type::group) {
      const auto target = targets_.find(piece.path);
      if (target == targets_.end()) return std::nullopt;
      return apply(piece, target->second);
    }
    std::optional<Move> move;
    for (const Piece& child : piece.children) {
      const auto made = visit(child);
      if (!move) move = made;
    }
    if (!move) return std::nullopt;
    // The group's own box, and what is in it but in no scene (invisible things), go along.
    for (const Piece& child : piece.children) carry_along(child, *move);
    write(piece, (*move)(spot_of(piece)));
    return move;
  }

  std::vector<Edit> edits;
  std::size_t moved = 0;

 private:
  std::optional<Move> apply(const Piece& piece, const Spot& to) {
    const Spot from = spot_of(piece);
    if (same_place(from, to) && same_angle(from, to) && same_height(from, to)) return std::nullopt;
    write(piece, to);
    ++moved;
    return Move{from.p, to.p, wrap_angle(to.angle - from.angle), to.elevation - from.elevation};
  }

  void carry_along(const Piece& piece, const Move& move) {
    if (piece.type == Piece::Type::opening || targets_.count(piece.path) > 0) return;
    if (piece.type == Piece::Type::group) {
      // A nested group with members in the scene has been written already.
      if (piece.visible && !piece.children.empty()) return;
      for (const Piece& child : piece.children) carry_along(child, move);
    }
    write(piece, move(spot_of(piece)));
  }

  void write(const Piece& piece, const Spot& to) {
    const Spot from = spot_of(piece);
    if (!same_place(from, to)) {
      set(piece, "x", float_text(to.p.x));
      set(piece, "y", float_text(to.p.y));
    }
    if (!same_angle(from, to)) {
      const double turned = wrap_angle(to.angle);
      set(piece, "angle", float_text(turned < 0 ? turned + 2 * kPi : turned));
    }
    if (!same_height(from, to)) set(piece, "elevation", float_text(to.elevation));
  }
  void set(const Piece& piece, std::string_view attribute, const std::string& value) {
    edits.push_back(set_attribute(xml_, piece.offset, attribute, value));
  }

  std::string_view xml_;
  const Targets& targets_;
};

void collect_paths(const std::vector<Piece>& pieces, std::map<std::string, const Piece*, std::less<>>& out) {
  for (const Piece& piece : pieces) {
    out.emplace(piece.path, &piece);
    collect_paths(piece.children, out);
  }
}

/// Where the furnished scenes want the home's pieces, and what they hold besides.
struct Wishes {
  Targets targets;
  std::string added;
  std::size_t count_added = 0;
  std::vector<std::string> warnings;
};

Result<Wishes> wishes_of(const Plan& plan, std::span<const scene::Scene> furnished) {
  std::map<std::string, const Piece*, std::less<>> paths;
  collect_paths(plan.pieces, paths);
  Wishes wishes;
  for (const scene::Scene& scene : furnished) {
    std::string level;
    const auto room = origin_of(scene.extras);
    if (room && room->contains("room") && (*room)["room"].is_number_unsigned()) {
      const std::size_t i = (*room)["room"].get<std::size_t>();
      if (i < plan.rooms.size()) level = plan.rooms[i].level;
    }
    for (const scene::Object& o : scene.objects) {
      const auto origin = origin_of(o.extras);
      if (!o.position || !o.angle) {
        wishes.warnings.push_back(o.id + " has no place in the scene and was left as it is");
        continue;
      }
      if (!origin || !origin->contains("piece")) {
        wishes.added += box_element(o, level);
        ++wishes.count_added;
        continue;
      }
      const nlohmann::json& piece = (*origin)["piece"];
      const std::string path = piece.is_string() ? piece.get<std::string>() : std::string();
      if (paths.count(path) == 0)
        return invalid(o.id,
                       "came from piece \"" + path + "\", which this home does not have; is it another home's scene?");
      wishes.targets[path] = {centimetres(o.position->xy()), o.position->z * 100, turn_angle(*o.angle)};
    }
  }
  return wishes;
}

void warn_of(const Stripped& stripped, std::vector<std::string>& warnings) {
  const auto say = [&](std::size_t n, const char* what) {
    if (n > 0) warnings.push_back(std::to_string(n) + what);
  };
  say(stripped.models, " models are not in the home's file and were left out: these pieces show as boxes");
  say(stripped.icons, " icons are not in the home's file and were left out");
  say(stripped.images, " textures are not in the home's file and were left out");
}

/// The place before `</home>`, or the edit that opens an empty `<home/>`.
Edit insertion(std::string_view xml, std::string text) {
  const std::size_t end = xml.rfind("</home");
  if (end != std::string_view::npos) return {end, 0, std::move(text)};
  const std::size_t close = xml.rfind("/>");
  return {close, 2, std::string(">").append(text).append("</home>")};
}

}  // namespace

Result<Sh3dFile> packed(const std::string& archive, const std::string& xml, const std::vector<std::string>& entries) {
  const auto document = parse_xml(xml);
  if (!document) return document.error();
  Sh3dFile file;
  file.xml = xml;
  const Stripped stripped = strip_missing(xml, *document, {entries.begin(), entries.end()});
  warn_of(stripped, file.warnings);
  const bool stale = std::find(entries.begin(), entries.end(), "Home") != entries.end();
  if (stale) file.warnings.push_back("the Java-serialised copy of the home was left out: it would no longer be true");
  auto bytes = with_entry(archive, "Home.xml", edited(xml, stripped.edits), {"Home", "ContentDigests"});
  if (!bytes) return bytes.error();
  file.bytes = std::move(*bytes);
  return file;
}

}  // namespace sh3d

Result<Sh3dHome> open_sh3d(std::string bytes) {
  using namespace sh3d;
  Sh3dHome home;
  if (is_zip(bytes)) {
    auto names = entry_names(bytes);
    if (!names) return names.error();
    home.entries = std::move(*names);
    const auto has = [&](const char* name) {
      return std::find(home.entries.begin(), home.entries.end(), name) != home.entries.end();
    };
    if (!has("Home.xml") && has("Home"))
      return Error{ErrorCode::unsupported,
                   "holds only the Java-serialised home of Sweet Home 3D before 5.3; open and save it in a newer one",
                   "Home"};
    if (!has("Home.xml")) return invalid("", "the zip archive holds no Home.xml; is this a .sh3d file?");
    auto xml = read_entry(bytes, "Home.xml");
    if (!xml) return xml.error();
    home.xml = std::move(*xml);
    home.archive = std::move(bytes);
  } else {
    home.xml = std::move(bytes);
    if (home.xml.find('<') == std::string::npos) return invalid("", "is neither a .sh3d archive nor a Home.xml");
  }
  const auto plan = read_plan(home.xml);
  if (!plan) return plan.error();
  return home;
}

Result<Sh3dFile> write_sh3d(const Sh3dHome& home, std::span<const scene::Scene> furnished) {
  using namespace sh3d;
  const auto plan = read_plan(home.xml);
  if (!plan) return plan.error();
  auto wishes = wishes_of(*plan, furnished);
  if (!wishes) return wishes.error();
  Mover mover(home.xml, wishes->targets);
  for (const Piece& piece : plan->pieces) mover.visit(piece);
  if (!wishes->added.empty()) mover.edits.push_back(insertion(home.xml, wishes->added));
  if (mover.edits.empty() && !home.archive.empty()) return Sh3dFile{home.archive, home.xml, 0, 0, wishes->warnings};
  auto file = packed(home.archive, edited(home.xml, mover.edits), home.entries);
  if (!file) return file.error();
  file->moved = mover.moved;
  file->added = wishes->count_added;
  file->warnings.insert(file->warnings.begin(), wishes->warnings.begin(), wishes->warnings.end());
  return file;
}

}  // namespace inhabit::io
