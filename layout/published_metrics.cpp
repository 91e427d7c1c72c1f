#include "layout/published_metrics.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>

#include "layout/solids.h"

/// The measures that are counted in pixels. They depend on OpenCV's rounding of polygons, so they use OpenCV.
namespace inhabit::layout {
namespace {

constexpr int kImage = 256, kHalf = kImage / 2;
constexpr int kFloorPixel = 255;

using Points = std::vector<cv::Point>;

/// From metres to pixels: the floor's bounds centred, its longer half and a margin fill half the image, y downwards.
/// Coordinates are cut towards zero, as Python's int() does.
struct Map {
  Vec2 center;
  double scale = 1;

  Map(const Floor& floor, double margin) : center(floor.outline_bounds.center()) {
    const Vec2 half = 0.5 * floor.outline_bounds.size();
    scale = std::max(half.x, half.y) + margin;
  }
  int pixels(double metres) const { return static_cast<int>(metres / scale * kHalf); }
  cv::Point point(Vec2 p) const { return {pixels(p.x - center.x) + kHalf, pixels(-(p.y - center.y)) + kHalf}; }
};

/// The corners of a rectangle of `across` x `deep` pixels whose front faces `angle`. The sources' objects face -y at
/// rest, so that they have turned by angle + 90 degrees; image angles run the other way.
Points rectangle(cv::Point center, int across, int deep, double angle) {
  const auto degrees = static_cast<float>(-core::degrees(angle + kPi / 2));
  cv::Point2f corners[4];
  cv::RotatedRect(cv::Point2f(center), cv::Size2f(static_cast<float>(across), static_cast<float>(deep)), degrees)
      .points(corners);
  Points points;
  for (const cv::Point2f c : corners) points.emplace_back(static_cast<int>(c.x), static_cast<int>(c.y));
  return points;
}

void fill(cv::Mat& image, const Points& points, int value) {
  cv::fillPoly(image, std::vector<Points>{points}, cv::Scalar(value));
}

void outline(cv::Mat& image, const Points& points, int value, int thickness) {
  cv::drawContours(image, std::vector<Points>{points}, 0, cv::Scalar(value), thickness);
}

cv::Mat floor_image(const Floor& floor, const Map& map) {
  cv::Mat image = cv::Mat::zeros(kImage, kImage, CV_8UC1);
  std::vector<Points> rings;
  const auto add = [&](const Ring& ring) {
    Points& points = rings.emplace_back();
    for (const Vec2 p : ring) points.push_back(map.point(p));
  };
  add(floor.outline);
  for (const Ring& hole : floor.holes) add(hole);
  cv::fillPoly(image, rings, cv::Scalar(kFloorPixel));
  return image;
}

void erode(cv::Mat& image, int width) {
  // OpenCV takes an empty kernel for 3 x 3, and so do the sources when the room is so large that the robot has no
  // pixel.
  const cv::Mat kernel = width > 0 ? cv::Mat(cv::Mat::ones(width, width, CV_8UC1)) : cv::Mat();
  cv::erode(image, image, kernel);
}

double angle_of(const Object& object) { return object.angle.value_or(0); }

/// Pixels of each connected part of the image, background first.
std::vector<double> part_sizes(const cv::Mat& image, cv::Mat& labels) {
  cv::Mat stats, centroids;
  const int count = cv::connectedComponentsWithStats(image, labels, stats, centroids, 8);
  std::vector<double> sizes;
  for (int k = 0; k < count; ++k) sizes.push_back(stats.at<int>(k, cv::CC_STAT_AREA));
  return sizes;
}

double sum_of_parts(const std::vector<double>& sizes) {
  double sum = 0;
  for (std::size_t k = 1; k < sizes.size(); ++k) sum += sizes[k];
  return sum;
}

/// PhyScene keeps half sizes and doubles the pixels.
Points physcene_rectangle(const Map& map, const Object& object) {
  return rectangle(map.point(object.position->xy()), 2 * map.pixels(object.size.x / 2),
                   2 * map.pixels(object.size.y / 2), angle_of(object));
}

constexpr double kPhySceneRobot = 0.3, kPhySceneMargin = 0.2, kPhySceneHeight = 1.5;

/// 4.2: R_walkable in its three readings.
void physcene_walkable(const Solids& solids, const Map& map, PhyScene& result) {
  const int robot = map.pixels(kPhySceneRobot);
  cv::Mat image = floor_image(solids.floor, map);
  erode(image, robot);
  for (const Solid& solid : solids.list) {
    if ((solid.base + solid.top) / 2 >= kPhySceneHeight) continue;
    const Points points = physcene_rectangle(map, solids.object(solid));
    outline(image, points, 0, robot);
    fill(image, points, 0);
  }
  cv::Mat labels;
  const std::vector<double> sizes = part_sizes(image, labels);
  const double all = sum_of_parts(sizes);
  if (all > 0) {
    result.walkable = *std::max_element(sizes.begin() + 1, sizes.end()) / all;
    result.walkable_physcene_compat = sizes[1] / all;
  }
  double sum = 0;
  std::size_t doors = 0;
  for (const Door& door : solids.scene.space.doors) {
    const auto at = frame(solids.scene.space, door);
    if (!at) continue;
    ++doors;
    cv::Point p = map.point(at->jamb + door.width / 2 * at->along);
    p = {std::clamp(p.x, 0, kImage - 1), std::clamp(p.y, 0, kImage - 1)};
    double nearest = robot + 1, part = 0;
    bool found = false;
    for (int k = 1; k < static_cast<int>(sizes.size()); ++k) {
      cv::Mat distance;
      cv::distanceTransform(labels != k, distance, cv::DIST_L2, cv::DIST_MASK_5);
      const double d = distance.at<float>(p);
      if (d < nearest || (!found && d <= nearest)) nearest = d, part = sizes[static_cast<std::size_t>(k)], found = true;
    }
    sum += all > 0 ? part / all : 0;
  }
  if (doors > 0) result.walkable_doors = sum / static_cast<double>(doors);
}

/// The labels other than background that the footprint, outlined, filled and dilated by one pixel, touches. Drawn in a
/// window of its own: drawing does not depend on where whole pixels lie.
std::set<int> touched(const cv::Mat& labels, const Points& points, int thickness) {
  cv::Rect window = cv::boundingRect(points);
  const int margin = thickness + 2;
  window = (window + cv::Size(2 * margin, 2 * margin) - cv::Point(margin, margin)) & cv::Rect(0, 0, kImage, kImage);
  std::set<int> found;
  if (window.empty()) return found;
  cv::Mat mask = cv::Mat::zeros(window.size(), CV_8UC1);
  Points local = points;
  for (cv::Point& p : local) p -= window.tl();
  outline(mask, local, 255, thickness);
  fill(mask, local, 255);
  cv::dilate(mask, mask, cv::Mat::ones(3, 3, CV_8UC1));
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x)
      if (mask.at<std::uint8_t>(y, x) != 0) found.insert(labels.at<int>(y + window.y, x + window.x));
  found.erase(0);
  return found;
}

/// 4.2: R_out and R_reach, where every object counts however high it hangs.
void physcene_out_and_reach(const Solids& solids, const Map& map, PhyScene& result) {
  const int robot = map.pixels(kPhySceneRobot);
  const cv::Mat whole = floor_image(solids.floor, map);
  cv::Mat image = whole.clone();
  erode(image, robot);
  std::vector<Points> footprints;
  for (const Solid& solid : solids.list) {
    const Points& points = footprints.emplace_back(physcene_rectangle(map, solids.object(solid)));
    outline(image, points, 0, robot);
    fill(image, points, 0);
    const cv::Rect window = cv::boundingRect(points) & cv::Rect(0, 0, kImage, kImage);
    if (window.empty()) continue;  // the source sees no pixel of what lies beyond the image
    cv::Mat mask = cv::Mat::zeros(window.size(), CV_8UC1);
    Points local = points;
    for (cv::Point& p : local) p -= window.tl();
    fill(mask, local, 255);
    if (cv::countNonZero(mask & ~whole(window)) > 0) ++result.out;
  }
  cv::Mat labels;
  const std::vector<double> sizes = part_sizes(image, labels);
  const double all = sum_of_parts(sizes), boxes = static_cast<double>(footprints.size());
  for (const Points& points : footprints)
    for (const int k : touched(labels, points, robot)) result.reach += sizes[static_cast<std::size_t>(k)] / all / boxes;
}

/// The faces, in the order of Accessibility's choices, that somebody has to get at.
std::array<bool, 4> functional_sides(const Scene& scene, std::uint32_t index) {
  const Clearance& c = scene.objects[index].clearance;
  std::array<bool, 4> sides = {c.back > 0, c.left > 0, c.front > 0, c.right > 0};
  for (const Accessibility& a : scene.constraints.of<Accessibility>())
    if (a.object == Ref{Ref::Kind::object, index} && a.face >= 0 && a.face < 4)
      sides[static_cast<std::size_t>(a.face)] = true;
  return sides;
}

/// 4.1 Accessibility of one side: `outward` from the middle, `half` to the face; the strip is drawn in the object's
/// frame.
double side_score(const cv::Mat& free, const Map& map, const Solid& solid, double angle, Vec2 outward, double half,
                  double across, double deep) {
  constexpr double kStrip = 0.2, kOffset = 0.05;
  const Vec2 middle = solid.box.center + (half + kStrip / 2 + kOffset) * outward;
  const Points points = rectangle(map.point(middle), map.pixels(across), map.pixels(deep), angle);
  cv::Mat strip = cv::Mat::zeros(kImage, kImage, CV_8UC1), centred = strip.clone();
  fill(strip, points, 255);
  int x = 0, y = 0;
  for (const cv::Point p : points) x += p.x, y += p.y;
  Points moved = points;
  for (cv::Point& p : moved) p += cv::Point(kHalf - x / 4, kHalf - y / 4);
  fill(centred, moved, 255);
  const int area = cv::countNonZero(centred);
  return area == 0 ? 0 : static_cast<double>(cv::countNonZero(strip & free)) / area;
}

/// The eight corners of the solid as (along the wall, into the room, up) from the opening's lower first corner.
std::array<cv::Point3d, 8> corners_at(const Solid& solid, const DoorFrame& at, double sill) {
  std::array<cv::Point3d, 8> corners;
  const auto plan = solid.box.corners();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 d = plan[k] - at.jamb;
    corners[k] = {dot(d, at.along), dot(d, at.inward), solid.base - sill};
    corners[k + 4] = {corners[k].x, corners[k].y, solid.top - sill};
  }
  return corners;
}

