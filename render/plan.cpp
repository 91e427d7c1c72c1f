#include "render/plan.h"

#include <algorithm>
#include <map>

#include "render/plan_parts.h"

namespace inhabit::render {
namespace {

bool finite(Vec2 p) { return std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9; }  // false for NaN, too

double usable(double v) { return v > 0 && v < 1e6 ? v : 0; }

void add_box(Bounds& bounds, const Box& box) {
  for (const Vec2 p : box.corners()) bounds.add(p);
}

Bounds room_bounds(const scene::Scene& scene) {
  Bounds room;
  for (const Vec2 p : scene.space.outline)
    if (finite(p)) room.add(p);
  if (room.max.x < room.min.x) {
    for (const scene::Object& o : scene.objects)
      if (o.position && finite({o.position->x, o.position->y})) room.add({o.position->x, o.position->y});
  }
  if (room.max.x < room.min.x) room.add({0, 0});
  // A room without area is given a little, so that there is a scale.
  const Vec2 size = room.size();
  if (size.x < 1e-3 || size.y < 1e-3) {
    const double grow = std::max(0.5, 0.05 * std::max(size.x, size.y));
    room.add(room.min - Vec2{grow, grow});
    room.add(room.max + Vec2{grow, grow});
  }
  return room;
}

/// Puts what has no position into rows below the room.
void line_up(Stock& stock, std::vector<Item> waiting) {
  constexpr std::size_t kShown = 60;
  stock.waiting = waiting.size();
  if (waiting.empty()) return;
  const Vec2 room = stock.room.size();
  const double side = std::max(room.x, room.y), gap = 0.035 * side;
  const double left = stock.room.min.x;
  Vec2 at{left, stock.bounds.min.y - 0.13 * side};
  stock.row = at + Vec2{0, 0.4 * gap};
  double row = 0;
  for (Item& item : waiting) {
    if (stock.waiting_shown == kShown) break;
    item.box.front = {0, -1};
    const double w = 2 * item.box.half_width, d = 2 * item.box.half_depth;
    if (at.x > left && at.x + w > left + std::max(room.x, 0.6 * side)) at = {left, at.y - row - gap}, row = 0;
    item.box.center = at + Vec2{w / 2, -d / 2};
    at.x += w + gap;
    row = std::max(row, d);
    add_box(stock.bounds, item.box);
    stock.items.push_back(item);
    ++stock.waiting_shown;
  }
}

void add_openings(Bounds& bounds, const scene::Space& space, double wall) {
  for (const scene::Door& door : space.doors) {
    const auto place = door.swing == scene::Door::Swing::out ? door_place(space, door) : std::nullopt;
    if (place && finite(place->hinge) && door.width < 1e3)
      bounds.add(place->hinge + (wall + door.width) * place->opening);
  }
}

/// The page for a stock: margins for title and measures, the plan as large as `size` allows.
Page make_page(const Stock& stock, const PlanOptions& options) {
  Page page;
  page.text = options.text;
  page.line = std::clamp(0.4 + 0.6 * options.text, 0.5, 3.0);
  const double side = options.labels == PlanOptions::Labels::all ? 64 * options.text : 16;
  const double left = std::max(side, options.dimensions ? 58 * options.text : 16.0);
  const double top = (options.title ? 74 : 18) * options.text, bottom = (options.dimensions ? 58 : 18) * options.text;
  const double wall = std::max(stock.wall, 1e-9);
  const Vec2 ground = stock.bounds.size() + Vec2{2 * wall, 2 * wall};
  const double size = std::clamp(options.size, 120.0, 20000.0);
  const double width = std::max(size - left - side, 60.0),
               height = std::max(size - top - bottom - 40 * options.text, 60.0);
  page.frame.scale = options.scale ? *options.scale : std::min(width / ground.x, height / ground.y);
  const Vec2 plan = page.frame.scale * ground;
  const double least = options.title ? 400 * options.text : 0;
  page.size = {std::max(plan.x + left + side, least), plan.y + top + bottom};
  const Vec2 corner{left + (page.size.x - plan.x - left - side) / 2, top};  // of the plan, top left
  page.frame.origin = {corner.x - page.frame.scale * (stock.bounds.min.x - wall),
                       corner.y + page.frame.scale * (stock.bounds.max.y + wall)};
  page.area.add({8, top - 10 * options.text});
  page.area.add({page.size.x - 8, page.size.y - 4});
  return page;
}

}  // namespace

Stock take_stock(const scene::Scene& scene, const PlanOptions& options) {
  Stock stock;
  stock.room = stock.bounds = room_bounds(scene);
  const Vec2 size = stock.room.size();
  // A wall of 12 cm, thinner round small things and never a hairline round large ones.
  const double side = std::max(size.x, size.y);
  const bool bare = scene.space.doors.empty() && scene.space.windows.empty() && side < 2.5;  // a table top
  stock.wall = bare ? 0.01 * side : std::clamp(0.12, 0.006 * side, 0.022 * side);
  if (options.wall_thickness > 0) stock.wall = usable(options.wall_thickness);
  Bounds reach = stock.room;  // what stands farther outside would shrink the room to a dot
  reach.add(stock.room.min - 0.5 * Vec2{side, side});
  reach.add(stock.room.max + 0.5 * Vec2{side, side});
  std::map<std::string_view, const SymbolRow*> symbols;
  std::vector<Item> waiting;
  stock.items.reserve(scene.objects.size());
  for (const scene::Object& o : scene.objects) {
    const SymbolRow*& symbol = symbols[o.kind];
    if (!symbol) symbol = &symbol_row(o.kind);
    Item item{&o, symbol, {{}, {1, 0}, usable(o.size.y) / 2, usable(o.size.x) / 2}};
    item.placed = o.position && finite({o.position->x, o.position->y});
    if (!item.placed) {
      waiting.push_back(item);
      continue;
    }
    const double angle = o.angle && std::abs(*o.angle) < 1e4 ? *o.angle : 0;
    item.box.center = {o.position->x, o.position->y};
    item.box.front = direction(angle);
    item.base = o.position->z + (o.mount == scene::Mount::ceiling ? 1e3 : 0);
    item.top = item.base + usable(o.size.z);
    const Vec2 c = item.box.center;
    if (c.x < reach.min.x || c.y < reach.min.y || c.x > reach.max.x || c.y > reach.max.y)
      ++stock.far;
    else
      stock.items.push_back(item);
  }
  for (const Item& item : stock.items)
    for (const Vec2 p : item.box.corners())
      stock.bounds.add({std::clamp(p.x, reach.min.x, reach.max.x), std::clamp(p.y, reach.min.y, reach.max.y)});
  // Ground first, then by height: a pillow over its bed, a lamp over its table.
  std::ranges::stable_sort(stock.items, [](const Item& a, const Item& b) {
    if (a.symbol->ground != b.symbol->ground && a.base == b.base) return a.symbol->ground;
    return a.base != b.base ? a.base < b.base : a.top < b.top;
  });
  add_openings(stock.bounds, scene.space, stock.wall);
  stock.furnished = stock.bounds;
  line_up(stock, std::move(waiting));
  return stock;
}

Drawing draw_plan(const scene::Scene& scene, const PlanOptions& options) {
  const Stock stock = take_stock(scene, options);
  Page page = make_page(stock, options);
  Drawing drawing{page.size, options.background, scene.name, {}};
  WallStyle walls{stock.wall, page.line, options.door_zones, {}};
  std::vector<std::string> blocked;
  if (options.report)
    for (const auto& door : options.report->blocked_doors) blocked.push_back(door.id);
  walls.blocked_doors = blocked;
  const bool outline = scene.space.outline.size() >= 3 && std::ranges::all_of(scene.space.outline, finite);
  if (outline) draw_walls(drawing, page.frame, scene.space, walls);
  draw_zones(drawing, page, stock, options);
  draw_items(drawing, page, stock);
  if (outline) draw_openings(drawing, page.frame, scene.space, walls);
  std::vector<Note> notes;
  if (options.report) notes = draw_problems(drawing, page, stock, *options.report);
  if (options.dimensions) draw_dimensions(drawing, page, stock);
  if (stock.row) {
    std::string text = "not placed";
    if (stock.waiting > stock.waiting_shown)
      text += " (" + std::to_string(stock.waiting_shown) + " of " + std::to_string(stock.waiting) + " shown)";
    write(drawing, {text, page.frame.page(*stock.row), 11 * page.text, ink::kFaint, Anchor::start, true});
  }
  const std::vector<LegendRow> legend = draw_labels(drawing, page, stock, scene, options, notes);
  if (options.title) draw_title(drawing, page, stock, scene);
  draw_footer(drawing, page, stock, legend, options);
  drawing.size = page.size;
  return drawing;
}

}  // namespace inhabit::render
