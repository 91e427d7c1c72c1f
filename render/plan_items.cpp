#include <algorithm>
#include <map>
#include <set>

#include "core/text.h"
#include "render/plan_parts.h"

/// Objects, the zones they ask for, and what is wrong with them.
namespace inhabit::render {
namespace {

constexpr double kTiny = 5;  // points: below this a symbol is a blot

bool hung(const Item& item) { return item.object->mount != scene::Mount::floor; }

/// Many tiny boxes of one kind as one shape.
struct Run {
  const SymbolRow* symbol = nullptr;
  Path path;

  void end(Drawing& drawing) {
    if (!symbol || path.verbs.empty()) return;
    add(drawing, std::move(path), {.fill = symbol->tone.body, .stroke = symbol->tone.line, .width = 0.25});
    path = {};
  }
};

/// The box in front of a face, `depth` deep, as the faces are named in a scene.
Box zone(const Box& box, std::string_view face, double depth) {
  Box z = box;
  const double h = depth / 2;
  if (face == "front" || face == "back") {
    z.center += ((face == "front" ? 1 : -1) * (box.half_depth + h)) * box.front;
    z.half_depth = h;
  } else {
    z.center += ((face == "left" ? 1 : -1) * (box.half_width + h)) * box.left();
    z.half_width = h;
  }
  return z;
}

void draw_clearances(Drawing& drawing, const Page& page, const Item& item, const std::set<std::string>& blocked) {
  const scene::Clearance& c = item.object->clearance;
  for (const auto& [face, depth] :
       {std::pair{"front", c.front}, {"back", c.back}, {"left", c.left}, {"right", c.right}}) {
    if (!(depth > 0 && depth < 1e3)) continue;
    const bool bad = blocked.contains(item.object->id + "\n" + face);
    const Color color = bad ? ink::kProblem : rgb(0x6f87a6);
    Color inside = color;
    inside.alpha = bad ? 0.12 : 0.10;
    add(drawing, Path{}.polygon(page.frame.page(zone(item.box, face, depth))),
        {.fill = inside, .stroke = color, .width = 0.6 * page.line, .dash = 1.2, .gap = 2.4});
  }
}

void draw_view(Drawing& drawing, const Page& page, const Item& item) {
  const scene::View& view = *item.object->view;
  if (!(view.distance > 0 && view.distance < 1e3 && view.angle > 0 && view.angle <= 2 * kPi)) return;
  const Vec2 f = item.box.front, apex = item.box.center + item.box.half_depth * f;
  const Vec2 c = page.frame.page(apex);
  const Vec2 a = page.frame.scale * view.distance * page.frame.page_direction(f);
  const Vec2 b = page.frame.scale * view.distance * page.frame.page_direction(perp(f));
  Path path;
  path.move(c).arc(c, a, b, -view.angle / 2, view.angle / 2).close();
  add(drawing, std::move(path),
      {.fill = rgb(0xd9a441, 0.13), .stroke = rgb(0xb98a2f), .width = 0.6 * page.line, .dash = 4, .gap = 3});
}

/// The polygon that two boxes share.
Ring shared(const Box& a, const Box& b) {
  const auto corners = a.corners(), clip = b.corners();
  Ring in(corners.begin(), corners.end()), out;
  for (std::size_t k = 0; k < 4 && !in.empty(); ++k) {
    const Vec2 p = clip[k], e = clip[(k + 1) % 4] - p;
    out.clear();
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Vec2 q = in[i], r = in[(i + 1) % in.size()];
      const double sq = cross(e, q - p), sr = cross(e, r - p);
      if (sq >= 0) out.push_back(q);
      if ((sq > 0 && sr < 0) || (sq < 0 && sr > 0)) out.push_back(q + (sq / (sq - sr)) * (r - q));
    }
    in.swap(out);
  }
  return in;
}

}  // namespace

std::string metres_text(double metres) {
  if (!(std::abs(metres) < 1e9)) return "?";
  if (std::abs(metres) >= 0.9995) return fixed(metres, 2) + " m";
  const double cm = 100 * metres;
  if (std::abs(cm) >= 9.95) return fixed(cm, 0) + " cm";
  return std::abs(cm) >= 0.995 ? shortest(std::round(10 * cm) / 10) + " cm"
                               : shortest(std::round(100 * cm) / 10) + " mm";
}

