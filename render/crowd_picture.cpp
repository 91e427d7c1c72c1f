#include "render/crowd_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "render/crowd_colors.h"

namespace inhabit::render {
namespace {

/// A moment has one time only.
CrowdPictureOptions of_moment(CrowdPictureOptions options) {
  if (options.color == PathColor::time) options.color = PathColor::speed;
  return options;
}

constexpr int kFades = 5;  // parts of a trail, each fainter than the one before
// Points: people with a smaller radius are drawn as squares of about their width at that radius; smaller ones would
// make a haze of a hundred thousand.
constexpr double kDot = 0.8;

bool on_page(Vec2 p, Vec2 size) { return p.x > -50 && p.y > -50 && p.x < size.x + 50 && p.y < size.y + 50; }

Path& square(Path& path, Vec2 p, double half) {
  return path.polygon(
      Ring{{p.x - half, p.y - half}, {p.x + half, p.y - half}, {p.x + half, p.y + half}, {p.x - half, p.y + half}});
}

/// The path of the last `seconds` of each walker in parts, oldest and faintest first.
void draw_trails(Drawing& drawing, const Walks& walks, const CrowdPage& page, const std::vector<Walker>& walkers,
                 double time, double seconds, double width) {
  std::array<Path, kFades> parts;
  for (const Walker& walker : walkers) {
    if (!on_page(page.frame.page(walker.at), drawing.size)) continue;
    Vec2 now = page.frame.page(walker.at);
    double t = time;
    for (int part = kFades - 1; part >= 0; --part) {
      const double begin = time - seconds * (kFades - part) / kFades;
      // Steps of a tenth of a second at least, so that bends show in long trails.
      const int steps = std::clamp(static_cast<int>(std::ceil((t - begin) / 0.1 - 1e-9)), 1, 50);
      Path& path = parts[static_cast<std::size_t>(part)];
      bool begun = false, gone = false;
      for (int s = 1; s <= steps && !gone; ++s) {
        const std::optional<Vec2> at = position_at(walks, walker.person, t + (begin - t) * s / steps);
        gone = !at;
        if (gone) break;
        const Vec2 p = page.frame.page(*at);
        if (length(p - now) < 0.2) continue;
        if (!begun) path.move(now), begun = true;
        path.line(p), now = p;
      }
      if (gone) break;
      t = begin;
    }
  }
  for (int part = 0; part < kFades; ++part)
    stroke(drawing, std::move(parts[static_cast<std::size_t>(part)]), rgb(0x4a5563, 0.12 + 0.13 * part), width);
}

/// Discs, or dots. Many are drawn as one shape for each colour, few one by one, so that those who overlap are told
/// apart.
void draw_bodies(Drawing& drawing, const CrowdPage& page, const Walks& walks, const CrowdScale& scale,
                 const std::vector<Walker>& walkers, double radius) {
  constexpr std::size_t kFew = 3000;
  const auto put = [&](Path path, int level) {
    Style style{.fill = crowd_color(scale.color, level)};
    if (radius > 2) style.stroke = rgb(0xffffff, 0.9), style.width = std::min(0.12 * radius, 1.0);
    add(drawing, std::move(path), style);
  };
  std::vector<Path> levels(kCrowdLevels);
  for (const Walker& walker : walkers) {
    const Vec2 p = page.frame.page(walker.at);
    if (!on_page(p, drawing.size)) continue;
    const int level = scale.level(scale.color == PathColor::way ? way_of(walks, walker.person) : walker.speed);
    Path& path = levels[static_cast<std::size_t>(level)];
    if (radius < kDot)
      square(path, p, 0.85 * kDot);
    else
      path.circle(p, radius);
    if (walkers.size() <= kFew) put(std::exchange(path, {}), level);
  }
  for (int k = 0; k < kCrowdLevels; ++k) put(std::move(levels[static_cast<std::size_t>(k)]), k);
}

void draw_stamp(Drawing& drawing, const CrowdPage& page, double time, std::size_t people) {
  write(drawing, {fixed(time, 2) + " s", page.stamp, 17, ink::kText, Anchor::end, true});
  write(drawing, {std::to_string(people) + (people == 1 ? " person" : " people"), page.stamp + Vec2{0, 18}, 11.5,
                  ink::kFaint, Anchor::end});
}

}  // namespace

Drawing draw_walkers(const Walks& walks, const CrowdPage& page, double time, const CrowdPictureOptions& options) {
  Drawing drawing{page.ground.size, {255, 255, 255, 0}, options.title, {}};
  const std::vector<Walker> walkers = walkers_at(walks, time);
  const double radius = page.frame.scale * options.radius;
  const bool dots = radius < kDot;
  const double trail = options.trail.value_or(dots ? 0 : 1);
  if (trail > 0) draw_trails(drawing, walks, page, walkers, time, trail, std::clamp(0.35 * radius, 0.6, 3.0));
  draw_bodies(drawing, page, walks, crowd_scale(walks, of_moment(options)), walkers, radius);
  draw_stamp(drawing, page, time, walkers.size());
  return drawing;
}

Drawing draw_moment(const Walks& walks, double time, const CrowdPictureOptions& options) {
  CrowdPage page = crowd_page(walks, of_moment(options));
  Drawing people = draw_walkers(walks, page, time, options);
  Drawing drawing = std::move(page.ground);
  for (auto& item : people.items) drawing.items.push_back(std::move(item));
  return drawing;
}

Drawing draw_paths(const Walks& walks, const CrowdPictureOptions& options) {
  CrowdPage page = crowd_page(walks, options);
  const CrowdScale scale = crowd_scale(walks, options);
  Drawing drawing = std::move(page.ground);
  std::vector<Path> paths =
      colored_tracks(walks, scale, [&](const scene::Fix& fix) { return page.frame.page(fix.at()); });
  // Many paths lie on each other: thinner and lighter lines keep their density visible.
  const double many = std::clamp(std::log10(std::max<double>(1, static_cast<double>(walks.size()))) / 4, 0.0, 1.0);
  for (int k = 0; k < kCrowdLevels; ++k) {
    Color color = crowd_color(scale.color, k);
    color.alpha = 0.9 - 0.5 * many;
    add(drawing, std::move(paths[static_cast<std::size_t>(k)]),
        {.stroke = color, .width = 1.2 - 0.8 * many, .round = true});
  }
  const std::size_t n = walks.size();
  write(drawing,
        {fixed(walks.begin, 1) + " … " + fixed(walks.end, 1) + " s", page.stamp, 15, ink::kText, Anchor::end, true});
  write(drawing,
        {std::to_string(n) + (n == 1 ? " path" : " paths"), page.stamp + Vec2{0, 18}, 11.5, ink::kFaint, Anchor::end});
  return drawing;
}

}  // namespace inhabit::render
