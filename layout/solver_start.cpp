#include <algorithm>

#include "layout/solver.h"

/// Where everything stands before the first projection.
namespace inhabit::layout {

void scatter(const Problem& p, const Options& options, Rng& rng, State& x, std::vector<bool>& given) {
  const Bounds& room = p.room.extent();
  given.assign(p.data.bodies.size(), false);
  for (std::uint32_t b = 0; b < p.data.bodies.size(); ++b) {
    const BodyData& d = p.data.bodies[b];
    given[b] = p.has_start[b] && (d.w == 0 || options.start == Start::given);
    Pose pose = p.start[b];
    if (!given[b]) {
      for (int i = 0; i < 32; ++i) {
        pose.p = {rng.uniform(room.min.x, room.max.x), rng.uniform(room.min.y, room.max.y)};
        if (p.room.contains(pose.p)) break;
      }
    }
    if (d.turns && !(options.start == Start::given && p.has_angle[b])) pose.angle = rng.uniform(-kPi, kPi);
    x.place(b, pose.p, pose.angle);
  }
}

void Solver::begin() {
  const std::size_t n = p_.data.bodies.size();
  std::vector<bool> placed;
  scatter(p_, options_, rng_, x_, placed);
  std::vector<std::uint32_t> unplaced;
  for (std::uint32_t b = 0; b < n; ++b)
    if (!placed[b]) unplaced.push_back(b);
  if (unplaced.empty()) {
    settles_ = true;
    schedule_ = 20;  // warm: soft constraints correct, they do not rearrange
    return;
  }
  if (options_.start == Start::random) return;
  begin_curves(placed);
  std::erase_if(unplaced, [&](std::uint32_t b) { return placed[b]; });
  // Large before small, with some chance, so that starts differ. In a large scene equals go in the order of the
  // document: members of one tier are neighbours in the room and so in memory.
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const std::uint32_t b : unplaced) {
    const double area = p_.data.bodies[b].area;
    order.emplace_back(-area * (n > kMany ? 1 : rng_.uniform(0.7, 1.3)), b);
  }
  std::ranges::sort(order);
  placer_->reset(placed);
  const int tries = n > kMany ? 16 : 32;
  for (const auto& [key, b] : order) placer_->place(b, rng_, tries);
}

/// Members of a curve start evenly along it.
void Solver::begin_curves(std::vector<bool>& placed) {
  for (const CurveTerm& c : p_.of<CurveTerm>()) {
    if (c.curve.medial_axis) continue;
    const double total = detail::curve_length(c.curve), n = static_cast<double>(c.members.size());
    const double step = c.spacing && *c.spacing * (n - 1) <= total ? *c.spacing : (n > 1 ? total / (n - 1) : 0);
    double at = (total - step * (n - 1)) / 2;
    for (const Anchor& m : c.members) {
      if (!m.group() && !placed[m.body] && x_.w(m) > 0) {
        x_.place(m.body, detail::curve_point(c.curve, at), x_.bodies[m.body].angle);
        placed[m.body] = true;
      }
      at += step;
    }
  }
}

}  // namespace inhabit::layout
