#include "crowd/models/pbd_reference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "crowd/models/pbd_kernels.h"

namespace inhabit::crowd::pbd_model::plainly {
namespace {

struct Vec {
  float x = 0, y = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(float s, Vec a) { return {a.x * s, a.y * s}; }
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
float norm(Vec a) { return std::sqrt(dot(a, a)); }

Vec shortened(Vec a, float longest) {
  const float square = dot(a, a);
  return square > longest * longest ? (longest / std::sqrt(square)) * a : a;
}

Vec at(const FloatArray& pairs, std::size_t i) { return {pairs[2 * i], pairs[2 * i + 1]}; }
void put(Vec a, FloatArray& pairs, std::size_t i) { pairs[2 * i] = a.x, pairs[2 * i + 1] = a.y; }

/// 1 / sqrt(a), as the fast loops find it.
float inverse_root(float a) {
  float y = std::bit_cast<float>(0x5f375a86 - (std::bit_cast<std::int32_t>(a) >> 1));
  for (int round = 0; round < 2; ++round) y = y * (1.5f - 0.5f * a * (y * y));
  return y;
}

float relaxed(const Constants& k, float touches) {
  const float most = std::max(touches, 1.0f);
  return std::min(k.over_relaxation, most) / most;
}

/// (r_i + r_j), grown.
float reach_of(const Work& work, std::size_t i, std::size_t j, float growth) {
  return work.alike() ? 2 * work.common_radius * growth : (work.radius[i] + work.radius[j]) * growth;
}
/// w_i / (w_i + w_j) with w = 1 / m.
float share_of(const Work& work, std::size_t i, std::size_t j) {
  return work.alike() ? 0.5f : work.mass[j] / (work.mass[i] + work.mass[j]);
}

/// n from j to i, and how deep the discs overlap (at most 0: not at all).
struct Contact {
  Vec n;
  float depth = 0;
};
Contact contact(const Work& work, std::size_t i, std::size_t j, const FloatArray& places, float growth) {
  const float reach = reach_of(work, i, j, growth);
  const Vec d = at(places, i) - at(places, j);
  const float d2 = dot(d, d);
  if (i == j || !(d2 < reach * reach)) return {};
  if (d2 < kCoincident) return {{i < j ? -1.0f : 1.0f, 0}, reach - d2};
  const float inverse = inverse_root(d2);
  return {inverse * d, reach - d2 * inverse};
}

/// Calls f(i, its neighbours) for every agent of a chunk.
template <class F>
void for_each_agent(const Work& work, const NeighbourRows& rows, std::size_t chunk, F&& f) {
  std::vector<std::size_t> neighbours;
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t i = chunk * kChunk + b * kLanes + lane;
      neighbours.clear();
      for (std::uint32_t r = rows.first[b]; r < rows.first[b + 1]; ++r)
        neighbours.push_back(static_cast<std::size_t>(rows.items[r * kLanes + lane]));
      f(i, neighbours);
    }
}

Vec blended(const Work& work, const Constants& k, std::size_t i) {
  return (1 - k.blend) * at(work.v, i) + k.blend * at(work.wish, i);
}

/// What is left of the velocity that a contact gives.
Vec damped(const Constants& k, Vec before, Vec after) {
  const Vec change = after - before;
  const float square = std::max(dot(change, change), 1e-12f);
  const float pushed = std::min(std::max(dot(after, change), 0.0f), square);
  return after - ((1 - rebound(k.part)) * pushed / square) * change;
}

/// Calls f(i) for every agent of a chunk's blocks that are busy, or of those that are not.
template <class F>
void for_each_of(const Work& work, std::size_t chunk, bool busy, F&& f) {
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      if ((work.chunks[chunk].busy[b] != 0) == busy) f(chunk * kChunk + b * kLanes + lane);
}

/// What a collision to come asks of agent i, as a displacement; nothing when there is none.
std::optional<Vec> response_to_come(const Work& work, const Constants& k, std::size_t i, std::size_t j) {
  const Vec d = at(work.at, i) - at(work.at, j);
  const float reach = reach_of(work, i, j, k.growth);
  const float c = dot(d, d) - reach * reach;
  const bool against = dot(at(work.wish, i), at(work.wish, j)) < 0;
  const bool apart = c > (against ? kTouching * (reach * reach) : 0);
  const Vec u = apart ? at(work.corrected, i) - at(work.corrected, j) : at(work.wish, i) - at(work.wish, j);
  const float a = dot(u, u), b = -dot(d, u);
  const float under = b * b - a * c;
  if (!(b > 0 && under > 0 && a > 1e-6f)) return {};
  const float tau = std::max((b - std::sqrt(under)) / a, 0.0f);
  if (!(tau < k.far_horizon)) return {};
  const float delay = std::floor(tau * (1 / k.dt));
  const float stiffness = k.stiffness_of_delay[static_cast<std::size_t>(delay)];
  const Vec then = d + ((delay + 1) * k.dt) * u;
  const float square = std::max(dot(then, then), 1e-12f), inverse = inverse_root(square);
  const Vec n = inverse * then;
  const float weight = share_of(work, i, j) * stiffness;
  Vec t = u - dot(u, n) * n;
  const bool head_on = dot(t, t) < 1e-4f * a;
  const float nudge = (apart ? 0.01f : 0.1f) * std::sqrt(a);
  if (k.far != 1 && apart) t = t - (dot(t, u) / a) * u;
  if (head_on) t = {-(n.y * nudge), n.x * nudge};
  if (k.far == 1) {
    const Vec contact = (apart ? std::max(reach - square * inverse, 0.0f) : 0.0f) * n;
    return weight * (contact + k.dt * (head_on || !apart ? t : Vec{}));
  }
  return weight * (k.dt * t);
}

}  // namespace

void find_neighbours(Work& work, const Reach& reach, std::size_t chunk) {
  Chunk& out = work.chunks[chunk];
  out = {};
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    const auto rows_of = [&](NeighbourRows& rows, std::size_t limit, auto&& near) {
      std::array<std::vector<std::int32_t>, kLanes> lists;
      std::size_t most = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t i = chunk * kChunk + b * kLanes + lane;
        std::vector<std::pair<float, std::int32_t>> found;
        for (std::size_t j = 0; j < work.count && i < work.count; ++j) {
          const Vec d = at(work.at, j) - at(work.at, i);
          if (j != i && dot(d, d) < near(i, j)) found.emplace_back(dot(d, d), static_cast<std::int32_t>(j));
        }
        std::ranges::sort(found);
        found.resize(std::min(found.size(), limit));
        for (const auto& [d2, j] : found) lists[lane].push_back(j);
        std::ranges::sort(lists[lane]);
        most = std::max(most, found.size());
      }
      for (std::size_t r = 0; r < most; ++r)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          rows.items.push_back(r < lists[lane].size() ? lists[lane][r]
                                                      : static_cast<std::int32_t>(chunk * kChunk + b * kLanes + lane));
      rows.first[b + 1] = rows.first[b] + static_cast<std::uint32_t>(most);
    };
    out.gap[b] = reach.skin;
    for (std::size_t i = chunk * kChunk + b * kLanes; i < std::min(chunk * kChunk + (b + 1) * kLanes, work.count); ++i)
      for (std::size_t j = 0; j < work.count; ++j)
        if (i != j)
          out.gap[b] =
              std::min(out.gap[b], norm(at(work.at, j) - at(work.at, i)) - reach_of(work, i, j, 1) * reach.growth);
    rows_of(out.contacts, kMostContacts, [&](std::size_t i, std::size_t j) {
      const float grown = work.alike() ? work.common_radius * reach.growth : work.radius[j] * reach.growth;
      const float own = work.alike() ? grown : work.radius[i] * reach.growth;
      const float all = work.alike() ? own + grown + reach.skin : (own + reach.skin) + grown;
      return all * all;
    });
    rows_of(out.far, reach.far ? reach.far_count : 0,
            [&](std::size_t, std::size_t) { return reach.far_range * reach.far_range; });
  }
}

