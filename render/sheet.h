#pragma once
#include "render/plan.h"

namespace inhabit::render {

/// One plan of a contact sheet. Requires: the scene lives until the sheet is drawn.
struct SheetCell {
  const scene::Scene* scene = nullptr;
  std::string caption;  ///< "1 · best", "after"; absent: the number in the list
  std::optional<bool> feasible;
  std::optional<double> energy;
  const layout::CheckReport* report =
      nullptr;  ///< its problems are drawn; feasibility and energy come from it when not given
};

struct SheetOptions {
  std::string title;
  int columns = 0;     ///< 0: as many as make the sheet about 4 : 3
  double size = 1400;  ///< width of the sheet, points
  bool labels = true;  ///< where they fit into what they name
  Color background = rgb(0xfaf9f6);
};

/// Plans side by side at one scale, in the order given: variants ranked, before and after.
Drawing draw_sheet(std::span<const SheetCell> cells, const SheetOptions& options = {});

}  // namespace inhabit::render
