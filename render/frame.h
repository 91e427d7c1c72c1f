#pragma once
#include "render/drawing.h"

namespace inhabit::render {

/// Where the ground lies on the page: points per metre, and the page point of the world's origin. North (+y) is up.
struct Frame {
  double scale = 100;
  Vec2 origin;

  Vec2 page(Vec2 p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
  Vec2 page_direction(Vec2 d) const { return {d.x, -d.y}; }
  Ring page(std::span<const Vec2> ring) const {
    Ring out;
    out.reserve(ring.size());
    for (const Vec2 p : ring) out.push_back(page(p));
    return out;
  }
  /// A box of the room as a box of the page.
  Box page(const Box& b) const {
    return {page(b.center), page_direction(b.front), scale * b.half_depth, scale * b.half_width};
  }
};

/// The colours that every picture shares.
namespace ink {
constexpr Color kText = rgb(0x2b2f36), kFaint = rgb(0x7d838c), kHairline = rgb(0xc9cdd3);
constexpr Color kPaper = rgb(0xfaf9f6), kFloor = rgb(0xffffff), kWall = rgb(0x3a3f47), kPillar = rgb(0x5a606a);
constexpr Color kProblem = rgb(0xc62f2f), kGood = rgb(0x3b7d4f);
}  // namespace ink

}  // namespace inhabit::render
