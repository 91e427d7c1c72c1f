#include "crowd/models/pbd.h"

#include <cmath>

#include "core/parallel.h"
#include "crowd/grid.h"
#include "crowd/models/pbd_heed.h"
#include "crowd/models/pbd_kernels.h"
#include "crowd/models/pbd_lists.h"

namespace inhabit::crowd {
using namespace pbd_model;
namespace {

/// Neighbours are found with a skin that lasts about so many steps at the fastest wish.
constexpr float kStepsPerSearch = 10;
/// The thesis corrects for collisions to come in each of its six iterations; here once, with what those add up to.
constexpr double kFarPasses = 6;
/// Pushed apart by less than this, nobody comes nearer to others than the margin of contacts allows for, metres.
constexpr float kThrow = 1e-3f;
/// Pushed apart by more than this share of the smallest radius, people need shorter sub-steps; after so many steps
/// without that, longer ones are tried.
constexpr float kDeep = 1e-3f;
constexpr int kCalmSteps = 12;
/// Fewer agents than this are one thread's work: starting others takes longer.
constexpr std::size_t kSerial = 2048;

/// Room for whole blocks and for what vectors read beyond the last one.
std::size_t padded(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes + kLanes; }

}  // namespace

namespace {

/// Of a crowd's attributes.
struct Extremes {
  float thinnest = 1e30f, widest = 0, lightest = 1e30f, heaviest = 0, wish = 0, fastest = 0;
  float radii = 0;  ///< their sum

  bool alike() const { return thinnest == widest && lightest == heaviest; }
  void add(const Extremes& other) {
    thinnest = std::min(thinnest, other.thinnest), widest = std::max(widest, other.widest);
    lightest = std::min(lightest, other.lightest), heaviest = std::max(heaviest, other.heaviest);
    wish = std::max(wish, other.wish), fastest = std::max(fastest, other.fastest);
    radii += other.radii;
  }
};

}  // namespace

struct Pbd::State {
  Parameters parameters;
  Work work;
  Constants constants;
  Grid grid;
  FloatArray built;  ///< where everybody was when neighbours were found: pairs
  std::vector<float> stiffness;
  std::vector<std::size_t> busy;  ///< chunks in which somebody may touch somebody in this step
  /// Per chunk, of the agents that came in: the largest square of a way since neighbours were found, or less than 0
  /// when somebody is not where the last step left him; and the fastest that anybody can be.
  std::vector<float> strayed, speeds;
  float thinnest = 0;  ///< radius, metres
  std::size_t rebuilds = 0;
  int threads = 0;
  int calm = 0;  ///< steps without deep overlaps since the number of sub-steps changed
  HeedWork heeding;
  std::vector<float> asked_x, asked_y;  ///< wishes as the planner wrote them
  std::size_t steps = 0;

  template <class F>
  void for_each_chunk(F&& f) {
    core::parallel_for(work.chunks.size(), work.count < kSerial ? 1 : threads, [&](std::size_t c) { f(c); });
  }

  /// Calls f(index of the first agent, of the one after the last) for every chunk's agents.
  template <class F>
  void for_each_part(F&& f) {
    for_each_chunk([&](std::size_t c) { f(c, c * kChunk, std::min((c + 1) * kChunk, work.count)); });
  }
  /// Calls f(chunk) for those in which somebody may touch somebody.
  template <class F>
  void for_each_busy(F&& f) {
    core::parallel_for(busy.size(), work.count < kSerial ? 1 : threads, [&](std::size_t k) { f(busy[k]); });
  }

