#pragma once
#include "layout/check.h"
#include "render/drawing.h"

namespace inhabit::render {

struct PlanOptions {
  /// `inside`: only where they fit into what they name; `all`: also beside it, or by number with a key below the plan.
  enum class Labels { none, inside, all };
  Labels labels = Labels::all;
  bool ids = false;         ///< label by id instead of by name or kind
  bool clearances = false;  ///< the free depth wanted in front of faces
  bool views = false;       ///< view cones
  bool door_zones = false;  ///< what the doors sweep
  bool title = true;        ///< name, measures, number of objects
  bool dimensions = true;   ///< overall width and depth
  bool scale_bar = true;
  bool verdict = true;          ///< with a report: feasible or not, its energy, what is wrong
  bool legend = true;           ///< counts of kinds that are not labelled one by one
  double size = 1000;           ///< long side of the plan with its margins, points; a long legend adds height
  std::optional<double> scale;  ///< points per metre, instead of filling `size`
  double text = 1;              ///< factor on every size of text
  double wall_thickness = 0;    ///< metres; 0: one that suits the room
  std::size_t many = 60;        ///< with more objects, repeated kinds are counted in the legend instead of labelled
  Color background = rgb(0xfaf9f6);
  /// What is wrong with the scene, to be shown: overlapping pairs, what is outside, blocked doors and clearances.
  const layout::CheckReport* report = nullptr;
};

/// The scene from above as an architect would draw it: poché walls, openings, furniture by kind with its front visible.
/// Whatever has no position stands in a row beside the room, named as such. Numbers that are not finite count as
/// missing.
Drawing draw_plan(const scene::Scene& scene, const PlanOptions& options = {});

}  // namespace inhabit::render
