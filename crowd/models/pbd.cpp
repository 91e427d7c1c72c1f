#include "crowd/models/pbd.h"

#include <cmath>

#include "core/parallel.h"
#include "crowd/grid.h"
#include "crowd/models/pbd_kernels.h"
#include "crowd/models/pbd_lists.h"

namespace inhabit::crowd {
using namespace pbd_model;
namespace {

/// Neighbours are found with a skin that lasts about so many steps at the fastest wish.
constexpr float kStepsPerSearch = 5;
/// The thesis corrects for collisions to come in each of its six iterations; here once, with what those add up to.
constexpr double kFarPasses = 6;
/// Fewer agents than this are one thread's work: starting others takes longer.
constexpr std::size_t kSerial = 2048;

void resize_padded(FloatArray& array, std::size_t count) {
  array.assign((count + kLanes - 1) / kLanes * kLanes + kLanes, 0.0f);
}

}  // namespace

struct Pbd::State {
  Parameters parameters;
  Work work;
  Constants constants;
  Grid grid;
  FloatArray built_x, built_y;  ///< where everybody was when neighbours were found
  std::vector<float> stiffness;
  std::size_t rebuilds = 0;
  int threads = 0;

  template <class F>
  void for_each_chunk(F&& f) {
    core::parallel_for(work.chunks.size(), work.count < kSerial ? 1 : threads, [&](std::size_t c) { f(c); });
  }

  void set_constants(float dt);
  bool fresh(const Agents& agents) const;
  void search(Agents& agents, const Walls& walls);
  void take(const Agents& agents);
  void give(Agents& agents) const;
  void hold_walls(const Walls& walls, FloatArray& x, FloatArray& y, std::size_t chunk) const;
  void advance(const Walls& walls);
};

Pbd::Pbd(const Parameters& parameters) : state_(std::make_unique<State>()) { state_->parameters = parameters; }
Pbd::Pbd(Pbd&&) noexcept = default;
Pbd& Pbd::operator=(Pbd&&) noexcept = default;
Pbd::~Pbd() = default;

void Pbd::State::set_constants(float dt) {
  Constants& k = constants;
  if (k.dt == dt) return;
  const Parameters& p = parameters;
  k.dt = dt;
  k.part = dt / static_cast<float>(p.sub_steps);
  k.inverse_part = 1 / k.part;
  k.blend = std::min(1.0f, k.part / static_cast<float>(p.relaxation_time));
  k.growth = static_cast<float>(1 + p.contact_margin);
  k.over_relaxation = static_cast<float>(p.over_relaxation);
  k.static_friction = static_cast<float>(p.static_friction),
  k.kinetic_friction = static_cast<float>(p.kinetic_friction);
  k.velocity_change = static_cast<float>(p.maximum_acceleration) * dt;
  k.far = p.far;
  k.headway = static_cast<float>(p.headway);
  k.cohesion = static_cast<float>(p.cohesion), k.cohesion_range = static_cast<float>(p.cohesion_range);
  k.far_horizon = static_cast<float>(p.far_horizon);
  const double whole = 1 - std::pow(1 - p.far_stiffness, kFarPasses);
  stiffness.clear();
  for (double delay = 0; delay <= p.far_horizon + 2 * dt; delay += dt)
    stiffness.push_back(
        static_cast<float>(std::round(whole * std::exp(-delay * delay / p.far_horizon) * 0x1p24) * 0x1p-24));
  k.stiffness_of_delay = stiffness.data();
}

bool Pbd::State::fresh(const Agents& agents) const {
  if (agents.size() != work.count || work.count == 0) return false;
  float farthest = 0, fastest = 0;
  for (std::size_t i = 0; i < work.count; ++i) {
    if (agents.x[i] != work.x[i] || agents.y[i] != work.y[i]) return false;
    const float dx = work.x[i] - built_x[i], dy = work.y[i] - built_y[i];
    farthest = std::max(farthest, dx * dx + dy * dy);
    fastest = std::max(fastest, agents.maximum_speed[i]);
  }
  return 2 * (std::sqrt(farthest) + fastest * constants.dt) <= constants.skin;
}

void Pbd::State::take(const Agents& agents) {
  const std::size_t n = agents.size();
  std::copy(agents.x.begin(), agents.x.end(), work.x.begin());
  std::copy(agents.y.begin(), agents.y.end(), work.y.begin());
  std::copy(agents.vx.begin(), agents.vx.end(), work.vx.begin());
  std::copy(agents.vy.begin(), agents.vy.end(), work.vy.begin());
  std::copy(agents.wish_x.begin(), agents.wish_x.end(), work.wish_x.begin());
  std::copy(agents.wish_y.begin(), agents.wish_y.end(), work.wish_y.begin());
  std::copy(agents.maximum_speed.begin(), agents.maximum_speed.end(), work.maximum_speed.begin());
  if (!work.alike()) {
    std::copy(agents.radius.begin(), agents.radius.end(), work.radius.begin());
    std::copy(agents.mass.begin(), agents.mass.end(), work.mass.begin());
    for (std::size_t i = n; i < work.mass.size(); ++i) work.mass[i] = 1;
  }
}

void Pbd::State::give(Agents& agents) const {
  const std::size_t n = agents.size();
  std::copy_n(work.x.begin(), n, agents.x.begin());
  std::copy_n(work.y.begin(), n, agents.y.begin());
  std::copy_n(work.vx.begin(), n, agents.vx.begin());
  std::copy_n(work.vy.begin(), n, agents.vy.begin());
}

void Pbd::State::search(Agents& agents, const Walls& walls) {
  const std::size_t n = agents.size();
  ++rebuilds;
  const auto [thin, wide] = std::ranges::minmax_element(agents.radius);
  const auto [light, heavy] = std::ranges::minmax_element(agents.mass);
  const bool alike = *thin == *wide && *light == *heavy;
  const float widest = *wide;
  float wish = 0, total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    wish = std::max(wish, agents.preferred_speed[i]);
    total += agents.radius[i];
  }
  const float fastest = *std::ranges::max_element(agents.maximum_speed);
  // Lasts for some steps of the fastest walker after the first, in which anybody may move at full speed.
  constants.skin = 2 * constants.dt * (fastest + (kStepsPerSearch - 1) * wish);

