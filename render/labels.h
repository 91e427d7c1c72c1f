#pragma once
#include "render/drawing.h"

/// Where labels go: inside what they name when they fit, beside it with a leader otherwise, and never over each other
/// or across an outline. Pure geometry on the page.
namespace inhabit::render {

/// Something that labels must not cross. Ground carries what stands on it (a rug, a table top): a label may lie wholly
/// on it.
struct Obstacle {
  Box box;
  bool ground = false;
};

/// A label wanted for a box. `shapes` are the widths and heights of its text on one or on several lines, best first.
struct LabelRequest {
  Box box;
  std::vector<Vec2> shapes;
  int obstacle = -1;       ///< the obstacle that is the box itself, not in its own way
  bool inside = true;      ///< may lie inside its box
  bool beside = true;      ///< may lie beside its box
  double front_inset = 0;  ///< kept free inside the front edge where possible: for a mark
  bool round = false;      ///< the box is drawn as an ellipse: text inside keeps within it
};

struct LabelSpot {
  bool placed = false;
  bool inside = false;
  std::size_t shape = 0;
  double scale = 1;             ///< of the text: 1, 0.86 or 0.74
  Box box;                      ///< `front` runs along the text, half_depth is half its width
  Vec2 leader_from, leader_to;  ///< from the label to its box; unused inside
};

struct LabelField {
  Bounds page;
  /// In drawing order: what a box is drawn over is not in the way of a label inside it.
  std::vector<Obstacle> obstacles;
  std::vector<Box> taken;  ///< labels that are there already
};

/// One spot per request, in order; `placed` is false where there is no room. The labels placed overlap neither each
/// other, nor `taken`, nor any leader, cross no obstacle's outline and stay on the page. Cost O(requests · (obstacles +
/// near²)).
std::vector<LabelSpot> place_labels(std::span<const LabelRequest> requests, const LabelField& field);

/// A leader as a thin box, to keep other labels off it.
Box leader_box(Vec2 from, Vec2 to);

}  // namespace inhabit::render
