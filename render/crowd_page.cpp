#include <algorithm>

#include "core/text.h"
#include "render/crowd_colors.h"
#include "render/plan_parts.h"

/// The ground that people walk on, as their pictures show it.
namespace inhabit::render {
namespace {

constexpr double kSide = 24, kTop = 70, kBottom = 62;

/// What the page shows. Somebody farther away than half of the ground would shrink the others to dots.
Bounds shown(const Walks& walks, const scene::Scene* scene, double margin) {
  Bounds ground;
  if (scene) {
    const Stock stock = take_stock(*scene, {});
    ground.add(stock.furnished.min - Vec2{stock.wall, stock.wall});
    ground.add(stock.furnished.max + Vec2{stock.wall, stock.wall});
  } else {
    for (const Area& area : walks.trajectories->walkable)
      for (const Vec2 p : area.outline) ground.add(p);
  }
  const bool known = ground.max.x > ground.min.x && ground.max.y > ground.min.y;
  if (!known) ground = walks.size() > 0 ? walks.bounds : Bounds{{0, 0}, {1, 1}};
  if (known && walks.size() > 0) {
    const double side = 0.5 * std::max(ground.size().x, ground.size().y);
    const Vec2 low = ground.min - Vec2{side, side}, high = ground.max + Vec2{side, side};
    const auto kept = [&](Vec2 p) { return Vec2{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)}; };
    Bounds people{kept(walks.bounds.min - Vec2{margin, margin}), kept(walks.bounds.max + Vec2{margin, margin})};
    ground.add(people.min);
    ground.add(people.max);
  } else {
    ground.min = ground.min - Vec2{2 * margin, 2 * margin};
    ground.max = ground.max + Vec2{2 * margin, 2 * margin};
  }
  const double least = 1e-3;
  if (ground.size().x < least || ground.size().y < least) {
    ground.add(ground.min - Vec2{0.5, 0.5});
    ground.add(ground.max + Vec2{0.5, 0.5});
  }
  return ground;
}

void draw_scene(Drawing& drawing, const Page& page, const scene::Scene& scene) {
  Stock stock = take_stock(scene, {});
  std::erase_if(stock.items, [](const Item& item) { return !item.placed; });
  const WallStyle style{stock.wall, page.line, false, {}};
  if (scene.space.outline.size() >= 3) draw_walls(drawing, page.frame, scene.space, style);
  draw_items(drawing, page, stock);
  if (scene.space.outline.size() >= 3) draw_openings(drawing, page.frame, scene.space, style);
}

void draw_walkable(Drawing& drawing, const Frame& frame, const std::vector<Area>& areas) {
  for (const Area& area : areas) {
    Path path;
    path.polygon(frame.page(area.outline));
    for (const Ring& hole : area.holes) path.polygon(frame.page(hole));
    add(drawing, std::move(path), {.fill = ink::kFloor, .stroke = ink::kWall, .width = 1.6, .even_odd = true});
  }
}

}  // namespace

CrowdPage crowd_page(const Walks& walks, const CrowdPictureOptions& options) {
  const Bounds ground = shown(walks, options.scene, std::clamp(options.radius, 0.0, 10.0));
  const Vec2 extent = ground.size();
  const double wide = std::max(options.width - 2 * kSide, 60.0), tall = std::max(options.height - kTop - kBottom, 60.0);
  Page page;
  page.frame.scale = std::min(wide / extent.x, tall / extent.y);
  const Vec2 plan = page.frame.scale * extent;
  const double least = 520;  // title, scale bar and legend want room
  page.size = {options.fixed_width ? options.width : std::max(plan.x + 2 * kSide, least), plan.y + kTop + kBottom};
  const Vec2 corner{(page.size.x - plan.x) / 2, kTop};
  page.frame.origin = {corner.x - page.frame.scale * ground.min.x, corner.y + page.frame.scale * ground.max.y};

  CrowdPage out{page.frame, {page.size, ink::kPaper, options.title, {}}, {page.size.x - kSide, 34}};
  if (options.scene)
    draw_scene(out.ground, page, *options.scene);
  else
    draw_walkable(out.ground, page.frame, walks.trajectories->walkable);
  const double y = page.size.y - 40;
  write(out.ground, {fitted(options.title, page.size.x - 2 * kSide - 170, 17, true),
                     {kSide, 34},
                     17,
                     ink::kText,
                     Anchor::start,
                     true});
  Page bar = page;
  bar.size.x = std::min(page.size.x, 900.0);
  draw_scale_bar(out.ground, bar, {kSide, y});
  draw_crowd_legend(out.ground, crowd_scale(walks, options), {out.stamp.x, y});
  return out;
}

}  // namespace inhabit::render
