#include "layout/house_places.h"

#include <algorithm>
#include <array>

namespace inhabit::layout {
namespace {

constexpr double kGap = 0.03;    // metres between neighbours
constexpr double kElbow = 0.08;  // between two seats

/// One side of a table: towards `turn` from its centre, `half` away, with `length` to sit at.
struct Side {
  double turn = 0, half = 0, length = 0;
  std::size_t count = 0;

  std::size_t room(const Vec3& seat) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>((length + kElbow) / (seat.x + kElbow)));
  }
};

void place(const Side& side, const Vec3& seat, double gap, std::vector<Place>& places) {
  const Vec2 out = direction(side.turn), along = perp(out);
  const double away = side.half + gap + seat.y / 2;
  // Closer than the side's share where it is long: neighbours at one table talk to each other.
  const double step = std::min(side.length / static_cast<double>(side.count), 1.6 * seat.x);
  for (std::size_t i = 0; i < side.count; ++i) {
    const double shift = (static_cast<double>(i) - (static_cast<double>(side.count) - 1) / 2) * step;
    places.push_back({away * out + shift * along, wrap_angle(side.turn + kPi)});
  }
}

}  // namespace

std::vector<Place> seats(const Vec3& table, const Vec3& seat, Sides sides, std::size_t count, double gap) {
  const double width = table.x, depth = table.y;
  std::array<Side, 4> all = {Side{0, depth / 2, width}, Side{kPi, depth / 2, width}, Side{kPi / 2, width / 2, depth},
                             Side{-kPi / 2, width / 2, depth}};
  if (sides == Sides::around && depth > width) std::swap(all[0], all[2]), std::swap(all[1], all[3]);
  if (sides == Sides::front) {
    all[0].count = std::min(count, all[0].room(seat));
  } else {
    const std::size_t at_long = std::min((count + 1) / 2, all[0].room(seat));
    all[0].count = at_long, all[1].count = std::min(count - at_long, at_long);
    const std::size_t rest = count - all[0].count - all[1].count;
    all[2].count = std::min((rest + 1) / 2, all[2].room(seat));
    all[3].count = std::min(rest - all[2].count, all[3].room(seat));
  }
  std::vector<Place> places;
  for (const Side& side : all) {
    if (side.count > 0) place(side, seat, gap, places);
  }
  return places;
}

std::vector<Place> flanks(const Vec3& thing, const Vec3& beside) {
  const double back = (beside.y - thing.y) / 2, aside = (thing.x + beside.x) / 2 + kGap;
  return {{{back, aside}, 0}, {{back, -aside}, 0}};
}

std::vector<Place> wings(const Vec3& sofa, const Vec3& chair) {
  const double ahead = (sofa.y + chair.x) / 2 + 0.15, aside = (sofa.x + chair.y) / 2 - 0.1;
  return {{{ahead, aside}, -kPi / 2}, {{ahead, -aside}, kPi / 2}};
}

Place before(const Vec3& thing, const Vec3& other, double gap) { return {{(thing.y + other.y) / 2 + gap, 0}, 0}; }

}  // namespace inhabit::layout
