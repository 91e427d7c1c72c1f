#include "render/pen.h"

namespace inhabit::render {

void Pen::rect(double x0, double y0, double x1, double y1, double radius, const Style& style) const {
  const double r = std::min({radius, std::abs(x1 - x0) / 2, std::abs(y1 - y0) / 2});
  Path path;
  if (r < 0.3) {
    path.move(at(x0, y0)).line(at(x1, y0)).line(at(x1, y1)).line(at(x0, y1));
  } else {
    const Vec2 a = r * right, b = r * front;
    path.arc(at(x1 - r, y1 - r), a, b, 0, kPi / 2);
    path.arc(at(x0 + r, y1 - r), a, b, kPi / 2, kPi);
    path.arc(at(x0 + r, y0 + r), a, b, kPi, 1.5 * kPi);
    path.arc(at(x1 - r, y0 + r), a, b, 1.5 * kPi, 2 * kPi);
  }
  add(drawing, std::move(path.close()), style);
}

void Pen::ellipse(double x, double y, double rx, double ry, const Style& style) const {
  Path path;
  path.arc(at(x, y), rx * right, ry * front, 0, 2 * kPi);
  add(drawing, std::move(path.close()), style);
}

void Pen::lines(std::initializer_list<Vec2> points, const Style& style) const {
  Path path;
  for (const Vec2 q : points) path.verbs.empty() ? path.move(at(q.x, q.y)) : path.line(at(q.x, q.y));
  add(drawing, std::move(path), style);
}

void Pen::polygon(std::initializer_list<Vec2> points, const Style& style) const {
  Path path;
  for (const Vec2 q : points) path.verbs.empty() ? path.move(at(q.x, q.y)) : path.line(at(q.x, q.y));
  add(drawing, std::move(path.close()), style);
}

void Pen::front_mark() const {
  const double size = std::min(6.5, 0.22 * small()), y = d / 2 - 0.45 * size;
  polygon({{-size * 0.7, y - size}, {size * 0.7, y - size}, {0, y}}, {.fill = tone.line});
}

void Pen::tick() const {
  body(0, tone.body);
  lines({{-w / 2, d / 2}, {w / 2, d / 2}}, {.stroke = tone.line, .width = 2.2 * line});
}

}  // namespace inhabit::render
