#include "render/drawing.h"

#include "core/text.h"

namespace inhabit::render {

Path& Path::move(Vec2 p) {
  verbs.push_back(Verb::move);
  points.push_back(p);
  return *this;
}

Path& Path::line(Vec2 p) {
  verbs.push_back(Verb::line);
  points.push_back(p);
  return *this;
}

Path& Path::curve(Vec2 c1, Vec2 c2, Vec2 p) {
  verbs.push_back(Verb::curve);
  points.insert(points.end(), {c1, c2, p});
  return *this;
}

Path& Path::close() {
  verbs.push_back(Verb::close);
  return *this;
}

Path& Path::polyline(std::span<const Vec2> p) {
  for (std::size_t i = 0; i < p.size(); ++i) i == 0 ? move(p[i]) : line(p[i]);
  return *this;
}

Path& Path::polygon(std::span<const Vec2> p) { return p.empty() ? *this : polyline(p).close(); }

Path& Path::polygon(const Box& box) {
  const auto corners = box.corners();
  return polygon(std::span<const Vec2>(corners));
}

Path& Path::arc(Vec2 center, Vec2 a, Vec2 b, double from, double to) {
  // Quarter turns at most: a cubic with control points at 4/3 tan(step / 4) of the tangent.
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (kPi / 2) - 1e-9)));
  const double step = (to - from) / pieces;
  const SinCos quarter = sin_cos(step / 4);
  const double k = 4.0 / 3.0 * quarter.sin / quarter.cos;
  const auto at = [&](double t) {
    const SinCos sc = sin_cos(t);
    return std::pair{center + sc.cos * a + sc.sin * b, sc.cos * b - sc.sin * a};
  };
  auto [p, tangent] = at(from);
  verbs.empty() || verbs.back() == Verb::close ? move(p) : line(p);
  for (int i = 1; i <= pieces; ++i) {
    const auto [q, next] = at(from + i * step);
    curve(p + k * tangent, q - k * next, q);
    p = q, tangent = next;
  }
  return *this;
}

Path& Path::circle(Vec2 center, double radius) {
  const Vec2 start = center + Vec2{radius, 0};
  move(start).arc(center, {radius, 0}, {0, radius}, 0, 2 * kPi);
  return close();
}

void add(Drawing& drawing, Path path, const Style& style) {
  if (!path.verbs.empty()) drawing.items.emplace_back(Shape{std::move(path), style});
}

std::string printable(std::string_view text) {
  std::string out(text);
  const bool utf8 = is_utf8(text);
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = ' ';
    if (byte >= 0x80 && !utf8) c = '?';
  }
  return out;
}

void write(Drawing& drawing, Text text) {
  text.text = printable(text.text);
  if (!text.text.empty()) drawing.items.emplace_back(std::move(text));
}

void place(Drawing& into, const Drawing& part, Vec2 at, double scale) {
  if (part.background.alpha > 0) {
    const Vec2 s = scale * part.size;
    fill(into, Path{}.polygon(Box{at + 0.5 * s, {1, 0}, s.x / 2, s.y / 2}), part.background);
  }
  for (auto item : part.items) {
    if (auto* shape = std::get_if<Shape>(&item)) {
      for (Vec2& p : shape->path.points) p = at + scale * p;
      shape->style.width *= scale, shape->style.dash *= scale, shape->style.gap *= scale;
    } else {
      auto& text = std::get<Text>(item);
      text.at = at + scale * text.at;
      text.size *= scale;
    }
    into.items.push_back(std::move(item));
  }
}

std::string fitted(std::string_view text, double width, double size, bool bold) {
  std::string cut = printable(text);
  if (text_width(cut, size, bold) <= width) return cut;
  while (!cut.empty()) {
    // A character is its first byte and the continuation bytes behind it.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
    while (!cut.empty() && cut.back() == ' ') cut.pop_back();
    if (text_width(cut + "…", size, bold) <= width) break;
  }
  return cut + "…";
}

std::optional<Format> format_of(std::string_view file_name) {
  std::string end(file_name.substr(file_name.size() - std::min<std::size_t>(4, file_name.size())));
  for (char& c : end) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (end == ".svg") return Format::svg;
  if (end == ".png") return Format::png;
  if (end == ".pdf") return Format::pdf;
  return {};
}

}  // namespace inhabit::render
