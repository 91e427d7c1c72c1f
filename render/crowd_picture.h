#pragma once
#include <optional>

#include "render/frame.h"
#include "render/walks.h"
#include "scene/scene.h"

/// Pictures of people who walk: one moment, all their paths, and how far they got in time.
namespace inhabit::render {

/// way: the direction from a person's first position to his last; one colour for each group that has a goal of its own.
enum class PathColor { speed, time, way };

struct CrowdPictureOptions {
  const scene::Scene* scene = nullptr;  ///< its walls and furniture; else what the trajectories say of the ground
  std::string title;
  double radius = 0.25;         ///< of everybody, metres
  std::optional<double> trail;  ///< seconds of path behind everybody; absent: 1, and 0 where people are mere dots
  PathColor color = PathColor::speed;  ///< time is for paths: people at one moment are coloured by speed instead
  double fastest = 2;                  ///< speed of the last colour, m/s
  double width = 1000, height = 1000;
  bool fixed_width = false;  ///< the page is `width` wide, and not as wide as the ground lets it; for films
};

/// The page of a crowd's pictures, the same for every moment: where the ground lies, and the ground itself.
struct CrowdPage {
  Frame frame;
  Drawing ground;  ///< walls, floor, title, scale bar, legend
  Vec2 stamp;      ///< where what changes is written, its right end
};
/// The legend is that of options.color.
CrowdPage crowd_page(const Walks& walks, const CrowdPictureOptions& options);

/// People at a moment as discs coloured by speed or way, paths of the last seconds behind them as lines that fade;
/// where discs are too small to be seen, dots. Without the ground: its background is transparent and its size that of
/// the page.
Drawing draw_walkers(const Walks& walks, const CrowdPage& page, double time, const CrowdPictureOptions& options);
/// The same on its ground.
Drawing draw_moment(const Walks& walks, double time, const CrowdPictureOptions& options = {});
/// Every path as a thin line. Points nearer to each other than the eye can part are left out.
Drawing draw_paths(const Walks& walks, const CrowdPictureOptions& options = {});

enum class SpaceAxis { x, y };
/// Position along an axis against time, a line for each person.
Drawing draw_space_time(const Walks& walks, SpaceAxis axis, const CrowdPictureOptions& options = {});

}  // namespace inhabit::render