  void set_constants(float dt);
  void set_parts(int parts);
  void choose_parts(float thrown);
  bool fresh(const Agents& agents);
  Extremes extremes(const Agents& agents);
  void search(Agents& agents, const Walls& walls);
  void take(const Agents& agents);
  void give(Agents& agents);
  void hold_walls(const Walls& walls, FloatArray& places, std::size_t chunk) const;
  void part_overlaps(const Walls& walls);
  void contend(const Walls& walls);
  void heed_others(Agents& agents, const Walls& walls);
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
  set_parts(p.sub_steps);
  k.growth = static_cast<float>(1 + p.contact_margin);
  k.over_relaxation = static_cast<float>(p.over_relaxation);
  k.static_friction = static_cast<float>(p.static_friction);
  k.kinetic_friction = static_cast<float>(p.kinetic_friction);
  k.velocity_change = static_cast<float>(p.maximum_acceleration) * dt;
  k.far = p.far;
  k.cohesion = static_cast<float>(p.cohesion), k.cohesion_range = static_cast<float>(p.cohesion_range);
  k.far_horizon = static_cast<float>(p.far_horizon);
  const double whole = 1 - std::pow(1 - p.far_stiffness, kFarPasses);
  stiffness.clear();
  for (double delay = 0; delay <= p.far_horizon + 2 * dt; delay += dt)
    stiffness.push_back(
        static_cast<float>(std::round(whole * std::exp(-delay * delay / p.far_horizon) * 0x1p24) * 0x1p-24));
  k.stiffness_of_delay = stiffness.data();
}

void Pbd::State::set_parts(int parts) {
  Constants& k = constants;
  k.parts = parts;
  k.part = k.dt / static_cast<float>(parts);
  k.inverse_part = 1 / k.part;
  // What is left of a difference to the wish after a step does not depend on the number of its parts.
  const double shortest = static_cast<double>(k.dt) / parameters.sub_steps;
  const double left = std::max(0.0, 1 - shortest / parameters.relaxation_time);
  const double kept = std::pow(left, static_cast<double>(parameters.sub_steps) / parts);
  k.blend = static_cast<float>(1 - std::round(kept * 0x1p24) * 0x1p-24);
  calm = 0;
}

/// As few sub-steps as keep people apart.
void Pbd::State::choose_parts(float thrown) {
  const int parts = constants.parts, fewest = std::min(parameters.fewest_sub_steps, parameters.sub_steps);
  if (thrown > kDeep * thinnest) {
    calm = 0;
    if (parts < parameters.sub_steps) set_parts(std::min(2 * parts, parameters.sub_steps));
  } else if (++calm >= kCalmSteps && parts > fewest) {
    set_parts(std::max(parts / 2, fewest));
  }
}

/// Whether the neighbours found last will do for this step too.
bool Pbd::State::fresh(const Agents& agents) {
  if (agents.size() != work.count || work.count == 0) return false;
  strayed.assign(work.chunks.size(), 0), speeds.assign(work.chunks.size(), 0);
  for_each_part([&](std::size_t c, std::size_t begin, std::size_t end) {
    float farthest = 0, fastest = 0;
    bool same = true;
    for (std::size_t i = begin; i < end; ++i) {
      const float x = agents.x[i], y = agents.y[i];
      same = same && x == work.at[2 * i] && y == work.at[2 * i + 1];
      const float dx = x - built[2 * i], dy = y - built[2 * i + 1];
      farthest = std::max(farthest, dx * dx + dy * dy);
      fastest = std::max(fastest, agents.maximum_speed[i]);
    }
    strayed[c] = same ? farthest : -1, speeds[c] = fastest;
  });
  if (std::ranges::min(strayed) < 0) return false;
  constants.moved = std::sqrt(std::ranges::max(strayed));
  constants.stride = std::ranges::max(speeds) * constants.dt;
  return 2 * (constants.moved + constants.stride) <= constants.skin;
}

void Pbd::State::take(const Agents& agents) {
  for_each_part([&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      work.at[2 * i] = agents.x[i], work.at[2 * i + 1] = agents.y[i];
      work.v[2 * i] = agents.vx[i], work.v[2 * i + 1] = agents.vy[i];
      work.wish[2 * i] = agents.wish_x[i], work.wish[2 * i + 1] = agents.wish_y[i];
      work.maximum_speed[i] = agents.maximum_speed[i];
    }
    if (work.alike()) return;
    for (std::size_t i = begin; i < end; ++i) work.radius[i] = agents.radius[i], work.mass[i] = agents.mass[i];
  });
}

void Pbd::State::give(Agents& agents) {
  for_each_part([&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      agents.x[i] = work.at[2 * i], agents.y[i] = work.at[2 * i + 1];
      agents.vx[i] = work.v[2 * i], agents.vy[i] = work.v[2 * i + 1];
    }
  });
}

Extremes Pbd::State::extremes(const Agents& agents) {
  const std::size_t n = agents.size();
  std::vector<Extremes> parts((n + kSerial - 1) / kSerial);
  core::parallel_for(parts.size(), threads, [&](std::size_t k) {
    Extremes part;
    for (std::size_t i = k * kSerial; i < std::min((k + 1) * kSerial, n); ++i)
      part.add({agents.radius[i], agents.radius[i], agents.mass[i], agents.mass[i], agents.preferred_speed[i],
                agents.maximum_speed[i], agents.radius[i]});
    parts[k] = part;
  });
  Extremes all;
  for (const Extremes& part : parts) all.add(part);
  return all;
}

