#pragma once
#include <memory>

#include "layout/constraint.h"

namespace inhabit::layout {

/// A convex part of the floor that boxes stay out of: the accessible space in front of a face, a door's swing, a
/// corridor, a view cone, a keep-out polygon. It rides on its owner, or stands in the room.
///
///   C = |p_i - a_jk| - (b_i + ad_jk) >= 0, active only where box i meets the space     [TVCG eq. 14]
///
/// `by_box` (the default) uses the depth of the separating-axis test for C instead: the papers' spheres push an object
/// by up to a diagonal where centimetres would do, which tight rooms do not have. `sphere` is the paper's own form.
struct Zone : Term {
  std::optional<Anchor> owner;
  Box box;                     ///< in the owner's frame, or in the room
  double radius = 0;           ///< of the circle about the centre that holds it
  double low = 0, high = 1e9;  ///< z range
  /// What few zones have, or many have in common; null when there is nothing of it.
  struct Details {
    Ring ring;                          ///< instead of the box, in the room: convex, counter-clockwise
    std::vector<std::uint32_t> only;    ///< boxes that it concerns, sorted; all when empty
    std::vector<std::uint32_t> exempt;  ///< boxes that may stand in it, sorted
    friend bool operator==(const Details&, const Details&) = default;
  };
  std::shared_ptr<const Details> details;
  static constexpr TermTraits kTraits{.schedule = pbd::Schedule::constant, .stiffness = 0.9, .gamma = 150};

  bool concerns(std::uint32_t b) const {
    return !details || ((details->only.empty() || std::ranges::binary_search(details->only, b)) &&
                        !std::ranges::binary_search(details->exempt, b));
  }
};

inline Box zone_box(const Zone& z, const State& x) {
  if (!z.owner) return z.box;
  const Vec2 f = x.front(*z.owner);
  return {x.position(*z.owner) + rotate(z.box.center, f), rotate(z.box.front, f), z.box.half_depth, z.box.half_width};
}

inline Vec2 zone_center(const Zone& z, const State& x) {
  return z.owner ? x.position(*z.owner) + rotate(z.box.center, x.front(*z.owner)) : z.box.center;
}

/// How far and whither a box has to move to leave the zone.
inline Separation zone_separation(const Zone& z, const Box& box, const State& x, bool sphere) {
  const bool ring = z.details && !z.details->ring.empty();
  const Separation s = ring ? separation(box, std::span<const Vec2>(z.details->ring)) : separation(box, zone_box(z, x));
  if (!sphere || s.depth <= 0) return s;
  const Vec2 d = box.center - zone_center(z, x);
  const double l = length(d);
  return {l > 1e-9 ? (1 / l) * d : s.normal, box.radius() + z.radius - l};
}

namespace detail {

/// The free space wanted in front of face 1 back, 2 left, 3 front, 4 right (TVCG 3.3.8), in the object's frame.
inline Box face_zone(const Vec3& size, int face, double depth) {
  const double hd = size.y / 2, hw = size.x / 2, h = depth / 2;
  switch (face) {
    case 0:
      return {{-hd - h, 0}, {1, 0}, h, hw};
    case 1:
      return {{0, hw + h}, {1, 0}, hd, h};
    case 2:
      return {{hd + h, 0}, {1, 0}, h, hw};
    default:
      return {{0, -hw - h}, {1, 0}, hd, h};
  }
}

}  // namespace detail

template <class Out>
void add_face_zone(Ref object, int face, double depth, const Members& only, const Strength& s, Out& out) {
  if (depth <= 0) return;
  Zone z;
  z.owner = out.anchor(object);
  z.box = detail::face_zone(out.size(object), face, depth);
  z.radius = z.box.radius();
  out.add_zone(std::move(z), {}, object, only, s);
}

template <class Out>
void expand(const scene::Accessibility& c, Out& out) {
  add_face_zone(c.object, c.face, c.depth, c.members, c, out);
}

template <class Out>
void expand(const scene::KeepOut& c, Out& out) {
  for (Ring& part : convex_parts(c.polygon)) {
    Zone z;
    z.box.center = bounds(part).center();
    for (const Vec2 p : part) z.radius = std::max(z.radius, length(p - z.box.center));
    out.add_zone(std::move(z), {.ring = std::move(part)}, Ref{}, c.members, c);
  }
}

/// The straight corridor between the inner middles of two doors (Yu et al. 2011 bend theirs along a Bezier curve).
template <class Out>
void expand(const scene::Pathway& c, Out& out) {
  const Vec2 a = out.door_middle(c.between[0]), b = out.door_middle(c.between[1]);
  const Vec2 u = unit(b - a);
  Zone z;
  z.box = {0.5 * (a + b), u, length(b - a) / 2, c.width / 2};
  z.radius = z.box.radius();
  z.high = 2;
  out.add_zone(std::move(z), {}, Ref{}, Members{}, c);
}

/// The view cone as the box that is as long as the view and as wide as the cone is in its middle.
template <class Out>
void expand(const scene::Visibility& c, Out& out) {
  for (const Ref m : out.objects(c.members)) {
    const auto view = out.view(m);
    if (!view) continue;
    const Vec3 size = out.size(m);
    const SinCos half = sin_cos(std::min(view->angle / 2, 1.4));
    Zone z;
    z.owner = out.anchor(m);
    z.box = {
        {size.y / 2 + view->distance / 2, 0}, {1, 0}, view->distance / 2, view->distance / 2 * half.sin / half.cos};
    z.radius = z.box.radius();
    out.add_zone(std::move(z), {}, m, Members{}, c);
  }
}

}  // namespace inhabit::layout
