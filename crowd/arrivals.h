#pragma once
#include "crowd/people.h"
#include "crowd/spots.h"

/// Sources: who comes when, and where he finds room.
namespace inhabit::crowd {

/// The moments at which people come to one source. Even: `from`, then every 1 / rate seconds; Poisson: after
/// exponentially distributed times from `from` on. Before `until`, and not more than `count`.
class Arrivals {
 public:
  /// `number`: the index of the source, which its random numbers come from.
  Arrivals(const scene::Source& source, std::uint64_t seed, std::size_t number);
  /// How many come at or before `time` who have not been counted yet.
  std::size_t due(double time);
  /// Nobody comes any more.
  bool over() const { return !(next_ < until_) || came_ >= most_; }

 private:
  void advance();
  double rate_, from_, until_, next_;
  bool poisson_;
  std::size_t came_ = 0, most_;
  Rng rng_;
};

/// Lets people in where there is room. One for each source.
class Gate {
 public:
  Gate(const scene::Source& source, std::uint16_t route, const World& world, std::uint64_t seed, std::size_t number);

  /// Everybody who is due by `time` and finds a place at least `widest` + his radius from the rest enters; the others
  /// wait outside, in order. `widest`: the largest radius there is.
  void let_in(double time, float widest, const World& world, std::uint32_t& next_id, Agents& agents);
  std::size_t waiting() const { return waiting_; }
  bool finished() const { return waiting_ == 0 && arrivals_.over(); }
  const scene::Source& source() const { return source_; }
  std::uint16_t route() const { return route_; }

 private:
  std::optional<Vec2> free_place(const Person& person, std::uint32_t id, const World& world) const;

  scene::Source source_;
  std::uint16_t route_;
  std::uint64_t seed_;
  Arrivals arrivals_;
  Bounds box_;  ///< of the area, relative to the origin
  Ring area_;   ///< relative to the origin
  std::size_t waiting_ = 0;
  struct Disc {
    float x, y, radius;
  };
  std::vector<Disc> near_;  ///< who stands in or near the area in this step
};

}  // namespace inhabit::crowd