constexpr int kTriangles[12][3] = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                   {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

OpeningOcclusion occlusion(const Solids& solids, const std::string& id, bool door, const DoorFrame& at, double width,
                           double sill, double height, double extrude) {
  // A centimetre each, as the source has them, unless the opening is as large as no building has any.
  constexpr double kPixelsPerMetre = 100, kMostPixels = 1e8;
  const double scale = std::min(kPixelsPerMetre, std::sqrt(kMostPixels / (width * height)));
  const auto pixels = [&](double metres) { return static_cast<int>(metres * scale); };
  cv::Mat map = cv::Mat::zeros(std::max(1, static_cast<int>(std::ceil(height * scale))),
                               std::max(1, static_cast<int>(std::ceil(width * scale))), CV_8UC1);
  OpeningOcclusion result{id, door, false, 0};
  const Box space{at.jamb + width / 2 * at.along + extrude / 2 * at.inward, at.inward, extrude / 2, width / 2};
  solids.grid.for_each_near(bounds(space), [&](std::uint32_t i) {
    const Solid& solid = solids.list[i];
    if (!solid.shares_height(sill, sill + height, 1e-9) || separation(space, solid.box).depth <= 1e-9) return;
    result.occluded = true;
    const auto corners = corners_at(solid, at, sill);
    for (const auto& triangle : kTriangles) {
      Points points;
      double nearest = 1e300, farthest = -1e300;
      for (const int k : triangle) {
        const cv::Point3d& c = corners[static_cast<std::size_t>(k)];
        points.emplace_back(pixels(c.x), pixels(height - c.z));
        nearest = std::min(nearest, c.y), farthest = std::max(farthest, c.y);
      }
      if (nearest <= extrude && farthest >= 0) cv::fillConvexPoly(map, points, cv::Scalar(255));
    }
  });
  result.share = static_cast<double>(cv::countNonZero(map)) / static_cast<double>(map.total());
  return result;
}

}  // namespace

