#include "session/layout_walk.h"

#include <algorithm>

#include "layout/solver.h"

namespace inhabit::session {
using namespace layout;

namespace {
constexpr double kLeastShift = 1e-3, kLeastTurn = 2e-3;  // metres, radians
}

LayoutWalk::LayoutWalk(const Problem& problem, std::uint64_t seed, double hot, double shift)
    : p_(&problem), x_(problem.data, problem.room), hot_(hot) {
  Options options;
  options.start = Start::random;
  core::Rng rng(seed, 0);
  std::vector<bool> given;
  scatter(problem, options, rng, x_, given);
  for (std::uint32_t b = 0; b < problem.data.bodies.size(); ++b)
    if (problem.data.bodies[b].w > 0 || problem.data.bodies[b].turns) movable_.push_back(b);
  const Vec2 size = problem.room.extent().size();
  reach_ = shift * std::max(size.x, size.y);
  squares_ = score_all().second;
}

double LayoutWalk::zone_square(std::uint32_t z, std::uint32_t i) const {
  const Zone& zone = p_->zones[z];
  const BoxData& box = p_->data.boxes[i];
  const Vec2 gap = x_.boxes[i].center - zone_center(zone, x_);
  const double reach = box.radius + zone.radius;
  if (dot(gap, gap) >= reach * reach || !p_->zone_concerns(z, i)) return 0;
  const double depth = zone_separation(zone, x_.boxes[i], x_, false).depth;
  return depth > 0 ? p_->gamma(zone) * depth * depth : 0;
}

double LayoutWalk::collisions_of(std::uint32_t body) const {
  if (!p_->collisions) return 0;
  double squares = 0;
  const auto& boxes = p_->data.boxes;
  const BodyData& d = p_->data.bodies[body];
  for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) {
    for (std::uint32_t j = 0; j < boxes.size(); ++j) {
      if (!near(x_.boxes[i], boxes[i].radius, x_.boxes[j], boxes[j].radius) || !p_->collide(i, j)) continue;
      const double depth = separation(x_.boxes[i], x_.boxes[j]).depth;
      if (depth > 0) squares += p_->collision_gamma * depth * depth;
    }
  }
  return squares;
}

double LayoutWalk::zones_of(std::uint32_t body) const {
  double squares = 0;
  const BodyData& d = p_->data.bodies[body];
  for (std::uint32_t z = 0; z < p_->zones.size(); ++z)
    for (std::uint32_t i = d.first_box; i < d.first_box + d.boxes; ++i) squares += zone_square(z, i);
  for (const std::uint32_t z : p_->zones_of_body[body])
    for (std::uint32_t j = 0; j < p_->data.boxes.size(); ++j) squares += zone_square(z, j);
  return squares;
}

double LayoutWalk::squares_of(std::uint32_t body) const {
  double squares = 0;
  for (std::uint32_t k = p_->touching_first[body]; k < p_->touching_first[body + 1]; ++k) {
    p_->with_term(p_->touching[k], [&](const auto& term) {
      const double e = error(term, x_);
      squares += p_->gamma(term) * e * e;
    });
  }
  Score s;
  score_boundary(*p_, x_, body, s, squares);
  return squares + collisions_of(body) + zones_of(body);
}

std::pair<Score, double> LayoutWalk::score_all() const {
  Score s;
  double squares = 0;
  p_->for_each_term([&](const auto& term, TermId) {
    const double e = error(term, x_);
    squares += p_->gamma(term) * e * e;
    s.slack = std::max(s.slack, std::abs(e));
  });
  for (std::uint32_t b = 0; b < p_->data.bodies.size(); ++b) score_boundary(*p_, x_, b, s, squares);
  Contacts contacts(*p_);
  contacts.refresh(x_);
  contacts.score(x_, s, squares);
  s.energy = std::sqrt(squares);
  return {s, squares};
}

double LayoutWalk::propose(core::Rng& rng, double temperature) {
  change_ = 0;
  if (movable_.empty()) return 0;
  moved_ = movable_[rng.index(static_cast<std::uint32_t>(movable_.size()))];
  const std::uint32_t attribute = rng.index(3);
  const double share = hot_ > 0 ? temperature / hot_ : 0, by = core::standard_normal(rng);
  before_ = x_.bodies[moved_];
  const double old_squares = squares_of(moved_);
  const BodyData& d = p_->data.bodies[moved_];
  Vec2 p = before_.p;
  double angle = before_.angle;
  const double shift = std::max(kLeastShift, share * reach_) * by;
  if (attribute == 2 ? !d.turns : d.w <= 0) return 0;
  if (attribute == 0) p.x += shift;
  if (attribute == 1) p.y += shift;
  if (attribute == 2) angle = wrap_angle(angle + std::max(kLeastTurn, share * kPi / 2) * by);
  x_.place(moved_, p, angle);
  change_ = squares_of(moved_) - old_squares;
  return std::sqrt(std::max(0.0, squares_ + change_)) - std::sqrt(squares_);
}

void LayoutWalk::reject() { x_.place(moved_, before_.p, before_.angle, before_.front); }

void LayoutWalk::restore(const Snapshot& bodies) {
  for (std::uint32_t b = 0; b < bodies.size(); ++b) x_.place(b, bodies[b].p, bodies[b].angle, bodies[b].front);
  squares_ = score_all().second;
}

core::Result<Layout> anneal_layout(const Scene& scene, const BaselineOptions& options) {
  const core::Result<Problem> problem = compile(scene);
  if (!problem) return problem.error();
  const double energy = LayoutWalk(*problem, options.seed, 1, 1).cost();
  const double hot = options.hot * energy;
  LayoutWalk walk(*problem, options.seed, hot, options.shift);
  annealing::AnnealOptions anneal_options;
  anneal_options.iterations = options.iterations, anneal_options.patience = options.patience;
  anneal_options.seed = options.seed, anneal_options.cancel = options.cancel;
  anneal_options.schedule = {annealing::Schedule::Shape::linear, hot, 0};
  annealing::Observer<LayoutWalk> observer;
  if (options.trace != nullptr) {
    observer.every = options.trace_every;
    observer.look = [&](std::int64_t i, double, double cost, const LayoutWalk& w) {
      const Score s = w.score();
      options.trace->push_back({1, static_cast<int>(i), cost, s.violation, s.feasible(), false});
    };
  }
  const annealing::AnnealResult result = annealing::anneal(walk, anneal_options, observer);
  const Score s = walk.score();
  Layout layout;
  layout.placement = placement_of(*problem, walk.state());
  layout.feasible = s.feasible(), layout.energy = s.energy, layout.violation = s.violation;
  layout.iterations = static_cast<int>(result.iterations);
  return layout;
}

}  // namespace inhabit::session
