#include "render/symbols.h"

/// Appliances, bathrooms, plants, the outdoors and what lies on a desk.
namespace inhabit::render::symbols {

void screen(const Pen& p) {
  // A flat panel on its stand: the picture looks to the front.
  if (p.d > 0.5 * p.w) {
    box(p);
    return;
  }
  p.body(0.6, p.tone.body);
  const double glass = std::max(1.2, 0.3 * p.d);
  p.rect(p.left() + 0.03 * p.w, p.d / 2 - glass, p.w / 2 - 0.03 * p.w, p.d / 2, 0, {.fill = p.tone.line});
}

void plant(const Pen& p) {
  const double r = 0.5 * p.small();
  p.ellipse(0, 0, 0.45 * r, 0.45 * r, {.fill = p.tone.light, .stroke = p.tone.line, .width = 0.6 * p.line});
  constexpr int kLeaves = 9;
  for (int i = 0; i < kLeaves; ++i) {
    const Vec2 a = direction(2 * kPi * i / kLeaves + 0.35), side = perp(a);
    const double reach = r * (i % 2 ? 0.98 : 0.86), wide = 0.3 * r;
    const auto at = [&](double s, double t) {
      return p.at((s * a.x + t * side.x) * p.w / p.small(), (s * a.y + t * side.y) * p.d / p.small());
    };
    Path path;
    path.move(at(0.08 * r, 0)).curve(at(0.35 * r, wide), at(0.75 * r, wide), at(reach, 0));
    path.curve(at(0.75 * r, -wide), at(0.35 * r, -wide), at(0.08 * r, 0)).close();
    add(p.drawing, std::move(path), {.fill = p.tone.body, .stroke = p.tone.line, .width = 0.6 * p.line, .round = true});
  }
}

void lamp(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.body));
  p.ellipse(0, 0, 0.24 * p.w, 0.24 * p.d, p.outlined(p.tone.light));
  for (const Vec2 a : {Vec2{1, 0}, Vec2{0, 1}})
    for (const double s : {-1.0, 1.0})
      p.lines({{0.24 * p.w * s * a.x, 0.24 * p.d * s * a.y}, {0.5 * p.w * s * a.x, 0.5 * p.d * s * a.y}}, p.fine());
}

void rug(const Pen& p) {
  p.body(1, p.tone.body);
  const double inset = p.metres(0.12, 0.1);
  p.rect(p.left() + inset, p.back() + inset, p.w / 2 - inset, p.d / 2 - inset, 0.5, p.fine());
  const double inner = 1.5 * inset;
  p.rect(p.left() + inner, p.back() + inner, p.w / 2 - inner, p.d / 2 - inner, 0.5,
         {.fill = p.tone.light, .stroke = p.tone.line, .width = 0.4 * p.line});
}

void toilet(const Pen& p) {
  const double tank = 0.28 * p.d;
  p.rect(p.left(), p.back(), p.w / 2, p.back() + tank, 1.5, p.outlined(p.tone.body));
  const double middle = p.back() + tank + 0.5 * (p.d - tank), ry = 0.5 * (p.d - tank);
  p.ellipse(0, middle, 0.46 * p.w, ry, p.outlined(p.tone.light));
  p.ellipse(0, middle, 0.32 * p.w, 0.7 * ry, p.outlined(rgb(0xffffff)));
}

void basin(const Pen& p) {
  p.body(p.metres(0.04, 0.1), p.tone.body);
  p.ellipse(0, 0.06 * p.d, 0.38 * p.w, 0.34 * p.d, p.outlined(rgb(0xffffff)));
  p.ellipse(0, 0.06 * p.d, 0.05 * p.small(), 0.05 * p.small(), {.fill = p.tone.line});
  p.lines({{0, p.back() + 0.06 * p.d}, {0, -0.14 * p.d}}, p.outlined({0, 0, 0, 0}));
}