void cohere(Work& work, const Constants& k, std::size_t chunk) {
  for_each_agent(work, work.chunks[chunk].far, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    const Vec v = at(work.v, i);
    const float radius = work.alike() ? work.common_radius : work.radius[i];
    const float range = k.cohesion_range * radius;
    Vec sum;
    float weights = 0;
    for (const std::size_t j : neighbours) {
      const Vec d = at(work.at, j) - at(work.at, i);
      const float rest = std::max(range * range - dot(d, d), 0.0f);
      const float weight = j == i ? 0.0f : rest * rest * rest;
      sum = sum + weight * (at(work.v, j) - v), weights = weights + weight;
    }
    put(v + (k.cohesion / std::max(weights, 1e-12f)) * sum, work.next, i);
  });
}

void intend(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk;
  for (std::size_t i = begin; i < begin + work.blocks_of(chunk) * kLanes; ++i)
    put(blended(work, k, i), work.corrected, i);
}

void foresee(Work& work, const Constants& k, std::size_t chunk) {
  for_each_agent(work, work.chunks[chunk].far, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    Vec sum;
    float pairs = 0;
    for (const std::size_t j : neighbours)
      if (const auto response = response_to_come(work, k, i, j)) sum = sum + *response, pairs += 1;
    const Vec change = shortened((kFarRelaxation / k.dt / std::max(pairs, 1.0f)) * sum, k.velocity_change);
    put(at(work.v, i) + change, work.v, i);
  });
}