double sceneeval_navigability(const Scene& scene) {
  constexpr double kRobot = 0.2, kMargin = 0.2, kHeight = 2.0;
  const Solids solids(scene);
  const Map map(solids.floor, kMargin);
  const int robot = map.pixels(kRobot);
  cv::Mat image = floor_image(solids.floor, map);
  erode(image, robot);
  for (const Solid& solid : solids.list) {
    if ((solid.base + solid.top) / 2 > kHeight) continue;
    const Object& o = solids.object(solid);
    const Points points =
        rectangle(map.point(solid.box.center), map.pixels(o.size.x), map.pixels(o.size.y), angle_of(o));
    outline(image, points, 0, robot);
    fill(image, points, 0);
  }
  cv::Mat labels;
  const std::vector<double> sizes = part_sizes(image, labels);
  const double all = sum_of_parts(sizes);
  return all > 0 ? *std::max_element(sizes.begin() + 1, sizes.end()) / all : 0;
}

std::vector<ObjectScore> sceneeval_accessibility(const Scene& scene) {
  constexpr double kHeight = 2.0;
  const Solids solids(scene);
  const Map map(solids.floor, 0);
  cv::Mat image = floor_image(solids.floor, map);
  for (const Solid& solid : solids.list) {
    if ((solid.base + solid.top) / 2 > kHeight) continue;
    const Object& o = solids.object(solid);
    fill(image, rectangle(map.point(solid.box.center), map.pixels(o.size.x), map.pixels(o.size.y), angle_of(o)), 0);
  }
  std::vector<ObjectScore> scores;
  for (const Solid& solid : solids.list) {
    const std::array<bool, 4> sides = functional_sides(scene, solid.object);
    double best = -1;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!sides[k]) continue;
      const Box& b = solid.box;
      const std::array<Vec2, 4> outward = {-b.front, b.left(), b.front, -b.left()};
      const bool end = k % 2 == 0;  // back or front
      best = std::max(best, side_score(image, map, solid, angle_of(solids.object(solid)), outward[k],
                                       end ? b.half_depth : b.half_width, end ? 2 * b.half_width : 0.2,
                                       end ? 0.2 : 2 * b.half_depth));
    }
    if (best >= 0) scores.push_back({solids.id(solid), best});
  }
  return scores;
}

