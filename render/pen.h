#pragma once
#include "render/drawing.h"

namespace inhabit::render {

/// The colours of one family of things: the body, its lighter parts, its lines.
struct Tone {
  Color body, light, line;
};

/// Draws in an object's own frame: points, x to its right, y to its front, the origin in the middle of its footprint.
struct Pen {
  Drawing& drawing;
  Vec2 origin, right, front;  ///< on the page; right and front are unit vectors
  double w = 1, d = 1;        ///< width across the front, depth
  double metre = 100;         ///< points per metre
  double line = 0.9;          ///< width of an outline
  Tone tone;

  Vec2 at(double x, double y) const { return origin + x * right + y * front; }
  double left() const { return -w / 2; }
  double back() const { return -d / 2; }
  double small() const { return std::min(w, d); }
  /// A length in metres, but not more than a share of the smaller side.
  double metres(double length, double share) const { return std::min(length * metre, share * small()); }

  Style outlined(Color inside) const { return {.fill = inside, .stroke = tone.line, .width = line, .round = true}; }
  Style fine() const { return {.stroke = tone.line, .width = 0.6 * line, .round = true}; }

  /// A rectangle from (x0, y0) to (x1, y1) with rounded corners.
  void rect(double x0, double y0, double x1, double y1, double radius, const Style& style) const;
  void body(double radius, Color inside) const { rect(-w / 2, -d / 2, w / 2, d / 2, radius, outlined(inside)); }
  void ellipse(double x, double y, double rx, double ry, const Style& style) const;
  void lines(std::initializer_list<Vec2> points, const Style& style) const;
  void polygon(std::initializer_list<Vec2> points, const Style& style) const;
  /// A small triangle inside the front edge, pointing out.
  void front_mark() const;
  /// Small things: a box with a heavier front edge.
  void tick() const;
};

/// Which way to draw a kind.
using Symbol = void (*)(const Pen&);

struct SymbolRow {
  std::string_view kind;
  Symbol draw;
  Tone tone;
  bool round = false;   ///< the footprint is drawn as an ellipse
  bool mark = false;    ///< a small mark at the front is not to be written over
  bool ground = false;  ///< others stand on it: labels may lie across it
};
/// The row of a kind. `office-chair`, `Office Chair` and `chairs` are all found; of several rows named in a kind the
/// one named last is taken ("table lamp" is a lamp). Unknown kinds get a box with its front marked.
const SymbolRow& symbol_row(std::string_view kind);

}  // namespace inhabit::render
