#pragma once
#include <tuple>

#include "core/lists.h"
#include "layout/constraint_table.h"

/// A scene made ready for the solver: particles, terms, zones. Compiled once, shared by all starts, never changed.
namespace inhabit::layout {

/// Where a term comes from.
struct Origin {
  std::string_view type;
  Ref a, b;
};
/// Of every term, by its type's place in TermTypes and its index. Reports want them; the solver does not carry them.
using Origins = std::array<std::vector<Origin>, TermTypes::size>;

template <class... T>
std::tuple<std::vector<T>...> term_arrays(TypeList<T...>);

/// One term by its type's place in TermTypes and its index; `Problem::touching` lists them per body.
/// Requires: index < 2^27.
class TermId {
 public:
  TermId() = default;
  TermId(std::uint32_t type, std::uint32_t index) : bits_(index * kTypes + type) {}
  std::uint32_t type() const { return bits_ % kTypes; }
  std::uint32_t index() const { return bits_ / kTypes; }
  friend bool operator==(TermId, TermId) = default;

 private:
  static constexpr std::uint32_t kTypes = 32;
  static_assert(TermTypes::size <= kTypes);
  std::uint32_t bits_ = 0;
};

/// How strongly terms are asked for.
struct Slot {
  pbd::Schedule schedule = pbd::Schedule::constant;
  double k0 = 1;
  double gamma = 1;  ///< weight in the energy, TVCG eq. 1
  friend bool operator==(const Slot&, const Slot&) = default;
};

struct Problem {
  const Scene* scene = nullptr;
  Room room;
  Bodies data;
  decltype(term_arrays(TermTypes{})) terms;
  std::vector<Zone> zones;
  std::vector<Slot> slots;
  /// Sets that do not collide with themselves are bits of BoxData::off; from this one on they share the last bit and
  /// stand in `off_pairs`, sorted, both ways round. (Of `sphere` sets the last bit is all: pairs of two of them are
  /// circles too.)
  static constexpr int kOverflowSet = 63;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> off_pairs;
  std::uint32_t collision_slot = 0;
  double collision_gamma = 150, boundary_gamma = 20;
  bool collisions = true;  ///< false when a constraint turns them all off
  bool boundary = true;
  std::vector<std::uint32_t> body_of_object, box_of_object;
  std::vector<double> base_of_object;        ///< z of each object's base
  std::vector<std::uint32_t> body_of_group;  ///< rigid groups: their particle; none = 0xffffffff
  std::vector<Pose> start;                   ///< given pose of each body
  std::vector<bool> has_start;               ///< position given
  std::vector<bool> has_angle;
  /// Terms that read each body, as ranges of `touching`.
  std::vector<std::uint32_t> touching_first;
  std::vector<TermId> touching;
  /// Who stands on each body, or has a place of its own beside it: they go along when it is taken elsewhere.
  core::Lists<std::uint32_t> followers;
  core::Lists<std::uint32_t> zones_of_body;  ///< zones that ride on it
  std::vector<std::uint32_t> room_zones;     ///< zones that ride on nobody

  template <class T>
  const std::vector<T>& of() const {
    return std::get<std::vector<T>>(terms);
  }
  double gamma(const Term& term) const { return slots[term.slot].gamma; }
  /// Calls f(term, id) for each term, type by type.
  template <class F>
  void for_each_term(F&& f) const {
    std::uint32_t type = 0;
    for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
      const auto& list = of<T>();
      for (std::uint32_t i = 0; i < list.size(); ++i) f(list[i], TermId{type, i});
      ++type;
    });
  }
  /// Calls f(term) for the term with this id.
  template <class F>
  void with_term(TermId id, F&& f) const {
    std::uint32_t type = 0;
    for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
      if (type++ == id.type()) f(of<T>()[id.index()]);
    });
  }

  /// Calls f(box, body) for the boxes of every particle that can move, in order.
  template <class F>
  void for_each_movable_box(F&& f) const {
    for (std::uint32_t b = 0; b < data.bodies.size(); ++b) {
      const BodyData& d = data.bodies[b];
      for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes && d.w > 0; ++i) f(i, b);
    }
  }

  /// Radius of the circle about the zone's particle, or its own centre, that holds it whatever the particle's heading.
  double zone_reach(std::uint32_t z) const {
    const Zone& zone = zones[z];
    if (!zone.owner || zone.owner->group()) return zone.radius;
    const double ride = zone.owner->rider == Anchor::kBody ? 0 : length(data.riders[zone.owner->rider].offset);
    return ride + length(zone.box.center) + zone.radius;
  }
  /// May the box have to leave the zone, wherever they are?
  bool zone_concerns(std::uint32_t z, std::uint32_t b) const {
    const BoxData& d = data.boxes[b];
    const Zone& zone = zones[z];
    const bool own = zone.owner && zone.owner->body == d.body;
    return !own && d.low < zone.high && zone.low < d.high && zone.concerns(b);
  }
  /// Both are members of a set that does not collide with itself.
  bool exempt(std::uint32_t i, std::uint32_t j) const {
    const std::uint64_t shared = data.boxes[i].off & data.boxes[j].off;
    if (shared >> kOverflowSet == 0) return shared != 0;
    return (shared & ~(std::uint64_t{1} << kOverflowSet)) != 0 ||
           std::ranges::binary_search(off_pairs, std::pair{i, j});
  }
  /// May two boxes touch? False for one body, disjoint heights, and sets that do not collide.
  bool collide(std::uint32_t i, std::uint32_t j) const {
    const BoxData &a = data.boxes[i], &b = data.boxes[j];
    return a.body != b.body && !exempt(i, j) && a.low < b.high - 1e-3 && b.low < a.high - 1e-3 &&
           (data.bodies[a.body].w > 0 || data.bodies[b.body].w > 0);
  }

  explicit Problem(const Scene& s) : scene(&s), room(s.space) {}
};

/// Errors: a rigid group without its members' positions, stacks that contain themselves, a fixed object without a pose.
/// Fills `origins` when there is one.
Result<Problem> compile(const Scene& scene, Origins* origins = nullptr);

/// The pose of every object and group of the scene in this state.
struct Placement;
Placement placement_of(const Problem& problem, const State& x);

}  // namespace inhabit::layout
