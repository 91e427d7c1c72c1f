#pragma once
#include "core/rng.h"
#include "layout/constraint_table.h"
#include "layout/test_world.h"

/// For tests only: random instances of every term type. A type in TermTypes without Instances<T> does not compile.
namespace inhabit::layout::testing {

/// any: everything that may occur, groups, riders and pinned particles too. simple: one projection at k = 1 satisfies
/// it. pair: between two movable particles of equal mass.
enum class Form { any, simple, pair };

template <class T>
struct Missing : std::false_type {};

/// What a type must specialise:
///   kName; kPairs: has a pair form; kHalf: what is left of the error after half a step of a simple instance
///   random(world, rng, scale, form): a term over particles that it adds to the world
///   tied(term, world), if the result may depend on the order of particles: true when it does
///   satisfy(term, world): changes parameters or places so that C = 0; false when this instance cannot be
template <class T>
struct Instances {
  static_assert(Missing<T>::value,
                "a term type in TermTypes lacks its random instances: specialise Instances<T> in "
                "layout/constraint_instances.h, so that the property tests cover it");
};

namespace detail_of_instances {

inline Vec2 somewhere(Rng& rng, double scale) { return {rng.uniform(0, 10 * scale), rng.uniform(0, 8 * scale)}; }
inline double heading(Rng& rng) { return rng.uniform(-kPi, kPi); }
inline Vec3 size(Rng& rng, double scale) { return {rng.uniform(0.1, 2) * scale, rng.uniform(0.1, 2) * scale, scale}; }

/// A particle; in any form now and then a rider on one, or a group of two.
inline Anchor anchor(World& w, Rng& rng, double scale, Form form, bool may_be_group = true) {
  const double mass = form == Form::pair ? 1 : std::pow(10.0, rng.uniform(-2, 2));
  const Anchor a = w.add(somewhere(rng, scale), heading(rng), mass, size(rng, scale));
  if (form != Form::any) return a;
  const double which = rng.uniform();
  if (which < 0.2) return w.ride(a, {rng.uniform(-scale, scale), rng.uniform(-scale, scale)}, heading(rng));
  if (which < 0.4 && may_be_group) return w.group({a, w.add(somewhere(rng, scale), heading(rng))});
  return a;
}

}  // namespace detail_of_instances

template <>
struct Instances<DistanceTerm> {
  static constexpr std::string_view kName = "distance";
  static constexpr bool kPairs = true;
  static constexpr double kHalf = 0.5;
  static DistanceTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    DistanceTerm c;
    c.a = anchor(w, rng, scale, form), c.b = anchor(w, rng, scale, form);
    c.low = rng.uniform(0, 5 * scale);
    const double which = rng.uniform();
    c.high = which < 0.5 ? c.low : which < 0.75 ? 1e300 : c.low + rng.uniform(0, scale);
    c.b_pinned = form != Form::pair && rng.uniform() < 0.3;
    return c;
  }
  static bool satisfy(DistanceTerm& c, World& w) {
    c.low = c.high = distance(w.x.position(c.a), w.x.position(c.b));
    return true;
  }
};

template <>
struct Instances<TrafficLaneTerm> {
  static constexpr std::string_view kName = "traffic lane";
  static constexpr bool kPairs = true;
  static constexpr double kHalf = 0.5;
  static TrafficLaneTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    TrafficLaneTerm c;
    c.member = anchor(w, rng, scale, form), c.from = anchor(w, rng, scale, form);
    c.heading = direction(heading(rng)), c.clearance = rng.uniform(0, 5 * scale);
    c.from_fixed = form != Form::pair && rng.uniform() < 0.5;
    return c;
  }
  static bool satisfy(TrafficLaneTerm& c, World& w) {
    c.clearance += detail::lane_offset(c, w.x).gap;
    return true;
  }
};