void bathtub(const Pen& p) {
  p.body(p.metres(0.05, 0.08), p.tone.body);
  const double rim = p.metres(0.07, 0.1);
  p.rect(p.left() + rim, p.back() + rim, p.w / 2 - rim, p.d / 2 - rim, 0.3 * p.small(), p.outlined(rgb(0xffffff)));
  const bool wide = p.w > p.d;
  const double x = wide ? p.left() + 2.2 * rim : 0, y = wide ? 0 : p.back() + 2.2 * rim;
  p.ellipse(x, y, 0.25 * rim, 0.25 * rim, {.fill = p.tone.line});
}

void shower(const Pen& p) {
  p.body(1, p.tone.light);
  p.lines({{p.left(), p.back()}, {p.w / 2, p.d / 2}}, p.fine());
  p.lines({{p.w / 2, p.back()}, {p.left(), p.d / 2}}, p.fine());
  p.ellipse(0, 0, 0.08 * p.small(), 0.08 * p.small(), p.outlined(p.tone.body));
}

void stove(const Pen& p) {
  p.body(1, p.tone.body);
  const double r = 0.15 * p.small();
  for (const double x : {-0.23, 0.23})
    for (const double y : {-0.26, 0.16}) {
      p.ellipse(x * p.w, y * p.d, r, r, p.outlined(p.tone.light));
      p.ellipse(x * p.w, y * p.d, 0.5 * r, 0.5 * r, p.fine());
    }
  for (const double x : {-0.3, -0.1, 0.1, 0.3})
    p.ellipse(x * p.w, 0.42 * p.d, 0.025 * p.small(), 0.025 * p.small(), {.fill = p.tone.line});
}

void fridge(const Pen& p) {
  p.body(1, p.tone.body);
  const double door = 0.1 * p.d;
  p.rect(p.left(), p.d / 2 - door, p.w / 2, p.d / 2, 0, p.outlined(p.tone.light));
  p.lines({{p.left(), p.back()}, {p.w / 2, p.d / 2 - door}}, p.fine());
  p.lines({{p.w / 2, p.back()}, {p.left(), p.d / 2 - door}}, p.fine());
}

void washer(const Pen& p) {
  p.body(1, p.tone.body);
  p.ellipse(0, 0, 0.34 * p.small(), 0.34 * p.small(), p.outlined(p.tone.light));
  p.front_mark();
}

void grill(const Pen& p) {
  p.body(p.metres(0.06, 0.2), p.tone.body);
  const double inset = 0.14 * p.small();
  p.rect(p.left() + inset, p.back() + inset, p.w / 2 - inset, p.d / 2 - inset, 0.5, p.outlined(p.tone.light));
  const double width = p.w - 2 * inset;
  for (int i = 1; i < 6; ++i) {
    const double x = p.left() + inset + i * width / 6;
    p.lines({{x, p.back() + inset}, {x, p.d / 2 - inset}}, p.fine());
  }
  p.lines({{-0.2 * p.w, p.d / 2}, {0.2 * p.w, p.d / 2}}, {.stroke = p.tone.line, .width = 2 * p.line});
}

void bin(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.body));
  p.ellipse(0, 0, 0.36 * p.w, 0.36 * p.d, p.outlined(p.tone.light));
  p.ellipse(0, 0, 0.28 * p.w, 0.28 * p.d, p.fine());
}

void carousel(const Pen& p) {
  const double r = 0.5;
  p.ellipse(0, 0, r * p.w, r * p.d, p.outlined(p.tone.light));
  constexpr int kSlices = 16;
  for (int i = 0; i < kSlices; i += 2) {
    const double from = 2 * kPi * i / kSlices, to = 2 * kPi * (i + 1) / kSlices;
    Path path;
    path.move(p.at(0, 0)).arc(p.at(0, 0), r * p.w * p.right, r * p.d * p.front, from, to).close();
    add(p.drawing, std::move(path), {.fill = p.tone.body, .stroke = p.tone.line, .width = 0.5 * p.line});
  }
  p.ellipse(0, 0, 0.16 * p.w, 0.16 * p.d, p.outlined(rgb(0xffffff)));
}