  Reach reach;
  reach.growth = constants.growth, reach.skin = constants.skin;
  reach.far = parameters.far != 0 || parameters.headway > 0 || parameters.cohesion > 0;
  reach.far_range = static_cast<float>(parameters.far_range);
  reach.far_count = static_cast<std::uint32_t>(parameters.far_neighbours);
  grid.build(agents.x, agents.y, 2 * total / static_cast<float>(n) * constants.growth + constants.skin, threads);
  agents.permute(grid.order());

  work.count = n;
  for (FloatArray* array : {&work.x, &work.y, &work.next_x, &work.next_y, &work.base_x, &work.base_y, &work.moved_x,
                            &work.moved_y, &work.predicted_x, &work.predicted_y, &work.corrected_x, &work.corrected_y,
                            &work.vx, &work.vy, &work.wish_x, &work.wish_y, &work.maximum_speed})
    resize_padded(*array, n);
  work.radius.clear(), work.mass.clear();
  if (!alike) resize_padded(work.radius, n), resize_padded(work.mass, n);
  work.common_radius = widest;
  work.chunks.resize((work.blocks() + kBlocksPerChunk - 1) / kBlocksPerChunk);
  take(agents);
  built_x = work.x, built_y = work.y;
  for_each_chunk([&](std::size_t c) {
    find_neighbours(work, grid, reach, c);
    find_walls(work, walls, reach, c);
  });
}

void Pbd::State::hold_walls(const Walls& walls, FloatArray& x, FloatArray& y, std::size_t chunk) const {
  // Twice, for corners: the second wall may push into the first.
  for (int round = 0; round < 2; ++round)
    for (const NearWall& near : work.chunks[chunk].walls) {
      const WallSegment& s = walls.segments()[near.segment];
      const std::size_t i = near.agent;
      const float radius = work.alike() ? work.common_radius : work.radius[i];
      const WallPoint p = nearest_point(s, x[i], y[i]);
      const float dx = x[i] - p.x, dy = y[i] - p.y;
      const float d2 = dx * dx + dy * dy;
      const float ex = s.bx - s.ax, ey = s.by - s.ay;
      // Past its ends a wall has no behind: whoever goes round a jamb crosses the line that it lies on.
      const float t = ex * (x[i] - s.ax) + ey * (y[i] - s.ay);
      const bool beside = t > 0 && t < ex * ex + ey * ey;
      const bool behind = beside && ex * (y[i] - s.ay) - ey * (x[i] - s.ax) < 0;
      if (!behind && d2 >= radius * radius) continue;
      const float distance = std::sqrt(d2), length = std::sqrt(ex * ex + ey * ey);
      // From behind, or on the wall itself: along the wall's normal, which points to the floor.
      const bool along = behind || distance < 1e-6f;
      if (along && length == 0) continue;
      const float nx = along ? -ey / length : dx / distance, ny = along ? ex / length : dy / distance;
      x[i] = p.x + radius * nx, y[i] = p.y + radius * ny;
    }
}

