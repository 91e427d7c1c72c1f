#include "render/sheet.h"

#include <algorithm>

#include "core/text.h"
#include "render/plan_parts.h"

namespace inhabit::render {
namespace {

constexpr double kMargin = 28, kGutter = 22, kCaption = 34, kPad = 10;

/// The share of a page that a grid of `n` cells fills best: columns so that the sheet is about 4 : 3.
int choose_columns(std::size_t n, Vec2 cell) {
  int best = 1;
  double best_off = 1e300;
  for (int c = 1; c <= static_cast<int>(std::min<std::size_t>(n, 12)); ++c) {
    const auto rows = static_cast<double>((n + static_cast<std::size_t>(c) - 1) / static_cast<std::size_t>(c));
    const double off = std::abs(std::log(c * cell.x / (rows * (cell.y + 0.15 * cell.x)) / (4.0 / 3.0)));
    if (off < best_off - 1e-9) best = c, best_off = off;
  }
  return best;
}

PlanOptions cell_options(const SheetOptions& options, const SheetCell& cell, double scale) {
  PlanOptions plan;
  plan.labels = options.labels ? PlanOptions::Labels::inside : PlanOptions::Labels::none;
  plan.title = plan.dimensions = plan.scale_bar = plan.legend = false;
  plan.scale = scale;
  plan.text = 0.82;
  plan.background = {255, 255, 255, 0};
  plan.report = cell.report;
  plan.verdict = false;
  return plan;
}

void draw_caption(Drawing& sheet, const SheetCell& cell, std::size_t number, Vec2 at, double width) {
  constexpr double kSize = 12.5;
  const std::string caption = cell.caption.empty() ? std::to_string(number) : cell.caption;
  std::optional<bool> feasible = cell.feasible;
  std::optional<double> energy = cell.energy;
  if (cell.report && !feasible) feasible = cell.report->feasible;
  if (cell.report && !energy) energy = cell.report->energy;
  double right = at.x + width;
  if (energy) {
    const std::string text = "energy " + fixed(*energy, std::abs(*energy) < 10 ? 3 : 1);
    write(sheet, {text, {right, at.y}, 0.85 * kSize, ink::kFaint, Anchor::end});
    right -= text_width(text, 0.85 * kSize) + 12;
  }
  if (feasible) {
    const std::string text = *feasible ? "feasible" : "not feasible";
    const Color color = *feasible ? ink::kGood : ink::kProblem;
    write(sheet, {text, {right, at.y}, 0.85 * kSize, color, Anchor::end});
    right -= text_width(text, 0.85 * kSize) + 8;
    fill(sheet, Path{}.circle({right, at.y - 0.36 * kSize}, 3), color);
    right -= 12;
  }
  write(sheet,
        {fitted(caption, std::max(right - at.x, 20.0), kSize, true), at, kSize, ink::kText, Anchor::start, true});
}

/// Metres that the largest plan covers in each direction.
Vec2 largest(std::span<const SheetCell> cells) {
  Vec2 most{0.1, 0.1};
  for (const SheetCell& cell : cells) {
    if (!cell.scene) continue;
    const Stock stock = take_stock(*cell.scene, {});
    const Vec2 size = stock.bounds.size() + 2 * Vec2{stock.wall, stock.wall};
    most = {std::max(most.x, size.x), std::max(most.y, size.y)};
  }
  return most;
}

}  // namespace

Drawing draw_sheet(std::span<const SheetCell> cells, const SheetOptions& options) {
  const Vec2 metres = largest(cells);
  const double width = std::clamp(options.size, 200.0, 20000.0);
  const int columns =
      options.columns > 0 ? options.columns : choose_columns(std::max<std::size_t>(cells.size(), 1), metres);
  const double cell_width = (width - 2 * kMargin - (columns - 1) * kGutter) / columns;
  const double scale = std::max(cell_width - 2 * kPad - 32, 20.0) / metres.x;
  const double cell_height = kCaption + scale * metres.y + 2 * kPad + 32;
  const auto rows =
      static_cast<int>((cells.size() + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns));
  const double top = options.title.empty() ? kMargin : kMargin + 40;
  Drawing sheet{{width, top + std::max(rows, 1) * (cell_height + kGutter) - kGutter + kMargin},
                options.background,
                options.title,
                {}};
  if (!options.title.empty())
    write(sheet, {fitted(options.title, width - 2 * kMargin, 20, true),
                  {kMargin, kMargin + 16},
                  20,
                  ink::kText,
                  Anchor::start,
                  true});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(columns));
    const auto row = static_cast<double>(i / static_cast<std::size_t>(columns));
    const Vec2 at{kMargin + column * (cell_width + kGutter), top + row * (cell_height + kGutter)};
    const Box card{at + 0.5 * Vec2{cell_width, cell_height}, {1, 0}, cell_width / 2, cell_height / 2};
    add(sheet, Path{}.polygon(card), {.fill = rgb(0xffffff), .stroke = ink::kHairline, .width = 0.7});
    draw_caption(sheet, cells[i], i + 1, at + Vec2{kPad + 2, 22}, cell_width - 2 * kPad - 4);
    if (!cells[i].scene) continue;
    const Drawing plan = draw_plan(*cells[i].scene, cell_options(options, cells[i], scale));
    const Vec2 room{cell_width, cell_height - kCaption};
    place(sheet, plan, at + Vec2{0, kCaption} + 0.5 * (room - plan.size), 1);
  }
  return sheet;
}

}  // namespace inhabit::render
