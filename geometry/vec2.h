#pragma once
#include <cmath>
#include <compare>

#include "core/angle.h"

namespace inhabit::geometry {
using namespace core;

/// A point or a displacement on the ground, metres.
struct Vec2 {
  double x = 0, y = 0;

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
  constexpr Vec2& operator+=(Vec2 b) { return x += b.x, y += b.y, *this; }
  constexpr Vec2& operator-=(Vec2 b) { return x -= b.x, y -= b.y, *this; }
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator*(Vec2 a, double s) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z of the cross product: positive when b lies counter-clockwise of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// a turned by +90 degrees.
constexpr Vec2 perp(Vec2 a) { return {-a.y, a.x}; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
/// The unit vector along a; (1, 0) for the null vector.
inline Vec2 unit(Vec2 a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : Vec2{1, 0};
}
inline double angle_of(Vec2 a) { return direction_angle(a.x, a.y); }
inline Vec2 direction(double angle) {
  const SinCos sc = sin_cos(angle);
  return {sc.cos, sc.sin};
}
/// v turned by the angle whose direction is `r` (a unit vector).
constexpr Vec2 rotate(Vec2 v, Vec2 r) { return {v.x * r.x - v.y * r.y, v.x * r.y + v.y * r.x}; }
/// v turned back by the angle whose direction is `r`.
constexpr Vec2 rotate_back(Vec2 v, Vec2 r) { return {v.x * r.x + v.y * r.y, v.y * r.x - v.x * r.y}; }

/// Width, depth, height; or a position whose z is the height of an object's base. Metres.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  constexpr Vec2 xy() const { return {x, y}; }
};

/// Where an object stands on the ground and which way its front looks (radians, counter-clockwise from +x).
struct Pose {
  Vec2 p;
  double angle = 0;
  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace inhabit::geometry
