#include "crowd/models/velocity_obstacle.h"

#include <cmath>

namespace inhabit::crowd {
namespace {

using End = VelocityObstacle::End;

/// A tangent from the origin to a disc.
struct Leg {
  Vec2 direction;
  double length = 0;  ///< to where it touches
};

/// The tangent that leaves the disc on its right (side = 1: it is the left leg) or on its left (side = -1).
Leg leg_along(Vec2 centre, double r, double side) {
  const double cc = dot(centre, centre), l = std::sqrt(std::max(cc - r * r, 0.0));
  return {(1 / cc) * Vec2{l * centre.x - side * r * centre.y, l * centre.y + side * r * centre.x}, l};
}

/// The nearest of the candidates so far.
struct Nearest {
  Vec2 v;
  double distance = 1e300;
  std::optional<BorderPoint> at;
  void offer(Vec2 point, Vec2 normal) {
    const double d = length(v - point);
    if (d < distance) distance = d, at = BorderPoint{point, normal};
  }
};

void offer_cut_off(const VelocityObstacle& o, Nearest& nearest) {
  const Vec2 a = (1 / o.tau) * o.a, b = (1 / o.tau) * o.b, along = b - a, v = nearest.v;
  const double r = o.r / o.tau, l = length(along), at = dot(v - a, along);
  const bool past_a = at <= 0, past_b = at >= l * l;
  if (l > 0 && ((!past_a || o.right == End::corner) && (!past_b || o.left == End::corner))) {
    // The line at distance r before the segment, when it lies between the segment and the origin.
    const Vec2 n = (1 / l) * perp(along);
    if (-dot(n, a) >= r) nearest.offer(v + (r - dot(n, v - a)) * n, n);
    return;
  }
  if (l > 0 && !past_a && !past_b) return;
  const Vec2 end = past_b ? b : a, w = v - end;
  const Vec2 n = w == Vec2{} ? -unit(end) : unit(w), q = end + r * n;
  // The half of the circle that the origin sees.
  if (dot(n, q) <= 0) nearest.offer(q, n);
}

}  // namespace

BorderPoint nearest_border(Vec2 x, double r, double tau, Vec2 v) {
  const Vec2 centre = (1 / tau) * x, w = v - centre;
  const double wx = dot(w, x), ww = dot(w, w);
  // Seen from the centre of the cut-off circle v lies between the points where the legs touch.
  if (wx <= 0 && wx * wx >= r * r * ww) {
    const Vec2 n = ww > 0 ? (1 / std::sqrt(ww)) * w : -unit(x);
    return {centre + (r / tau) * n, n};
  }
  const double side = cross(x, v) > 0 ? 1 : -1;
  const Vec2 along = leg_along(x, r, side).direction;
  return {dot(v, along) * along, side * perp(along)};
}

std::optional<BorderPoint> nearest_border(const VelocityObstacle& o, Vec2 v) {
  Nearest nearest{v};
  offer_cut_off(o, nearest);
  // Seen obliquely both legs may touch the same end: the outermost count.
  if (o.right == End::free) {
    const Leg at_a = leg_along(o.a, o.r, -1), at_b = leg_along(o.b, o.r, -1);
    const Leg leg = cross(at_a.direction, at_b.direction) < 0 ? at_b : at_a;
    const double s = dot(v, leg.direction);
    if (s * o.tau >= leg.length) nearest.offer(s * leg.direction, -perp(leg.direction));
  }
  if (o.left == End::free) {
    const Leg at_a = leg_along(o.a, o.r, 1), at_b = leg_along(o.b, o.r, 1);
    const Leg leg = cross(at_b.direction, at_a.direction) > 0 ? at_a : at_b;
    const double s = dot(v, leg.direction);
    if (s * o.tau >= leg.length) nearest.offer(s * leg.direction, perp(leg.direction));
  }
  if (!nearest.at && o.right == End::free && o.left == End::free) {
    // Just where a leg begins, rounding has refused both it and the circle.
    const Vec2 s = nearest_on_segment((1 / o.tau) * o.a, (1 / o.tau) * o.b, v), n = unit(v - s);
    nearest.offer(s + (o.r / o.tau) * n, n);
  }
  return nearest.at;
}

}  // namespace inhabit::crowd