template <>
struct Instances<CenterTerm> {
  static constexpr std::string_view kName = "centre of mass";
  static constexpr bool kPairs = true;
  static constexpr double kHalf = 0.5;
  static CenterTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    CenterTerm c;
    const double which = form == Form::pair ? 0.5 : rng.uniform();
    c.target = which < 0.4   ? CenterTerm::Target::point
               : which < 0.8 ? CenterTerm::Target::front_ray
                             : CenterTerm::Target::room;
    c.point = somewhere(rng, scale);
    if (c.target == CenterTerm::Target::front_ray || (which < 0.2)) c.on = anchor(w, rng, scale, form);
    c.on_fixed = c.target != CenterTerm::Target::front_ray || (form != Form::pair && rng.uniform() < 0.5);
    const std::uint32_t n = form == Form::pair ? 1 : 1 + rng.index(5);
    for (std::uint32_t i = 0; i < n; ++i) {
      c.members.push_back(anchor(w, rng, scale, form));
      c.masses.push_back(c.target == CenterTerm::Target::room ? rng.uniform(0.1, 2) : w.x.mass(c.members.back()));
      c.mass += c.masses.back();
    }
    return c;
  }
  static bool satisfy(CenterTerm& c, World& w) {
    if (c.target == CenterTerm::Target::point) {
      const Vec2 mu = center_of_mass(c, w.x);
      c.point = c.on ? rotate_back(mu - w.x.position(*c.on), w.x.front(*c.on)) : mu;
      return true;
    }
    for (int i = 0; i < 5 && error(c, w.x) > 0; ++i) {
      const Vec2 mu = center_of_mass(c, w.x), off = detail::center_target(c, w.x, mu) - mu;
      for (const Anchor& m : c.members) w.x.shift(m, off);
    }
    return true;
  }
};

template <>
struct Instances<AlignTerm> {
  static constexpr std::string_view kName = "align";
  static constexpr bool kPairs = true;
  static constexpr double kHalf = 0.5;
  static AlignTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    AlignTerm c;
    c.a = anchor(w, rng, scale, form), c.b = anchor(w, rng, scale, form);
    c.normal = direction(heading(rng));
    return c;
  }
  static bool satisfy(AlignTerm& c, World& w) {
    c.normal = perp(unit(w.x.position(c.a) - w.x.position(c.b)));
    return true;
  }
};

template <>
struct Instances<CurveTerm> {
  static constexpr std::string_view kName = "curve";
  static constexpr bool kPairs = false;
  static constexpr double kHalf = 0.5;
  static CurveTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    CurveTerm c;
    const std::uint32_t n = 1 + rng.index(6);
    // Groups have no place on a curve of their own, and neighbours on one particle cannot part: riders on different
    // ones.
    for (std::uint32_t i = 0; i < n; ++i) c.members.push_back(anchor(w, rng, scale, form, false));
    c.group = w.group(c.members).index();
    const double which = rng.uniform();
    c.curve.kind = which < 0.4 ? Curve::Kind::segment : Curve::Kind::arc;
    c.curve.medial_axis = which < 0.15;
    c.curve.start = somewhere(rng, scale);
    if (c.curve.kind == Curve::Kind::segment) {
      c.curve.end = somewhere(rng, scale);
    } else {
      c.curve.center = somewhere(rng, scale);
      c.curve.end = c.curve.center + rotate(c.curve.start - c.curve.center, direction(heading(rng)));
    }
    if (form == Form::any && rng.uniform() < 0.5) c.spacing = rng.uniform(0, 3 * scale);
    if (rng.uniform() < 0.3)
      w.x.frames[c.group] = {{rng.uniform(-scale, scale), rng.uniform(-scale, scale)}, heading(rng)};
    return c;
  }
  /// Members beyond one end of the curve share its parameter; then their places in the list and their numbers decide.
  static bool tied(const CurveTerm& c, const World& w) {
    if (!c.spacing) return false;
    const detail::PlacedCurve curve = detail::placed_curve(c, w.x);
    std::vector<double> parameters;
    for (const Anchor& m : c.members) parameters.push_back(detail::nearest_on_curve(curve, w.x.position(m)).parameter);
    std::ranges::sort(parameters);
    return std::ranges::adjacent_find(parameters) != parameters.end();
  }
  static bool satisfy(CurveTerm& c, World& w) {
    c.spacing.reset();
    if (c.curve.medial_axis) return false;
    const detail::PlacedCurve curve = detail::placed_curve(c, w.x);
    for (const Anchor& m : c.members) {
      const Vec2 p = w.x.position(m);
      w.x.shift(m, detail::nearest_on_curve(curve, p).point - p);
    }
    return true;
  }
};