void Pbd::State::search(Agents& agents, const Walls& walls) {
  const std::size_t n = agents.size();
  ++rebuilds;
  const Extremes all = extremes(agents);
  // Lasts for some steps of the fastest walker after the first, in which anybody may move at full speed.
  constants.skin = 2 * constants.dt * (all.fastest + (kStepsPerSearch - 1) * all.wish);

  Reach reach;
  reach.growth = constants.growth, reach.skin = constants.skin;
  reach.far = parameters.far != 0 || parameters.headway > 0 || parameters.cohesion > 0;
  reach.far_range = static_cast<float>(parameters.far_range);
  reach.far_count = static_cast<std::uint32_t>(parameters.far_neighbours);
  grid.build(agents.x, agents.y, 2 * all.radii / static_cast<float>(n) * constants.growth + constants.skin, threads);
  agents.permute(grid.order(), threads);

  work.count = n;
  for (FloatArray* pairs :
       {&work.at, &work.next, &work.base, &work.moved, &work.predicted, &work.corrected, &work.v, &work.wish})
    pairs->resize(2 * padded(n));
  work.maximum_speed.resize(padded(n));
  work.radius.assign(all.alike() ? 0 : padded(n), 0), work.mass.assign(all.alike() ? 0 : padded(n), 1);
  work.common_radius = all.widest, thinnest = all.thinnest;
  work.chunks.resize((work.blocks() + kBlocksPerChunk - 1) / kBlocksPerChunk);
  take(agents);
  built = work.at;
  constants.moved = 0, constants.stride = all.fastest * constants.dt;
  for_each_chunk([&](std::size_t c) {
    find_neighbours(work, grid, reach, c);
    find_walls(work, walls, reach, c);
  });
}

void Pbd::State::hold_walls(const Walls& walls, FloatArray& places, std::size_t chunk) const {
  // Twice, for corners: the second wall may push into the first.
  for (int round = 0; round < 2; ++round)
    for (const NearWall& near : work.chunks[chunk].walls) {
      const WallSegment& s = walls.segments()[near.segment];
      const std::size_t i = near.agent;
      const float radius = work.alike() ? work.common_radius : work.radius[i];
      float &x = places[2 * i], &y = places[2 * i + 1];
      const WallPoint p = nearest_point(s, x, y);
      const float dx = x - p.x, dy = y - p.y;
      const float d2 = dx * dx + dy * dy;
      const float ex = s.bx - s.ax, ey = s.by - s.ay;
      // Beyond its ends a wall has no behind: whoever walks round a pillar's corner crosses the line of a side.
      const float at = ex * (x - s.ax) + ey * (y - s.ay);
      const bool beside = at >= 0 && at <= ex * ex + ey * ey;
      const bool behind = beside && ex * (y - s.ay) - ey * (x - s.ax) < 0;
      if (!behind && d2 >= radius * radius) continue;
      const float distance = std::sqrt(d2), length = std::sqrt(ex * ex + ey * ey);
      // From behind, or on the wall itself: along the wall's normal, which points to the floor.
      const bool along = behind || distance < 1e-6f;
      if (along && length == 0) continue;
      const float nx = along ? -ey / length : dx / distance, ny = along ? ex / length : dy / distance;
      x = p.x + radius * nx, y = p.y + radius * ny;
    }
}

/// Who may touch somebody before the step is over; what overlaps already is pushed apart.
void Pbd::State::part_overlaps(const Walls& walls) {
  const auto look = [&] {
    for_each_chunk([&](std::size_t c) { narrow(work, constants, c); });
    busy.clear();
    for (std::size_t c = 0; c < work.chunks.size(); ++c)
      if (work.chunks[c].busy_count > 0) busy.push_back(c);
  };
  look();
  float thrown = 0;
  for (int round = 0; round < parameters.stability_iterations; ++round) {
    for_each_busy([&](std::size_t c) {
      stabilise(work, constants, c);
      hold_walls(walls, work.corrected, c);
    });
    for_each_busy([&](std::size_t c) { settle(work, constants, c); });
    float most = 0;
    for (const std::size_t c : busy) most = std::max(most, work.chunks[c].thrown);
    if (round == 0) choose_parts(most);
    thrown += most;
  }
  // Whoever was thrown may be near others now.
  if (thrown < kThrow) return;
  constants.moved += thrown;
  look();
}

/// The sub-steps of those who may touch somebody.
void Pbd::State::contend(const Walls& walls) {
  for_each_busy([&](std::size_t c) { predict(work, constants, c); });
  for (int part = 0; part < constants.parts; ++part) {
    for (int round = 1; round <= parameters.iterations; ++round) {
      for_each_busy([&](std::size_t c) {
        project(work, constants, c);
        hold_walls(walls, work.corrected, c);
        if (round < parameters.iterations) return;
        finish(work, constants, c);
        hold_walls(walls, work.next, c);
        for (const NearWall& near : work.chunks[c].walls)
          for (const std::size_t k : {2 * near.agent, 2 * near.agent + 1}) work.moved[k] = work.next[k] - work.base[k];
      });
      work.predicted.swap(work.corrected);
    }
    work.at.swap(work.next);
  }
}

