#include "render/crowd_picture.h"

#include <doctest/doctest.h>

#include "render/crowd_colors.h"

using namespace inhabit;
using namespace inhabit::render;

namespace {

/// `people` side by side along y walk at 1.05 m/s along x for four seconds, ten frames a second.
scene::Trajectories walkers(int people) {
  scene::Trajectories t;
  t.frame_rate = 10;
  for (int f = 0; f <= 40; ++f)
    for (int p = 0; p < people; ++p) t.fixes.push_back({f, p, 0.105 * f, 1.0 * p});
  t.walkable = {{{{-1, -1}, {6, -1}, {6, 11}, {-1, 11}}, {}}};
  return t;
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

/// Parts of all paths of one colour, filled or stroked.
std::size_t parts(const Drawing& drawing, Color color, bool filled) {
  std::size_t n = 0;
  for (const auto& item : drawing.items) {
    const auto* shape = std::get_if<Shape>(&item);
    if (!shape) continue;
    const std::optional<Color>& own = filled ? shape->style.fill : shape->style.stroke;
    if (!own || own->r != color.r || own->g != color.g || own->b != color.b) continue;
    n += static_cast<std::size_t>(std::ranges::count(shape->path.verbs, Path::Verb::move));
  }
  return n;
}

Color at_speed(double speed) { return crowd_color(PathColor::speed, CrowdScale{}.level(speed)); }

}  // namespace

TEST_CASE("everybody is a disc in the colour of his speed with a trail behind him") {
  const scene::Trajectories t = walkers(7);
  const Walks walks = walks_of(t);
  CrowdPictureOptions options;
  const CrowdPage page = crowd_page(walks, options);
  CHECK(parts(draw_walkers(walks, page, 2, options), at_speed(1.05), true) == 7);
  CHECK(parts(draw_walkers(walks, page, 2, options), rgb(0x4a5563), false) == 7 * 5);
  options.trail = 0;
  CHECK(parts(draw_walkers(walks, page, 2, options), rgb(0x4a5563), false) == 0);
  const auto svg = encode(draw_moment(walks, 2, options), Format::svg);
  REQUIRE(svg.ok());
  CHECK(count(*svg, "2.00 s</text>") == 1);
  CHECK(count(*svg, "7 people</text>") == 1);
  CHECK(count(*svg, "speed [m/s]</text>") == 1);
  CHECK(count(*svg, " m</text>") == 1);  // the scale bar
}

TEST_CASE("discs below a point become dots without trails") {
  const scene::Trajectories t = walkers(7);
  const Walks walks = walks_of(t);
  CrowdPictureOptions options;
  options.radius = 0.001;
  const Drawing drawing = draw_walkers(walks, crowd_page(walks, options), 2, options);
  CHECK(parts(drawing, at_speed(1.05), true) == 7);
  CHECK(parts(drawing, rgb(0x4a5563), false) == 0);
}

TEST_CASE("positions between frames lie on the line and nobody is where he is not") {
  scene::Trajectories t;
  t.frame_rate = 10;
  for (const int f : {0, 1, 2, 30, 31}) t.fixes.push_back({f, 4, 0.1 * f, 0});
  const Walks walks = walks_of(t);
  REQUIRE(position_at(walks, 0, 0.15));
  CHECK(position_at(walks, 0, 0.15)->x == doctest::Approx(0.15));
  CHECK(!position_at(walks, 0, 1));  // longer than a second: gone
  CHECK(!position_at(walks, 0, 3.2));
  CHECK(walkers_at(walks, 3.05).size() == 1);
  CHECK(walkers_at(walks, 3.05)[0].speed == doctest::Approx(1));
}

TEST_CASE("a person who is seen every two seconds walks in between too") {
  scene::Trajectories t;
  t.frame_rate = 0.5;
  for (int f = 0; f < 4; ++f) t.fixes.push_back({f, 1, 2.0 * f, 0});
  const Walks walks = walks_of(t);
  REQUIRE(walkers_at(walks, 3).size() == 1);
  CHECK(walkers_at(walks, 3)[0].at.x == doctest::Approx(3));
  CHECK(walkers_at(walks, 3)[0].speed == doctest::Approx(1));
}

TEST_CASE("the fullest moment is in the middle of the fullest ones") {
  scene::Trajectories t;
  t.frame_rate = 2;
  t.fixes = {{0, 1, 0, 0}, {1, 1, 0, 0}, {1, 2, 0, 0}, {2, 1, 0, 0}, {2, 2, 0, 0}, {3, 1, 0, 0}, {3, 2, 0, 0}};
  CHECK(fullest_moment(t) == 1);
  CHECK(fullest_moment({}) == 0);
}

TEST_CASE("paths and space against time have one line for each steady walker") {
  const scene::Trajectories t = walkers(5);
  const Walks walks = walks_of(t);
  CHECK(parts(draw_paths(walks), at_speed(1.05), false) == 5);
  CHECK(parts(draw_space_time(walks, SpaceAxis::x), at_speed(1.05), false) == 5);
  CHECK(parts(draw_space_time(walks, SpaceAxis::y), at_speed(1.05), false) == 5);
  CrowdPictureOptions options;
  options.color = PathColor::time;
  const Drawing drawing = draw_paths(walks, options);
  CHECK(parts(drawing, crowd_color(PathColor::time, 0), false) == 5);
  CHECK(parts(drawing, crowd_color(PathColor::time, kCrowdLevels - 1), false) == 5);
}

TEST_CASE("by their ways two groups that pass have a colour each and west is the same from either side") {
  scene::Trajectories t;
  for (int frame = 0; frame < 3; ++frame)
    for (int k = 0; k < 4; ++k) {
      const double sign = k < 2 ? 1 : -1, aside = k < 2 ? 0 : k == 2 ? 1e-6 : -1e-6;
      t.fixes.push_back({frame, k, sign * frame, k + aside * frame});
    }
  const Walks walks = walks_of(t);
  CrowdPictureOptions options;
  options.color = PathColor::way;
  const Color east = crowd_color(PathColor::way, CrowdScale{PathColor::way, -180, 180}.level(0));
  const Color west = crowd_color(PathColor::way, 0);
  CHECK(west == crowd_color(PathColor::way, kCrowdLevels - 1));
  const Drawing moment = draw_moment(walks, 1.0 / 24, options);
  CHECK(std::pair(parts(moment, west, true), parts(draw_paths(walks, options), west, false)) == std::pair(4ul, 2ul));
  CHECK(parts(draw_paths(walks, options), east, false) == 2);
}

TEST_CASE("a picture of nobody is a picture") {
  const scene::Trajectories nobody;
  const Walks walks = walks_of(nobody);
  for (const Drawing& drawing : {draw_moment(walks, 0), draw_paths(walks), draw_space_time(walks, SpaceAxis::x)})
    CHECK(encode(drawing, Format::png).ok());
}

TEST_CASE("people in pixels over their ground are the picture of both") {
  const scene::Trajectories t = walkers(3);
  const Walks walks = walks_of(t);
  const CrowdPage page = crowd_page(walks, {});
  const auto ground = rasterize(page.ground, 300);
  REQUIRE(ground.ok());
  const auto over = rasterize(draw_walkers(walks, page, 2, {}), 300, &*ground),
             whole = rasterize(draw_moment(walks, 2), 300);
  REQUIRE(over.ok());
  REQUIRE(whole.ok());
  CHECK(over->bytes == whole->bytes);
  CHECK(over->bytes != ground->bytes);
  CHECK(encode_png(*over)->starts_with("\x89PNG"));
  CHECK(!rasterize(page.ground, 0).ok());
}