void stage(const Pen& p) {
  p.body(1, p.tone.body);
  // Boards run from wing to wing, the apron is at the front.
  const int boards = std::clamp(static_cast<int>(p.d / 7), 2, 16);
  for (int i = 1; i < boards; ++i) {
    const double y = p.back() + i * p.d / boards;
    p.lines({{p.left(), y}, {p.w / 2, y}}, {.stroke = p.tone.light, .width = 0.8 * p.line});
  }
  p.lines({{p.left(), p.d / 2}, {p.w / 2, p.d / 2}}, {.stroke = p.tone.line, .width = 2.6 * p.line});
  p.front_mark();
}

void book(const Pen& p) {
  p.body(0.8, p.tone.body);
  const double spine = 0.1 * p.w;
  p.lines({{p.left() + spine, p.back()}, {p.left() + spine, p.d / 2}}, p.fine());
  p.rect(p.left() + 2.6 * spine, 0.16 * p.d, p.w / 2 - 1.6 * spine, 0.3 * p.d, 0.4, {.fill = p.tone.light});
}

void laptop(const Pen& p) {
  p.body(p.metres(0.015, 0.08), p.tone.body);
  p.rect(-0.44 * p.w, -0.36 * p.d, 0.44 * p.w, 0.12 * p.d, 0.6, p.outlined(p.tone.light));
  for (const double y : {-0.24, -0.12, 0.0}) p.lines({{-0.44 * p.w, y * p.d}, {0.44 * p.w, y * p.d}}, p.fine());
  p.rect(-0.13 * p.w, 0.18 * p.d, 0.13 * p.w, 0.42 * p.d, 0.6, p.outlined(p.tone.light));
  p.lines({{p.left(), -0.44 * p.d}, {p.w / 2, -0.44 * p.d}}, {.stroke = p.tone.line, .width = 1.8 * p.line});
}

void keyboard(const Pen& p) {
  p.body(1, p.tone.body);
  for (const double y : {-0.25, 0.0, 0.25}) p.lines({{-0.46 * p.w, y * p.d}, {0.46 * p.w, y * p.d}}, p.fine());
}

void pencil(const Pen& p) {
  // Its point is at the front, or at the right when it is wider than deep.
  const bool wide = p.w > p.d;
  const double length = std::max(p.w, p.d), half = 0.5 * p.small(), tip = std::min(3.2 * half, 0.15 * length);
  const auto v = [&](double along, double across) { return wide ? Vec2{along, across} : Vec2{across, along}; };
  const double a = -length / 2, b = length / 2;
  p.polygon({v(a, -half), v(b - tip, -half), v(b - tip, half), v(a, half)}, p.outlined(p.tone.body));
  p.polygon({v(b - tip, -half), v(b, 0), v(b - tip, half)}, p.outlined(p.tone.light));
}

void plate(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.light));
  p.ellipse(0, 0, 0.33 * p.w, 0.33 * p.d, p.fine());
}

void mug(const Pen& p) {
  const double r = 0.42 * p.small();
  p.ellipse(r, 0, 0.35 * r, 0.3 * r, p.outlined(p.tone.light));
  p.ellipse(0, 0, r, r, p.outlined(p.tone.light));
  p.ellipse(0, 0, 0.75 * r, 0.75 * r, p.outlined(rgb(0xc9ad92)));
}

void frame(const Pen& p) {
  p.body(0.6, p.tone.body);
  p.lines({{p.left(), p.d / 2}, {p.w / 2, p.d / 2}}, {.stroke = p.tone.line, .width = 1.8 * p.line});
}

void paper(const Pen& p) {
  p.body(0.6, rgb(0xffffff));
  const int rows = std::clamp(static_cast<int>(p.d / 5), 2, 10);
  for (int i = 1; i < rows; ++i) {
    const double y = p.d / 2 - i * p.d / rows;
    p.lines({{-0.38 * p.w, y}, {(i % 3 == 2 ? 0.15 : 0.38) * p.w, y}}, p.fine());
  }
}

void parasol(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.body));
  for (int i = 0; i < 4; ++i) {
    const Vec2 a = direction(kPi * i / 4);
    p.lines({{-0.5 * p.w * a.x, -0.5 * p.d * a.y}, {0.5 * p.w * a.x, 0.5 * p.d * a.y}}, p.fine());
  }
}

}  // namespace inhabit::render::symbols
