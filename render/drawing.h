#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.h"
#include "geometry/polygon.h"

/// Pictures as plain data: shapes and text on a page, in points, x to the right and y down. One drawing becomes SVG,
/// PNG and PDF, so the three cannot differ.
namespace inhabit::render {
using namespace geometry;

struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
  double alpha = 1;
  friend bool operator==(const Color&, const Color&) = default;
};
/// 0xrrggbb.
constexpr Color rgb(std::uint32_t hex, double alpha = 1) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex),
          alpha};
}

/// Lines and cubic Bézier curves. `curve` takes three points, `move` and `line` one, `close` none.
struct Path {
  enum class Verb : std::uint8_t { move, line, curve, close };
  std::vector<Verb> verbs;
  std::vector<Vec2> points;

  Path& move(Vec2 p);
  Path& line(Vec2 p);
  Path& curve(Vec2 c1, Vec2 c2, Vec2 p);
  Path& close();
  Path& segment(Vec2 a, Vec2 b) { return move(a).line(b); }
  Path& polyline(std::span<const Vec2> p);
  Path& polygon(std::span<const Vec2> p);
  Path& polygon(const Box& box);
  /// The elliptic arc center + cos t · a + sin t · b for t from `from` to `to`; joined to the path by a line if it has
  /// begun. Error below 0.03 % of the radius.
  Path& arc(Vec2 center, Vec2 a, Vec2 b, double from, double to);
  Path& circle(Vec2 center, double radius);
};

struct Style {
  std::optional<Color> fill, stroke;
  double width = 1;
  double dash = 0, gap = 0;  ///< lengths of dashes and of the gaps between them; 0: a solid line
  bool round = false;        ///< round caps and joins instead of butt and mitre
  bool even_odd = false;
};

struct Shape {
  Path path;
  Style style;
};

enum class Anchor { start, middle, end };

/// One line of text. `angle` turns it clockwise on the page, radians.
struct Text {
  std::string text;
  Vec2 at;  ///< on the base line
  double size = 11;
  Color color;
  Anchor anchor = Anchor::start;
  bool bold = false;
  double angle = 0;
};

struct Drawing {
  Vec2 size{100, 100};
  Color background = rgb(0xffffff);
  std::string title;  ///< written into the file, not onto the page
  std::vector<std::variant<Shape, Text>> items;
};

void add(Drawing& drawing, Path path, const Style& style);
inline void fill(Drawing& drawing, Path path, Color color) { add(drawing, std::move(path), {.fill = color}); }
inline void stroke(Drawing& drawing, Path path, Color color, double width) {
  add(drawing, std::move(path), {.stroke = color, .width = width});
}
/// The text with control characters and bytes that are no UTF-8 replaced.
std::string printable(std::string_view text);
/// Puts a line of text, made printable, onto the page.
void write(Drawing& drawing, Text text);
/// Puts `part` onto `into`, scaled and then moved. Its background comes along unless it is transparent.
void place(Drawing& into, const Drawing& part, Vec2 at, double scale);

/// Width of a line of text on the page. The height of capitals is 0.73 of the size, that of a line 1.25.
double text_width(std::string_view text, double size, bool bold = false);
/// `text` cut with an ellipsis so that it is not wider than `width`.
std::string fitted(std::string_view text, double width, double size, bool bold = false);

enum class Format { svg, png, pdf };
/// By the extension of a file name, in any case; nothing when it is none of them.
std::optional<Format> format_of(std::string_view file_name);

struct EncodeOptions {
  int png_long_side = 1600;  ///< pixels, 16 … 16384
};
/// The file's bytes: the same for the same drawing, without dates. Errors: a page without area, an unusable pixel size.
Result<std::string> encode(const Drawing& drawing, Format format, const EncodeOptions& options = {});

/// A picture of whole pixels, row by row from the top: blue, green, red and one byte without meaning for each.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};
/// The drawing in pixels, as wide as asked for, over `under` when there is one. Requires: `under` has this width and
/// the height that the page's shape gives. Errors: no page, a side that is not within 1 … 16384.
Result<Pixels> rasterize(const Drawing& drawing, int width, const Pixels* under = nullptr);
/// The pixels as a PNG file.
Result<std::string> encode_png(const Pixels& pixels);

}  // namespace inhabit::render