void Pbd::State::advance(const Walls& walls) {
  if (constants.headway > 0) for_each_chunk([&](std::size_t c) { heed(work, constants, c); });
  if (constants.far != 0) {
    for_each_chunk([&](std::size_t c) { foresee(work, constants, c, work.next_x.data(), work.next_y.data()); });
    work.vx.swap(work.next_x), work.vy.swap(work.next_y);
  }
  for (int round = 0; round < parameters.stability_iterations; ++round) {
    for_each_chunk([&](std::size_t c) {
      stabilise(work, constants, c, work.next_x.data(), work.next_y.data());
      hold_walls(walls, work.next_x, work.next_y, c);
    });
    work.x.swap(work.next_x), work.y.swap(work.next_y);
  }
  for_each_chunk([&](std::size_t c) { predict(work, constants, c); });
  for (int part = 0; part < parameters.sub_steps; ++part) {
    for (int round = 1; round < parameters.iterations; ++round) {
      for_each_chunk([&](std::size_t c) {
        project(work, constants, c, work.corrected_x.data(), work.corrected_y.data());
        hold_walls(walls, work.corrected_x, work.corrected_y, c);
      });
      work.predicted_x.swap(work.corrected_x), work.predicted_y.swap(work.corrected_y);
    }
    for_each_chunk([&](std::size_t c) {
      project(work, constants, c, work.corrected_x.data(), work.corrected_y.data());
      hold_walls(walls, work.corrected_x, work.corrected_y, c);
    });
    for_each_chunk([&](std::size_t c) {
      finish(work, constants, c);
      hold_walls(walls, work.next_x, work.next_y, c);
      for (const NearWall& near : work.chunks[c].walls) {
        work.moved_x[near.agent] = work.next_x[near.agent] - work.base_x[near.agent];
        work.moved_y[near.agent] = work.next_y[near.agent] - work.base_y[near.agent];
      }
    });
    work.x.swap(work.next_x), work.y.swap(work.next_y);
  }
  if (constants.cohesion > 0) {
    for_each_chunk([&](std::size_t c) { cohere(work, constants, c, work.next_x.data(), work.next_y.data()); });
    work.vx.swap(work.next_x), work.vy.swap(work.next_y);
  }
}

void Pbd::step(Agents& agents, const Surroundings& around) {
  State& s = *state_;
  if (agents.empty()) return;
  s.threads = around.threads;
  s.set_constants(around.dt);
  if (s.fresh(agents))
    s.take(agents);
  else
    s.search(agents, around.walls);
  s.advance(around.walls);
  s.give(agents);
}

std::size_t Pbd::bytes() const {
  const State& s = *state_;
  std::size_t total = 0;
  for (const FloatArray* array : {&s.work.x,
                                  &s.work.y,
                                  &s.work.next_x,
                                  &s.work.next_y,
                                  &s.work.base_x,
                                  &s.work.base_y,
                                  &s.work.moved_x,
                                  &s.work.moved_y,
                                  &s.work.predicted_x,
                                  &s.work.predicted_y,
                                  &s.work.corrected_x,
                                  &s.work.corrected_y,
                                  &s.work.vx,
                                  &s.work.vy,
                                  &s.work.wish_x,
                                  &s.work.wish_y,
                                  &s.work.maximum_speed,
                                  &s.work.radius,
                                  &s.work.mass,
                                  &s.built_x,
                                  &s.built_y})
    total += array->capacity() * sizeof(float);
  for (const Chunk& chunk : s.work.chunks)
    total += sizeof(Chunk) + (chunk.contacts.items.capacity() + chunk.far.items.capacity()) * sizeof(std::int32_t) +
             chunk.walls.capacity() * sizeof(NearWall);
  return total;
}

std::size_t Pbd::rebuilds() const { return state_->rebuilds; }

}  // namespace inhabit::crowd