void narrow(Work& work, const Constants& k, std::size_t chunk) {
  Chunk& c = work.chunks[chunk];
  c.near = {};
  c.busy_count = 0;
  for (std::size_t b = 0; b < work.blocks_of(chunk); ++b) {
    std::array<std::vector<std::int32_t>, kLanes> lists;
    std::size_t most = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t i = chunk * kChunk + b * kLanes + lane;
      for (std::uint32_t r = c.contacts.first[b]; r < c.contacts.first[b + 1]; ++r) {
        const std::int32_t j = c.contacts.items[r * kLanes + lane];
        const Vec d = at(work.at, i) - at(work.at, static_cast<std::size_t>(j));
        const float reach = reach_of(work, i, static_cast<std::size_t>(j), k.growth) + 2 * k.stride;
        if (i != static_cast<std::size_t>(j) && dot(d, d) < reach * reach) lists[lane].push_back(j);
      }
      most = std::max(most, lists[lane].size());
    }
    for (std::size_t r = 0; r < most; ++r)
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        c.near.items.push_back(r < lists[lane].size() ? lists[lane][r]
                                                      : static_cast<std::int32_t>(chunk * kChunk + b * kLanes + lane));
    c.near.first[b + 1] = static_cast<std::uint32_t>(c.near.items.size() / kLanes);
    c.busy[b] = c.near.first[b + 1] > c.near.first[b] || c.gap[b] < 0;
    c.busy_count += c.busy[b];
  }
}

void glide(Work& work, const Constants& k, std::size_t chunk) {
  for_each_of(work, chunk, false, [&](std::size_t i) {
    Vec moved;
    for (int part = 0; part < k.parts; ++part) {
      const Vec v = shortened(blended(work, k, i), work.maximum_speed[i]);
      put(v, work.v, i);
      moved = moved + k.part * v;
    }
    const Vec to = at(work.at, i) + moved;
    for (FloatArray* places : {&work.at, &work.next, &work.predicted, &work.corrected}) put(to, *places, i);
  });
}

void stabilise(Work& work, const Constants& k, std::size_t chunk) {
  for_each_agent(work, work.chunks[chunk].near, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    if (!work.chunks[chunk].busy[i % kChunk / kLanes]) return;
    Vec sum;
    float touches = 0;
    for (const std::size_t j : neighbours) {
      const Contact c = contact(work, i, j, work.at, 1);
      if (c.depth <= 0) continue;
      sum = sum + (share_of(work, i, j) * c.depth) * c.n, touches += 1;
    }
    put(at(work.at, i) + relaxed(k, touches) * sum, work.corrected, i);
  });
}

void settle(Work& work, const Constants&, std::size_t chunk) {
  float most = 0;
  for_each_of(work, chunk, true, [&](std::size_t i) {
    const Vec way = at(work.corrected, i) - at(work.at, i);
    most = std::max(most, dot(way, way));
    put(at(work.corrected, i), work.at, i);
  });
  work.chunks[chunk].thrown = std::sqrt(most);
}

void predict(Work& work, const Constants& k, std::size_t chunk) {
  for_each_of(work, chunk, true, [&](std::size_t i) {
    put(at(work.at, i), work.base, i), put({}, work.moved, i);
    put(at(work.at, i) + k.part * blended(work, k, i), work.predicted, i);
  });
}

void project(Work& work, const Constants& k, std::size_t chunk) {
  for_each_agent(work, work.chunks[chunk].near, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    if (!work.chunks[chunk].busy[i % kChunk / kLanes]) return;
    Vec sum;
    float touches = 0;
    for (const std::size_t j : neighbours) {
      const Contact c = contact(work, i, j, work.predicted, k.growth);
      if (c.depth <= 0) continue;
      Vec correction = c.depth * c.n;
      if (k.static_friction > 0 || k.kinetic_friction > 0) {
        const Vec u = (at(work.predicted, i) - at(work.predicted, j)) - (at(work.at, i) - at(work.at, j));
        const Vec t = u - dot(u, c.n) * c.n;
        const float square = std::max(dot(t, t), 1e-24f), still = k.static_friction * c.depth;
        const float kinetic = std::min(k.kinetic_friction * c.depth * inverse_root(square), 1.0f);
        correction = correction - (square < still * still ? 1.0f : kinetic) * t;
      }
      sum = sum + share_of(work, i, j) * correction, touches += 1;
    }
    put(at(work.predicted, i) + relaxed(k, touches) * sum, work.corrected, i);
  });
}

void finish(Work& work, const Constants& k, std::size_t chunk) {
  for_each_of(work, chunk, true, [&](std::size_t i) {
    const Vec begun = at(work.at, i) + k.part * blended(work, k, i);
    const Vec correction = at(work.corrected, i) - begun;
    const Vec before = blended(work, k, i);
    const Vec thrown = shortened(before + k.inverse_part * correction, work.maximum_speed[i]);
    put(damped(k, before, thrown), work.v, i);
    put(at(work.moved, i) + k.part * thrown, work.moved, i);
    put(at(work.base, i) + at(work.moved, i), work.next, i);
    put(at(work.next, i) + k.part * blended(work, k, i), work.corrected, i);
  });
}

}  // namespace inhabit::crowd::pbd_model::plainly
