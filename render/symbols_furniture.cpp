#include "render/symbols.h"

/// Beds, seats, tables and cupboards.
namespace inhabit::render::symbols {

void box(const Pen& p) {
  p.body(0.8, p.tone.body);
  p.front_mark();
}

void plain(const Pen& p) { p.body(0.8, p.tone.body); }

void bed(const Pen& p) {
  p.body(p.metres(0.04, 0.06), p.tone.light);
  const double margin = 0.06 * p.w, pillow = std::min(0.36 * p.metre, 0.24 * p.d), gap = 0.35 * margin;
  const int pillows = p.w > 1.25 * p.metre ? 2 : 1;
  const double top = p.back() + 0.05 * p.d;
  const double each = (p.w - 2 * margin - (pillows - 1) * gap) / pillows;
  for (int i = 0; i < pillows; ++i) {
    const double x = p.left() + margin + i * (each + gap);
    p.rect(x, top, x + each, top + pillow, 0.3 * pillow, p.outlined(rgb(0xffffff)));
  }
  // The blanket with its turned-down edge.
  const double edge = top + 1.3 * pillow, fold = std::min(0.16 * p.metre, 0.1 * p.d);
  p.rect(p.left(), edge + 0.4 * fold, p.w / 2, p.d / 2, p.metres(0.04, 0.06), p.outlined(p.tone.body));
  p.rect(p.left(), edge, p.w / 2, edge + fold, 0, p.outlined(p.tone.light));
}

void cot(const Pen& p) {
  bed(p);
  for (const double side : {-0.5, 0.5}) p.lines({{side * 0.9 * p.w, p.back()}, {side * 0.9 * p.w, p.d / 2}}, p.fine());
}

void sofa(const Pen& p) {
  const double arm = std::min(0.18 * p.metre, 0.16 * p.w), rest = std::min(0.24 * p.metre, 0.3 * p.d);
  const double r = p.metres(0.08, 0.12);
  p.body(r, p.tone.body);
  const int cushions = std::clamp(static_cast<int>((p.w - 2 * arm) / (0.68 * p.metre) + 0.3), 1, 5);
  const double each = (p.w - 2 * arm) / cushions;
  for (int i = 0; i < cushions; ++i) {
    const double x = p.left() + arm + i * each;
    p.rect(x, p.back() + rest, x + each, p.d / 2 - 0.03 * p.d, 0.6 * r, p.outlined(p.tone.light));
  }
  for (const double side : {-1.0, 1.0})
    p.lines({{side * (p.w / 2 - arm), p.back() + rest}, {side * (p.w / 2 - arm), p.d / 2}}, p.fine());
}

void chair(const Pen& p) {
  const double rest = std::min(0.08 * p.metre, 0.18 * p.d), r = p.metres(0.06, 0.18);
  p.rect(p.left() + 0.03 * p.w, p.back() + 0.4 * rest, p.w / 2 - 0.03 * p.w, p.d / 2, r, p.outlined(p.tone.light));
  p.rect(p.left(), p.back(), p.w / 2, p.back() + rest, 0.4 * rest, p.outlined(p.tone.body));
}

void office_chair(const Pen& p) {
  // Five castors under a round seat; a curved back.
  for (int i = 0; i < 5; ++i) {
    const Vec2 a = 0.48 * p.small() * direction(kPi / 2 + 2 * kPi * i / 5);
    p.lines({{0, 0}, {a.x, a.y}}, p.outlined({0, 0, 0, 0}));
  }
  p.rect(-0.4 * p.w, -0.34 * p.d, 0.4 * p.w, 0.44 * p.d, 0.22 * p.small(), p.outlined(p.tone.light));
  p.rect(-0.42 * p.w, p.back(), 0.42 * p.w, p.back() + 0.16 * p.d, 0.08 * p.d, p.outlined(p.tone.body));
}

void stool(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.light));
  p.ellipse(0, 0, 0.36 * p.w, 0.36 * p.d, p.fine());
}

void bench(const Pen& p) {
  p.body(p.metres(0.04, 0.2), p.tone.light);
  for (const double y : {-1.0 / 6, 1.0 / 6}) p.lines({{p.left(), y * p.d}, {p.w / 2, y * p.d}}, p.fine());
  p.front_mark();
}

void seat(const Pen& p) {
  p.rect(p.left(), p.back(), p.w / 2, p.d / 2, 0.25 * p.small(), p.outlined(p.tone.light));
  p.rect(p.left(), p.back(), p.w / 2, p.back() + 0.26 * p.d, 0.12 * p.d, p.outlined(p.tone.body));
}

void table(const Pen& p) {
  p.body(p.metres(0.03, 0.05), p.tone.body);
  const double inset = p.metres(0.05, 0.08);
  p.rect(p.left() + inset, p.back() + inset, p.w / 2 - inset, p.d / 2 - inset, 0.5 * inset, p.fine());
}

void round_table(const Pen& p) {
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.body));
  const double inset = p.metres(0.05, 0.08);
  p.ellipse(0, 0, p.w / 2 - inset, p.d / 2 - inset, p.fine());
}

void desk(const Pen& p) {
  p.body(p.metres(0.02, 0.05), p.tone.body);
  // The front is where one sits: the knee space between two pedestals.
  const double foot = 0.24 * p.w, depth = 0.3 * p.d;
  Style dashed = p.fine();
  dashed.dash = 2.4, dashed.gap = 1.8, dashed.round = false;
  p.lines({{p.left() + foot, p.d / 2},
           {p.left() + foot, p.d / 2 - depth},
           {p.w / 2 - foot, p.d / 2 - depth},
           {p.w / 2 - foot, p.d / 2}},
          dashed);
  p.front_mark();
}