template <>
struct Instances<RegionTerm> {
  static constexpr std::string_view kName = "region";
  static constexpr bool kPairs = false;
  static constexpr double kHalf = 0.5;
  static RegionTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    RegionTerm c;
    c.a = anchor(w, rng, scale, form, false);
    c.size = size(rng, scale);
    const Vec2 p = somewhere(rng, scale);
    // At least 3 by 3: whatever its heading, a box of 2 by 2 fits.
    const double x = rng.uniform(3, 5) * scale, y = rng.uniform(3, 5) * scale;
    Ring zone = {p, p + Vec2{x, 0}, p + Vec2{x, y}, p + Vec2{0, y}};
    if (form == Form::any && rng.uniform() < 0.5) zone.insert(zone.begin() + 3, p + Vec2{x / 3, y / 3});
    c.zone = std::make_shared<const Room>(zone, std::vector<Ring>{});
    return c;
  }
  static bool satisfy(RegionTerm& c, World& w) {
    w.x.shift(c.a, c.zone->extent().center() - w.x.position(c.a));
    return error(c, w.x) == 0;
  }
};

template <>
struct Instances<StackingTerm> {
  static constexpr std::string_view kName = "stacking";
  static constexpr bool kPairs = true;
  static constexpr double kHalf = 0.5;
  static StackingTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    StackingTerm c;
    c.upper = anchor(w, rng, scale, form), c.lower = anchor(w, rng, scale, form);
    c.upper_size = size(rng, scale), c.lower_size = size(rng, scale);
    c.anywhere = rng.uniform() < 0.5;
    return c;
  }
  static bool satisfy(StackingTerm& c, World& w) {
    w.x.shift(c.upper, w.x.position(c.lower) - w.x.position(c.upper));
    return true;
  }
};

template <>
struct Instances<WallDistanceTerm> {
  static constexpr std::string_view kName = "wall distance";
  static constexpr bool kPairs = false;
  static constexpr double kHalf = 0.5;
  static WallDistanceTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    WallDistanceTerm c;
    c.a = anchor(w, rng, scale, form, false);
    c.half_depth = form == Form::simple ? 0 : rng.uniform(0, scale);
    c.distance = rng.uniform(0, 6 * scale);
    // Away from one wall may be towards another; towards the nearest one there is no other in between.
    if (form == Form::simple) c.distance = rng.uniform() * w.room().nearest_wall(w.x.position(c.a)).distance;
    if (form == Form::any && rng.uniform() < 0.3) c.wall = static_cast<int>(rng.index(4));
    return c;
  }
  static bool satisfy(WallDistanceTerm& c, World& w) {
    c.distance += error(c, w.x);
    return true;
  }
};

template <>
struct Instances<WallOrientationTerm> {
  static constexpr std::string_view kName = "wall orientation";
  static constexpr bool kPairs = false;
  static constexpr double kHalf = 0.5;
  static WallOrientationTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    WallOrientationTerm c;
    c.a = anchor(w, rng, scale, form, false);
    c.angle = rng.uniform(-2 * kPi, 2 * kPi);
    // Turning swings the back face, perhaps to another wall.
    c.half_depth = form == Form::simple ? 0 : rng.uniform(0, scale);
    if (rng.uniform() < 0.3) c.wall = static_cast<int>(rng.index(4));
    return c;
  }
  static bool satisfy(WallOrientationTerm& c, World& w) {
    c.angle += error(c, w.x);
    return true;
  }
};

template <>
struct Instances<OrientationTerm> {
  static constexpr std::string_view kName = "orientation";
  static constexpr bool kPairs = false;
  static constexpr double kHalf = 0.5;
  static OrientationTerm random(World& w, Rng& rng, double scale, Form form) {
    using namespace detail_of_instances;
    OrientationTerm c;
    c.a = anchor(w, rng, scale, form), c.to = anchor(w, rng, scale, form);
    c.angle = rng.uniform(-2 * kPi, 2 * kPi), c.parallel = rng.uniform() < 0.5;
    return c;
  }
  static bool satisfy(OrientationTerm& c, World& w) {
    c.angle += error(c, w.x);
    return true;
  }
};

}  // namespace inhabit::layout::testing
