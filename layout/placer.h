#pragma once
#include "core/rng.h"
#include "layout/contacts.h"

namespace inhabit::layout {

/// Puts one particle after the other where it suits best among sampled poses: the start of a layout, and the discrete
/// moves between projections that free objects which lock each other (layout.md, "What our own trials found").
///
/// A sampled pose is first fitted to the particle's own constraints and pushed out of what it meets, by the very
/// projections of the solver with everything else pinned; so proposals follow walls, circles round a focal point and
/// gaps between neighbours without a rule for any of them.
class Placer {
 public:
  Placer(const Problem& problem, State& x);

  /// Who stands in the room; the others are ignored. Builds the neighbour grid for the present state.
  void reset(const std::vector<bool>& placed);
  bool placed(std::uint32_t body) const { return placed_[body]; }

  /// Takes a particle out of the room.
  void lift(std::uint32_t body);
  /// Puts it back where it is now.
  void drop(std::uint32_t body);
  /// Samples `tries` poses for a lifted particle, moves it to the best and drops it. Returns the cost there.
  double place(std::uint32_t body, Rng& rng, int tries);
  /// Squared energy of everything that concerns this particle, with overlaps counted a little more: see kOverlapEdge.
  double cost(std::uint32_t body) const;
  /// Particles that overlap it where it is, and how deep.
  void overlaps(std::uint32_t body, std::vector<std::pair<std::uint32_t, double>>& out) const;

 private:
  struct Share {
    std::uint32_t term = 0, member = 0;
  };
  State::Body propose(std::uint32_t body, Rng& rng) const;
  void fit(std::uint32_t body, bool push);
  /// Overlaps, zones and the border; stops counting at `limit`.
  double hard_cost(std::uint32_t body, double limit) const;
  double term_cost(std::uint32_t body, double limit) const;
  double pair_cost(std::uint32_t a, std::uint32_t b) const;
  double border_cost(std::uint32_t body) const;
  double center_cost(std::uint32_t body) const;
  bool all_placed(const Anchor& a, std::uint32_t self) const;
  /// Calls f(other) for everybody near, until it says false.
  template <class F>
  void for_neighbours(std::uint32_t body, F&& f) const;
  /// The circles about two bodies, without their zones, meet.
  bool meet(std::uint32_t a, std::uint32_t b) const {
    const double reach = p_.data.bodies[a].radius + p_.data.bodies[b].radius;
    const Vec2 gap = x_.bodies[a].p - x_.bodies[b].p;
    return dot(gap, gap) < reach * reach;
  }
  std::size_t cell(Vec2 p) const;
  void count_centers(std::uint32_t body, double sign);

  const Problem& p_;
  State& x_;
  std::vector<bool> placed_;
  core::Lists<Share> shares_;  ///< centre-of-mass terms of each body
  std::vector<Vec2> center_sum_;
  std::vector<double> center_mass_;
  /// A grid of the small bodies as linked lists; the large ones are visited always.
  bool all_ = false;
  std::vector<std::uint32_t> large_, head_, next_, prev_, cell_of_;
  std::vector<bool> is_large_;
  std::vector<double> reach_;  ///< of the body with its zones
  double small_reach_ = 0, cell_size_ = 1;
  std::int64_t columns_ = 1, rows_ = 1;
  Vec2 origin_;
  struct Heading {
    double angle = 0;
    Vec2 front;
  };
  std::vector<Heading> wall_headings_;  ///< along and across the walls, four of each
};

}  // namespace inhabit::layout
