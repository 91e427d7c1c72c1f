#pragma once
#include <memory>

#include "crowd/model.h"
#include "scene/crowd_models.h"

namespace inhabit::crowd {

/// What a step computes and moves, counted from its lists: every addition, multiplication, comparison, root and
/// quotient of numbers as one, and every byte that a loop reads or writes once, gathered ones included.
struct Effort {
  double flops = 0, bytes = 0;
};

/// Position-based crowds (thesis ch. 4, algorithm 2), with the printed errors corrected and these deviations, each for
/// speed or depth of overlap (docs/crowds.md has the figures):
///   - a step is cut into eight sub-steps of one iteration, over-relaxed by 1.8, that share their neighbours, instead
///   of
///     six iterations of one step over-relaxed by 1.2: many small steps beat many iterations; so radii need to grow by
///     2 % only, not 5 %. With `fewest_sub_steps` below that, as few as keep people apart;
///   - neighbours are found with a skin and kept while nobody has moved through half of it, about ten steps;
///   - sub-steps are made by those alone who may touch somebody before the step is over;
///   - collisions to come are looked at once in a step, for the nearest few, with the stiffness that the six
///     passes of the thesis add up to, 1 - (1 - k)^6; their corrections enter as a change of velocity;
///   - the acceleration that is clamped is the one that people want, not what a contact does to them: clamping that
///     pressed people into each other by up to 89 % of their diameter;
///   - walls have the last word in every iteration;
///   - avoidance keeps of the tangential displacement (eq. 4.13) what lies across the relative way. The part along it
///     brings two nearer and faster: with it every encounter stirred people up, to 0.4 m/s sideways in a crowd that all
///     walks one way, and no lanes held;
///   - the velocity that a contact gives to whoever it pushes away falls off in 42 ms (kReboundTime).
class Pbd {
 public:
  using Parameters = scene::PbdModel;
  explicit Pbd(const Parameters& parameters);
  Pbd(Pbd&&) noexcept;
  Pbd& operator=(Pbd&&) noexcept;
  ~Pbd();

  void step(Agents& agents, const Surroundings& around);

  /// Bytes that the model holds, for the bench.
  std::size_t bytes() const;
  /// Of the step made last, finding neighbours not counted.
  Effort effort() const;
  /// How often neighbours were found anew so far.
  std::size_t rebuilds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};
static_assert(Model<Pbd>);

}  // namespace inhabit::crowd
