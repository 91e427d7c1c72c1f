#pragma once
#include <algorithm>

#include "core/type_list.h"
#include "scene/field.h"

/// The parameters of every constraint: what a scene document says about it. What it means (error and projection) stands
/// in layout/constraints/, one file per kind; simulated annealing reads the same parameters. Equation numbers:
/// docs/papers.md.
namespace inhabit::scene {

/// How strongly a constraint is held; absent: the kind's default.
struct Strength {
  std::optional<double> stiffness;  ///< k0 in [0, 1]
  std::optional<double> weight;     ///< gamma of the energy, TVCG eq. 1
  Extras extras;
  friend bool operator==(const Strength&, const Strength&) = default;
};

/// Two centres at a distance, at least `min` or at most `max` apart (TVCG eq. 4).
struct Distance : Strength {
  std::array<Ref, 2> between;
  std::optional<double> distance, min, max;
  static constexpr std::string_view kName = "distance";
  /// At least one of these must be given.
  static constexpr std::array<std::string_view, 3> kNeedsOneOf = {"distance", "min", "max"};
  static constexpr std::array kFields = {
      Field<Distance>{"between", &Distance::between, "the two objects or groups", "", 0, 0, true},
      Field<Distance>{"distance", &Distance::distance, "wanted distance between the centres", "m", 0, 1e5},
      Field<Distance>{"min", &Distance::min, "at least this far apart", "m", 0, 1e5},
      Field<Distance>{"max", &Distance::max, "at most this far apart", "m", 0, 1e5}};
};

/// Every member at a distance from the focal object (TVCG 3.3.2).
struct FocalDistance : Strength {
  Ref focal;
  Members members;
  std::optional<double> distance, min, max;
  bool focal_fixed = false;
  static constexpr std::string_view kName = "focal_distance";
  /// At least one of these must be given.
  static constexpr std::array<std::string_view, 3> kNeedsOneOf = {"distance", "min", "max"};
  static constexpr std::array kFields = {
      Field<FocalDistance>{"focal", &FocalDistance::focal, "the object they gather round", "", 0, 0, true},
      Field<FocalDistance>{"members", &FocalDistance::members, "who gathers round it", "", 0, 0, true},
      Field<FocalDistance>{"distance", &FocalDistance::distance, "wanted distance between the centres", "m", 0, 1e5},
      Field<FocalDistance>{"min", &FocalDistance::min, "at least this far", "m", 0, 1e5},
      Field<FocalDistance>{"max", &FocalDistance::max, "at most this far", "m", 0, 1e5},
      Field<FocalDistance>{"focal_fixed", &FocalDistance::focal_fixed, "this constraint never moves the focal object"}};
};

/// A lane that starts at an object and stays free of the members' centres (TVCG eq. 7, 8).
struct TrafficLane : Strength {
  Ref from;
  double angle = 0;
  double clearance = 0.6;
  Members members;
  bool from_fixed = true;
  static constexpr std::string_view kName = "traffic_lane";
  static constexpr std::array kFields = {
      Field<TrafficLane>{"from", &TrafficLane::from, "the object that the lane starts at", "", 0, 0, true},
      Field<TrafficLane>{"angle", &TrafficLane::angle, "direction of the lane, from the object's front", "rad",
                         -2 * kPi, 2 * kPi},
      Field<TrafficLane>{"clearance", &TrafficLane::clearance,
                         "smallest distance of a member's centre from the lane's middle", "m", 0, 1e4},
      Field<TrafficLane>{"members", &TrafficLane::members, "who stays out of it", "", 0, 0, true},
      Field<TrafficLane>{"from_fixed", &TrafficLane::from_fixed,
                         "this constraint never moves the object it starts at"}};
};

/// The members' centre of mass at a point of the room, or of the object they stand on (TVCG eq. 9, corrected).
struct HeatPoint : Strength {
  Members members;
  Vec2 point;
  Ref on;
  bool on_fixed = true;
  static constexpr std::string_view kName = "heat_point";
  static constexpr std::array kFields = {
      Field<HeatPoint>{"members", &HeatPoint::members, "whose centre of mass", "", 0, 0, true},
      Field<HeatPoint>{"point", &HeatPoint::point, "where it should be", "m", -1e5, 1e5, true},
      Field<HeatPoint>{"on", &HeatPoint::on,
                       "`point` is (to the front, to the left) of this object's centre and moves with it"},
      Field<HeatPoint>{"on_fixed", &HeatPoint::on_fixed, "this constraint never moves that object"}};
};

/// The members' centre of mass on the ray from the focal object's front (TVCG eq. 11, corrected).
struct FocalSymmetry : Strength {
  Ref focal;
  Members members;
  bool focal_fixed = true;
  static constexpr std::string_view kName = "focal_symmetry";
  static constexpr std::array kFields = {
      Field<FocalSymmetry>{"focal", &FocalSymmetry::focal, "whose front ray", "", 0, 0, true},
      Field<FocalSymmetry>{"members", &FocalSymmetry::members, "whose centre of mass", "", 0, 0, true},
      Field<FocalSymmetry>{"focal_fixed", &FocalSymmetry::focal_fixed, "this constraint never moves the focal object"}};
};

/// The members' centre, weighted by footprint, at the room's centroid (TVCG eq. 12). No members: everything.
struct VisualBalance : Strength {
  Members members;
  static constexpr std::string_view kName = "visual_balance";
  static constexpr std::array kFields = {
      Field<VisualBalance>{"members", &VisualBalance::members, "who counts; all objects when absent"}};
};

/// The back face's centre at a distance from the nearest wall, or from the one named (TVCG eq. 13).
struct WallDistance : Strength {
  Members members;
  double distance = 0;
  std::optional<int> wall;
  static constexpr std::string_view kName = "wall_distance";
  static constexpr std::array kFields = {
      Field<WallDistance>{"members", &WallDistance::members, "who stands at a wall", "", 0, 0, true},
      Field<WallDistance>{"distance", &WallDistance::distance, "from the back face's centre to the wall", "m", 0, 1e4},
      Field<WallDistance>{"wall", &WallDistance::wall, "number of the wall; the nearest one when absent", "", 0, 1e6}};
};

/// The heading relative to the inward normal of the nearest wall: 0 = back to the wall (TVCG eq. 17).
struct WallOrientation : Strength {
  Members members;
  double angle = 0;
  std::optional<int> wall;
  static constexpr std::string_view kName = "wall_orientation";
  static constexpr std::array kFields = {
      Field<WallOrientation>{"members", &WallOrientation::members, "who is turned", "", 0, 0, true},
      Field<WallOrientation>{"angle", &WallOrientation::angle, "heading, from the wall's inward normal", "rad",
                             -2 * kPi, 2 * kPi},
      Field<WallOrientation>{"wall", &WallOrientation::wall, "number of the wall; the nearest one when absent", "", 0,
                             1e6}};
};

/// Heading relative to another object: looking at it (`bearing`) or along its own heading (`parallel`) (TVCG eq. 16).
struct Orientation : Strength {
  Members members;
  Ref to;
  double angle = 0;
  Choice relative = 0;
  static constexpr std::string_view kName = "orientation";
  static constexpr std::array kFields = {
      Field<Orientation>{"members", &Orientation::members, "who is turned", "", 0, 0, true},
      Field<Orientation>{"to", &Orientation::to, "the object they look at or run parallel to", "", 0, 0, true},
      Field<Orientation>{"angle", &Orientation::angle, "offset from that heading; 180 = back turned", "rad", -2 * kPi,
                         2 * kPi},
      Field<Orientation>{"relative", &Orientation::relative,
                         "to the bearing of the other object, or parallel to its heading", "", 0, 0, false,
                         "bearing|parallel"}};
};

/// One object on top of another: z, and x and y equal or anywhere on its top (TVCG eq. 18, 19).
struct Stacking : Strength {
  Ref object, on;
  bool anywhere = false;
  static constexpr std::string_view kName = "stacking";
  static constexpr std::array kFields = {
      Field<Stacking>{"object", &Stacking::object, "the upper one", "", 0, 0, true},
      Field<Stacking>{"on", &Stacking::on, "the one that carries it", "", 0, 0, true},
      Field<Stacking>{"anywhere", &Stacking::anywhere, "anywhere on its top instead of centred"}};
};

/// Members stay inside a polygon: a group's fixed zone (thesis 5.2.4).
struct Region : Strength {
  Members members;
  Ring polygon;
  static constexpr std::string_view kName = "region";
  static constexpr std::array kFields = {Field<Region>{"members", &Region::members, "who stays inside", "", 0, 0, true},
                                         Field<Region>{"polygon", &Region::polygon, "the zone", "m", -1e6, 1e6, true}};
};

/// Members (all when absent) stay out of a polygon.
struct KeepOut : Strength {
  Members members;
  Ring polygon;
  static constexpr std::string_view kName = "keep_out";
  static constexpr std::array kFields = {
      Field<KeepOut>{"members", &KeepOut::members, "who stays out; all objects when absent"},
      Field<KeepOut>{"polygon", &KeepOut::polygon, "the zone; not convex is taken as its convex parts", "m", -1e6, 1e6,
                     true}};
};

/// Members in one line: equal coordinates across the axis.
struct Align : Strength {
  Members members;
  double axis = 0;
  static constexpr std::string_view kName = "align";
  static constexpr std::array kFields = {
      Field<Align>{"members", &Align::members, "who stands in line", "", 0, 0, true},
      Field<Align>{"axis", &Align::axis, "direction of the line, from +x", "rad", -2 * kPi, 2 * kPi}};
};

/// A straight corridor between two doors stays free (Yu et al. 2011, 4.3, straight instead of a Bezier curve).
struct Pathway : Strength {
  std::array<Ref, 2> between;
  double width = 0.8;
  static constexpr std::string_view kName = "pathway";
  static constexpr std::array kFields = {
      Field<Pathway>{"between", &Pathway::between, "two doors", "", 0, 0, true},
      Field<Pathway>{"width", &Pathway::width, "width of the corridor", "m", 0.1, 100}};
};

/// The object's view cone (its `view`) stays free.
struct Visibility : Strength {
  Members members;
  static constexpr std::string_view kName = "visibility";
  static constexpr std::array kFields = {
      Field<Visibility>{"members", &Visibility::members, "whose view cone", "", 0, 0, true}};
};

/// Free space in front of a face. Every object's `clearance` asks for it by default; this adds to it (TVCG eq. 14).
struct Accessibility : Strength {
  Ref object;
  Choice face = 2;
  double depth = 0.6;
  Members members;
  static constexpr std::string_view kName = "accessibility";
  static constexpr std::array kFields = {
      Field<Accessibility>{"object", &Accessibility::object, "whose face", "", 0, 0, true},
      Field<Accessibility>{"face", &Accessibility::face, "which face", "", 0, 0, false, "back|left|front|right"},
      Field<Accessibility>{"depth", &Accessibility::depth, "free depth wanted", "m", 0, 100},
      Field<Accessibility>{"members", &Accessibility::members, "who keeps out of it; everyone when absent"}};
};

/// Boxes do not overlap. On for everything by default; this changes how, or takes members out of it (TVCG eq. 15).
struct Collision : Strength {
  Members members;
  Choice mode = 0;
  static constexpr std::string_view kName = "collision";
  static constexpr std::array kFields = {
      Field<Collision>{"members", &Collision::members, "whose collisions with each other; everyone's when absent"},
      Field<Collision>{"mode", &Collision::mode, "oriented boxes, the papers' bounding circles, or none", "", 0, 0,
                       false, "box|sphere|off"}};
};

/// Every constraint there is, in the order in which they are projected. This line is the only registration of a kind.
using ConstraintKinds =
    TypeList<Distance, FocalDistance, TrafficLane, HeatPoint, FocalSymmetry, VisualBalance, Align, Region, KeepOut,
             Pathway, Visibility, Accessibility, Stacking, WallDistance, WallOrientation, Orientation, Collision>;

/// One array per kind, with each constraint's place in the document's list so that writing keeps the order.
struct Constraints {
  ConstraintKinds::Arrays arrays;
  /// (kind's place in ConstraintKinds, index in its array), in document order.
  std::vector<std::pair<std::uint16_t, std::uint32_t>> order;

  template <class T>
  const std::vector<T>& of() const {
    return std::get<std::vector<T>>(arrays);
  }
  template <class T>
  void add(T constraint) {
    std::uint16_t kind = 0, k = 0;
    for_each_type(ConstraintKinds{}, [&]<class K>(std::type_identity<K>) {
      if constexpr (std::is_same_v<K, T>) kind = k;
      ++k;
    });
    auto& array = std::get<std::vector<T>>(arrays);
    order.emplace_back(kind, static_cast<std::uint32_t>(array.size()));
    array.push_back(std::move(constraint));
  }
  std::size_t size() const { return order.size(); }

  /// The same constraints in the same order.
  friend bool operator==(const Constraints& a, const Constraints& b) {
    bool same = a.order == b.order;
    for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
      const auto equal = [](const T& p, const T& q) {
        return static_cast<const Strength&>(p) == static_cast<const Strength&>(q) && same_fields(p, q);
      };
      same = same && std::equal(a.of<T>().begin(), a.of<T>().end(), b.of<T>().begin(), b.of<T>().end(), equal);
    });
    return same;
  }
};

}  // namespace inhabit::scene