std::vector<OpeningOcclusion> sceneeval_opening_clearance(const Scene& scene) {
  const Solids solids(scene);
  std::vector<OpeningOcclusion> list;
  for (const Door& d : scene.space.doors)
    if (const auto at = frame(scene.space, d))
      list.push_back(occlusion(solids, d.id, true, *at, d.width, 0, d.height, d.width));
  for (const Window& w : scene.space.windows) {
    const auto at = frame(scene.space, Door{.id = {}, .wall = w.wall, .from = w.from, .width = w.width});
    if (at) list.push_back(occlusion(solids, w.id, false, *at, w.width, w.sill, w.height, 0.5));
  }
  return list;
}

PhyScene physcene(const Scene& scene) {
  const Solids solids(scene);
  const Map map(solids.floor, kPhySceneMargin);
  PhyScene result;
  std::vector<bool> colliding(solids.list.size(), false);
  constexpr double kTouching = 1e-9;
  solids.grid.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Solid &a = solids.list[i], &b = solids.list[j];
    if (a.shares_height(b.base, b.top, kTouching) && separation(a.box, b.box).depth > kTouching)
      colliding[i] = colliding[j] = true;
  });
  result.colliding = static_cast<std::size_t>(std::ranges::count(colliding, true));
  physcene_walkable(solids, map, result);
  physcene_out_and_reach(solids, map, result);
  return result;
}

}  // namespace inhabit::layout