void draw_symbol(Drawing& drawing, const Item& item, const Box& box, double metre, double line) {
  // The page's y runs down, so the box's right is its `left()` there.
  Pen pen{drawing, box.center, box.left(),       box.front, 2 * box.half_width, 2 * box.half_depth,
          metre,   0.9,        item.symbol->tone};
  pen.line = line * std::clamp(0.045 * pen.small(), 0.3, 0.9);
  if (hung(item)) {
    // Over people's heads, or on the wall: dashed, and what is below shows through.
    Color inside = pen.tone.body;
    inside.alpha = 0.45;
    Style style{
        .fill = inside, .stroke = pen.tone.line, .width = pen.line, .dash = 3.5 * pen.line, .gap = 2.2 * pen.line};
    if (item.symbol->round)
      pen.ellipse(0, 0, pen.w / 2, pen.d / 2, style);
    else
      pen.rect(-pen.w / 2, -pen.d / 2, pen.w / 2, pen.d / 2, 0, style);
    if (!item.symbol->round) pen.front_mark();
  } else if (std::max(pen.w, pen.d) < 2.2 * kTiny) {
    if (item.symbol->round)
      pen.ellipse(0, 0, pen.w / 2, pen.d / 2, pen.outlined(pen.tone.body));
    else
      pen.tick();
  } else {
    item.symbol->draw(pen);
  }
}

void draw_items(Drawing& drawing, const Page& page, const Stock& stock) {
  Run run;
  for (const Item& item : stock.items) {
    const Box box = page.frame.page(item.box);
    if (2 * std::max(box.half_depth, box.half_width) < kTiny) {
      if (run.symbol != item.symbol || run.path.verbs.size() > 4000) run.end(drawing), run.symbol = item.symbol;
      run.path.polygon(box);
      continue;
    }
    run.end(drawing);
    draw_symbol(drawing, item, box, page.frame.scale, page.line);
  }
  run.end(drawing);
}

void draw_zones(Drawing& drawing, const Page& page, const Stock& stock, const PlanOptions& options) {
  std::set<std::string> blocked;
  if (options.report)
    for (const auto& c : options.report->clearances)
      if (c.blocked_share > 0.01) blocked.insert(c.id + "\n" + c.face);
  for (const Item& item : stock.items) {
    if (!item.placed) continue;
    if (options.clearances) draw_clearances(drawing, page, item, blocked);
    if (options.views && item.object->view) draw_view(drawing, page, item);
  }
}

std::vector<Note> draw_problems(Drawing& drawing, const Page& page, const Stock& stock,
                                const layout::CheckReport& report) {
  constexpr std::size_t kDrawn = 400, kNotes = 24;
  std::map<std::string_view, const Item*> by_id;
  for (const Item& item : stock.items)
    if (item.placed) by_id[item.object->id] = &item;
  const auto find = [&](const std::string& id) {
    const auto it = by_id.find(id);
    return it == by_id.end() ? nullptr : it->second;
  };
  const Style line{.stroke = ink::kProblem, .width = 1.5 * page.line};
  std::vector<Note> notes;
  for (std::size_t i = 0; i < std::min(report.overlaps.size(), kDrawn); ++i) {
    const auto& overlap = report.overlaps[i];
    const Item *a = find(overlap.a), *b = find(overlap.b);
    if (!a || !b) continue;
    add(drawing, Path{}.polygon(page.frame.page(a->box)), line);
    add(drawing, Path{}.polygon(page.frame.page(b->box)), line);
    const Ring both = page.frame.page(shared(a->box, b->box));
    fill(drawing, Path{}.polygon(both), rgb(0xc62f2f, 0.45));
    if (notes.size() < kNotes && both.size() >= 3) notes.push_back({bounds(both).center(), metres_text(overlap.depth)});
  }
  for (std::size_t i = 0; i < std::min(report.outside.size(), kDrawn); ++i) {
    const Item* item = find(report.outside[i].id);
    if (!item) continue;
    Style dashed = line;
    dashed.dash = 5, dashed.gap = 3, dashed.fill = rgb(0xc62f2f, 0.10);
    add(drawing, Path{}.polygon(page.frame.page(item->box)), dashed);
    if (notes.size() < kNotes)
      notes.push_back({page.frame.page(item->box.center), metres_text(report.outside[i].depth) + " outside"});
  }
  return notes;
}

}  // namespace inhabit::render