void Pbd::State::advance(const Walls& walls) {
  if (constants.far != 0) {
    for_each_chunk([&](std::size_t c) { intend(work, constants, c); });
    for_each_chunk([&](std::size_t c) { foresee(work, constants, c); });
  }
  part_overlaps(walls);
  for_each_chunk([&](std::size_t c) { glide(work, constants, c); });
  contend(walls);
  if (constants.cohesion > 0) {
    for_each_chunk([&](std::size_t c) { cohere(work, constants, c); });
    work.v.swap(work.next);
  }
}

/// Takes wishes shortened and turned for those ahead; the agents keep their own. Requires: neighbours of this step.
void Pbd::State::heed_others(Agents& agents, const Walls& walls) {
  const HeedConstants k = heed_constants(parameters);
  const double time = static_cast<double>(steps) * constants.dt;
  pbd_model::take(heeding, agents);
  for_each_chunk([&](std::size_t c) {
    if (k.turns > 0) find_room(heeding, walls, work.chunks[c].walls);
    heed(heeding, k, work.chunks[c].far, c);
    if (parameters.hesitation > 0) hesitate(heeding, agents, parameters.hesitation, time, c);
  });
  asked_x = agents.wish_x, asked_y = agents.wish_y;
  std::copy_n(heeding.wish_x.begin(), agents.size(), agents.wish_x.begin());
  std::copy_n(heeding.wish_y.begin(), agents.size(), agents.wish_y.begin());
  take(agents);
  agents.wish_x.swap(asked_x), agents.wish_y.swap(asked_y);
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
  if (s.parameters.headway > 0) s.heed_others(agents, around.walls);
  s.advance(around.walls);
  ++s.steps;
  s.give(agents);
}

std::size_t Pbd::bytes() const {
  const State& s = *state_;
  std::size_t total = 0;
  for (const FloatArray* array :
       {&s.work.at, &s.work.next, &s.work.base, &s.work.moved, &s.work.predicted, &s.work.corrected, &s.work.v,
        &s.work.wish, &s.work.maximum_speed, &s.work.radius, &s.work.mass, &s.built})
    total += array->capacity() * sizeof(float);
  for (const Chunk& chunk : s.work.chunks) {
    total += sizeof(Chunk) + chunk.walls.capacity() * sizeof(NearWall);
    for (const NeighbourRows* rows : {&chunk.contacts, &chunk.far, &chunk.near})
      total += rows->items.capacity() * sizeof(std::int32_t);
  }
  return total;
}

Effort Pbd::effort() const {
  const State& s = *state_;
  const Parameters& p = s.parameters;
  double contacts = 0, far = 0, near = 0, busy = 0;  // entries of lists, agents
  for (const Chunk& chunk : s.work.chunks) {
    contacts += static_cast<double>(chunk.contacts.items.size()), far += static_cast<double>(chunk.far.items.size());
    near += static_cast<double>(chunk.near.items.size()), busy += static_cast<double>(chunk.busy_count * kLanes);
  }
  const double all = static_cast<double>(s.work.count);
  // Of crowd/models/pbd_kernels.cpp, per entry and per agent: operations; and bytes: 4 for an index, 8 for a pair.
  struct Loop {
    double times, entries, flops_each, bytes_each, agents, flops, bytes;
  };
  const int parts = s.constants.parts;
  const double passes = parts * p.iterations;
  const Loop loops[] = {
      {s.constants.far != 0 ? 1.0 : 0.0, 0, 0, 0, all, 6, 24},       // intend
      {s.constants.far != 0 ? 1.0 : 0.0, far, 56, 20, all, 12, 24},  // foresee
      {1, contacts, 8, 12, all, 0, 8},                               // narrow
      {1, 0, 0, 0, all - busy, 15.0 * parts, 60},                    // glide
      {static_cast<double>(p.stability_iterations), near, 24, 12, busy, 10, 40},
      {1, 0, 0, 0, busy, 10, 48},                           // predict
      {passes, near, 42, 20, busy, 8, 24},                  // project
      {static_cast<double>(parts), 0, 0, 0, busy, 38, 92},  // finish
  };
  Effort effort;
  for (const Loop& loop : loops) {
    effort.flops += loop.times * (loop.entries * loop.flops_each + loop.agents * loop.flops);
    effort.bytes += loop.times * (loop.entries * loop.bytes_each + loop.agents * loop.bytes);
  }
  return effort;
}

std::size_t Pbd::rebuilds() const { return state_->rebuilds; }

}  // namespace inhabit::crowd