void wardrobe(const Pen& p) {
  p.body(0.8, p.tone.body);
  // The rail and its hangers, drawn across it.
  p.lines({{p.left() + 0.04 * p.w, 0}, {p.w / 2 - 0.04 * p.w, 0}}, p.fine());
  const int hangers = std::clamp(static_cast<int>(p.w / (0.16 * p.metre)), 2, 24);
  for (int i = 0; i < hangers; ++i) {
    const double x = p.left() + (i + 0.5) * p.w / hangers, lean = (i % 3 - 1) * 0.05 * p.d;
    p.lines({{x - lean, -0.28 * p.d}, {x + lean, 0.28 * p.d}}, p.fine());
  }
  // Doors along the front, their seam and their handles.
  const double door = std::max(1.6, 0.07 * p.d), y = p.d / 2 - door;
  p.rect(p.left(), y, p.w / 2, p.d / 2, 0, p.outlined(p.tone.light));
  const int doors = std::clamp(static_cast<int>(p.w / (0.6 * p.metre) + 0.5), 1, 8);
  for (int i = 1; i < doors; ++i) {
    const double x = p.left() + i * p.w / doors;
    p.lines({{x, y}, {x, p.d / 2}}, p.outlined({0, 0, 0, 0}));
  }
}

void drawers(const Pen& p) {
  p.body(0.8, p.tone.body);
  const double front = std::max(1.6, 0.09 * p.d), y = p.d / 2 - front;
  p.rect(p.left(), y, p.w / 2, p.d / 2, 0, p.outlined(p.tone.light));
  const double handle = std::min(0.12 * p.w, 0.12 * p.metre);
  p.lines({{-handle, y - 0.08 * p.d}, {handle, y - 0.08 * p.d}}, p.outlined({0, 0, 0, 0}));
}

void shelf(const Pen& p) {
  p.body(0.8, p.tone.light);
  // Spines of unequal thickness and depth, the same on every shelf of the same width.
  const double depth = 0.82 * p.d;
  int i = 0;
  for (double x = p.left() + 0.03 * p.w; x < p.w / 2 - 0.04 * p.w && i < 60; ++i) {
    const double thick = std::max(2.2, (0.035 + 0.012 * ((i * 7) % 4)) * p.metre);
    const double end = std::min(x + thick, p.w / 2 - 0.03 * p.w);
    const double length = depth * (0.72 + 0.09 * ((i * 5) % 4));
    if ((i * 3) % 8 != 5)
      p.rect(x, p.back() + 0.06 * p.d, end, p.back() + length, 0,
             {.fill = i % 2 ? p.tone.body : p.tone.light, .stroke = p.tone.line, .width = 0.5 * p.line});
    x = end;
  }
  p.lines({{p.left(), p.d / 2 - 0.06 * p.d}, {p.w / 2, p.d / 2 - 0.06 * p.d}}, p.fine());
}

void coat_rack(const Pen& p) {
  const double r = 0.5 * p.small();
  p.ellipse(0, 0, p.w / 2, p.d / 2, p.outlined(p.tone.light));
  for (int i = 0; i < 6; ++i) {
    const Vec2 a = direction(2 * kPi * i / 6 + kPi / 6);
    p.lines({{0.2 * r * a.x, 0.2 * r * a.y}, {0.8 * r * a.x, 0.8 * r * a.y}}, p.outlined({0, 0, 0, 0}));
    p.ellipse(0.8 * r * a.x, 0.8 * r * a.y, 0.1 * r, 0.1 * r, {.fill = p.tone.line});
  }
  p.ellipse(0, 0, 0.2 * r, 0.2 * r, p.outlined(p.tone.body));
}

void piano(const Pen& p) {
  p.body(1, p.tone.body);
  const double keys = std::min(0.16 * p.metre, 0.3 * p.d), y = p.d / 2 - keys;
  p.rect(p.left() + 0.04 * p.w, y, p.w / 2 - 0.04 * p.w, p.d / 2, 0, p.outlined(rgb(0xffffff)));
  constexpr int kKeys = 28;
  for (int i = 1; i < kKeys; ++i) {
    const double x = p.left() + (0.04 + 0.92 * i / kKeys) * p.w;
    const bool black = i % 7 != 3 && i % 7 != 0;
    p.lines({{x, y}, {x, black ? p.d / 2 - 0.4 * keys : p.d / 2}},
            {.stroke = p.tone.line, .width = black ? 0.012 * p.w : 0.3 * p.line});
  }
}

void pool_table(const Pen& p) {
  p.body(p.metres(0.06, 0.06), p.tone.body);
  const double rim = p.metres(0.1, 0.12);
  p.rect(p.left() + rim, p.back() + rim, p.w / 2 - rim, p.d / 2 - rim, 0.3 * rim, p.outlined(rgb(0xbfdcc4)));
  const bool wide = p.w > p.d;
  for (const double a : {-1.0, 0.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      const double x = (wide ? a : b) * (p.w / 2 - rim), y = (wide ? b : a) * (p.d / 2 - rim);
      p.ellipse(x, y, 0.4 * rim, 0.4 * rim, {.fill = p.tone.line});
    }
}

void leaf(const Pen& p) {
  p.body(0, p.tone.light);
  p.lines({{p.left(), p.back()}, {p.w / 2, p.d / 2}}, p.fine());
}

}  // namespace inhabit::render::symbols
