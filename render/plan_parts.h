#pragma once
#include "render/labels.h"
#include "render/pen.h"
#include "render/plan.h"
#include "render/walls.h"

/// The steps of draw_plan.
namespace inhabit::render {

/// An object as it is drawn.
struct Item {
  const scene::Object* object = nullptr;
  const SymbolRow* symbol = nullptr;
  Box box;  ///< in the room, metres
  double base = 0, top = 0;
  bool placed = true;  ///< false: it waits in the row beside the room
};

/// Everything that a plan shows, lowest first, and how much of the ground it covers.
struct Stock {
  std::vector<Item> items;
  Bounds bounds;  ///< of everything shown
  Bounds room;
  Bounds furnished;                                     ///< the room and what is placed, without the row beside it
  double wall = 0.1;                                    ///< thickness, metres
  std::optional<Vec2> row;                              ///< where the row of objects without a position begins
  std::size_t waiting = 0, waiting_shown = 0, far = 0;  ///< `far`: too far outside to be shown
};
Stock take_stock(const scene::Scene& scene, const PlanOptions& options);

struct Page {
  Frame frame;
  Vec2 size;
  Bounds area;      ///< where the plan and its labels may be
  double text = 1;  ///< factor on text sizes
  double line = 1;  ///< factor on line widths
};

void draw_zones(Drawing& drawing, const Page& page, const Stock& stock, const PlanOptions& options);
void draw_items(Drawing& drawing, const Page& page, const Stock& stock);
/// One object's symbol in a box of the page.
void draw_symbol(Drawing& drawing, const Item& item, const Box& box, double metre, double line);

/// A measure to be written near its place: the depth of an overlap.
struct Note {
  Vec2 at;
  std::string text;
};
std::vector<Note> draw_problems(Drawing& drawing, const Page& page, const Stock& stock,
                                const layout::CheckReport& report);

/// A row of the legend: a kind that is counted, or the number that stands for a label.
struct LegendRow {
  std::string key, text;
  const Item* sample = nullptr;
};
/// Writes labels and notes; what is not written on the plan comes back as the legend's rows.
std::vector<LegendRow> draw_labels(Drawing& drawing, const Page& page, const Stock& stock, const scene::Scene& scene,
                                   const PlanOptions& options, const std::vector<Note>& notes);

void draw_title(Drawing& drawing, const Page& page, const Stock& stock, const scene::Scene& scene);
/// Where the lines of the overall measures meet, left of and below what is placed.
Vec2 measures_corner(const Page& page, const Stock& stock);
void draw_dimensions(Drawing& drawing, const Page& page, const Stock& stock);
/// Metres as alternating bars, `at` their upper left corner, at most a quarter of the page wide.
void draw_scale_bar(Drawing& drawing, const Page& page, Vec2 at);
/// Scale bar, verdict, legend; the page grows to hold them.
void draw_footer(Drawing& drawing, Page& page, const Stock& stock, const std::vector<LegendRow>& legend,
                 const PlanOptions& options);

/// A length for people: "4.60 m", "35 cm", "7 mm".
std::string metres_text(double metres);

}  // namespace inhabit::render
