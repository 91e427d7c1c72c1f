#include "crowd/models/pbd_reference.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
  const float length = norm(a);
  return (length > longest ? longest / std::max(length, 1e-12f) : 1.0f) * a;
}

Vec at(const FloatArray& x, const FloatArray& y, std::size_t i) { return {x[i], y[i]}; }

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
Contact contact(const Work& work, std::size_t i, std::size_t j, Vec xi, Vec xj, float growth) {
  const float reach = reach_of(work, i, j, growth);
  const Vec d = xi - xj;
  const float d2 = dot(d, d);
  if (i == j || !(d2 < reach * reach)) return {};
  const float distance = std::sqrt(d2);
  if (d2 == 0) return {{i < j ? -1.0f : 1.0f, 0}, reach};
  return {(1 / distance) * d, reach - distance};
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
  return (1 - k.blend) * at(work.vx, work.vy, i) + k.blend * at(work.wish_x, work.wish_y, i);
}

/// What a collision to come asks of agent i, as a displacement; nothing when there is none.
std::optional<Vec> response_to_come(const Work& work, const Constants& k, std::size_t i, std::size_t j) {
  const Vec d = at(work.x, work.y, i) - at(work.x, work.y, j);
  const Vec u = blended(work, k, i) - blended(work, k, j);
  const float reach = reach_of(work, i, j, k.growth);
  const float a = dot(u, u), b = -dot(d, u), c = dot(d, d) - reach * reach;
  const float under = b * b - a * c;
  if (!(c > 0 && b > 0 && under > 0 && a > 1e-6f)) return {};
  const float tau = (b - std::sqrt(under)) / a;
  if (!(tau < k.far_horizon)) return {};
  const float delay = std::floor(tau / k.dt);
  const float stiffness = k.stiffness_of_delay[static_cast<std::size_t>(delay)];
  const Vec then = d + ((delay + 1) * k.dt) * u;
  const float distance = norm(then);
  const Vec n = (1 / std::max(distance, 1e-6f)) * then;
  const float weight = share_of(work, i, j) * stiffness;
  Vec t = u - dot(u, n) * n;
  const bool head_on = dot(t, t) < 1e-4f * a;
  const float nudge = 0.01f * std::sqrt(a);
  if (head_on) t = {-(n.y * nudge), n.x * nudge};
  if (k.far == 1) {
    const Vec contact = std::max(reach - distance, 0.0f) * n;
    return weight * (contact + k.dt * (head_on ? t : Vec{}));
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
          const Vec d = at(work.x, work.y, j) - at(work.x, work.y, i);
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

void heed(Work& work, const Constants& k, std::size_t chunk) {
  for_each_agent(work, work.chunks[chunk].far, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    const Vec wish = at(work.wish_x, work.wish_y, i);
    const float speed = norm(wish);
    const Vec e = (1 / std::max(speed, 1e-12f)) * wish;
    float allowed = speed;
    for (const std::size_t j : neighbours) {
      const Vec d = at(work.x, work.y, j) - at(work.x, work.y, i);
      const float along = dot(d, e), across = d.y * e.x - d.x * e.y, reach = reach_of(work, i, j, 1);
      const float under = reach * reach - across * across;
      if (!(along > 0 && under > 0)) continue;
      allowed = std::min(allowed, std::max(along - std::sqrt(under), 0.0f) / k.headway);
    }
    work.wish_x[i] = e.x * allowed, work.wish_y[i] = e.y * allowed;
  });
}

void cohere(const Work& work, const Constants& k, std::size_t chunk, float* out_vx, float* out_vy) {
  for_each_agent(work, work.chunks[chunk].far, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    const Vec v = at(work.vx, work.vy, i);
    const float radius = work.alike() ? work.common_radius : work.radius[i];
    const float range = k.cohesion_range * radius;
    Vec sum;
    float weights = 0;
    for (const std::size_t j : neighbours) {
      const Vec d = at(work.x, work.y, j) - at(work.x, work.y, i);
      const float rest = std::max(range * range - dot(d, d), 0.0f);
      const float weight = j == i ? 0.0f : rest * rest * rest;
      sum = sum + weight * (at(work.vx, work.vy, j) - v), weights = weights + weight;
    }
    const Vec to = v + (k.cohesion / std::max(weights, 1e-12f)) * sum;
    out_vx[i] = to.x, out_vy[i] = to.y;
  });
}

void foresee(const Work& work, const Constants& k, std::size_t chunk, float* out_vx, float* out_vy) {
  for_each_agent(work, work.chunks[chunk].far, chunk, [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
    Vec sum;
    float pairs = 0;
    for (const std::size_t j : neighbours)
      if (const auto response = response_to_come(work, k, i, j)) sum = sum + *response, pairs += 1;
    const Vec change = shortened((k.over_relaxation / k.dt / std::max(pairs, 1.0f)) * sum, k.velocity_change);
    const Vec v = at(work.vx, work.vy, i) + change;
    out_vx[i] = v.x, out_vy[i] = v.y;
  });
}

void stabilise(const Work& work, const Constants& k, std::size_t chunk, float* out_x, float* out_y) {
  for_each_agent(work, work.chunks[chunk].contacts, chunk,
                 [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
                   const Vec xi = at(work.x, work.y, i);
                   Vec sum;
                   float touches = 0;
                   for (const std::size_t j : neighbours) {
                     const Contact c = contact(work, i, j, xi, at(work.x, work.y, j), 1);
                     if (c.depth <= 0) continue;
                     sum = sum + (share_of(work, i, j) * c.depth) * c.n, touches += 1;
                   }
                   const Vec to = xi + (k.over_relaxation / std::max(touches, 1.0f)) * sum;
                   out_x[i] = to.x, out_y[i] = to.y;
                 });
}

void predict(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk;
  for (std::size_t i = begin; i < begin + work.blocks_of(chunk) * kLanes; ++i) {
    const Vec x = at(work.x, work.y, i);
    work.base_x[i] = x.x, work.base_y[i] = x.y;
    work.moved_x[i] = work.moved_y[i] = 0;
    const Vec to = x + k.part * blended(work, k, i);
    work.predicted_x[i] = to.x, work.predicted_y[i] = to.y;
  }
}

void project(const Work& work, const Constants& k, std::size_t chunk, float* out_x, float* out_y) {
  const auto predicted = [&](std::size_t i) { return at(work.predicted_x, work.predicted_y, i); };
  const auto moved = [&](std::size_t i) { return predicted(i) - at(work.x, work.y, i); };
  for_each_agent(work, work.chunks[chunk].contacts, chunk,
                 [&](std::size_t i, const std::vector<std::size_t>& neighbours) {
                   Vec sum;
                   float touches = 0;
                   for (const std::size_t j : neighbours) {
                     const Contact c = contact(work, i, j, predicted(i), predicted(j), k.growth);
                     if (c.depth <= 0) continue;
                     Vec correction = c.depth * c.n;
                     if (k.static_friction > 0 || k.kinetic_friction > 0) {
                       const Vec u = moved(i) - moved(j);
                       const Vec t = u - dot(u, c.n) * c.n;
                       const float slid = norm(t);
                       const float kinetic = std::min(k.kinetic_friction * c.depth / std::max(slid, 1e-12f), 1.0f);
                       correction = correction - (slid < k.static_friction * c.depth ? 1.0f : kinetic) * t;
                     }
                     sum = sum + share_of(work, i, j) * correction, touches += 1;
                   }
                   const Vec to = predicted(i) + (k.over_relaxation / std::max(touches, 1.0f)) * sum;
                   out_x[i] = to.x, out_y[i] = to.y;
                 });
}

void finish(Work& work, const Constants& k, std::size_t chunk) {
  const std::size_t begin = chunk * kChunk;
  for (std::size_t i = begin; i < begin + work.blocks_of(chunk) * kLanes; ++i) {
    const Vec x = at(work.x, work.y, i);
    const Vec begun = x + k.part * blended(work, k, i);
    const Vec corrected = at(work.corrected_x, work.corrected_y, i) - begun;
    const Vec v = shortened(blended(work, k, i) + k.inverse_part * corrected, work.maximum_speed[i]);
    const Vec moved = at(work.moved_x, work.moved_y, i) + k.part * v;
    const Vec to = at(work.base_x, work.base_y, i) + moved;
    work.moved_x[i] = moved.x, work.moved_y[i] = moved.y;
    work.vx[i] = v.x, work.vy[i] = v.y;
    work.next_x[i] = to.x, work.next_y[i] = to.y;
    const Vec p = to + k.part * blended(work, k, i);
    work.predicted_x[i] = p.x, work.predicted_y[i] = p.y;
  }
}

}  // namespace inhabit::crowd::pbd_model::plainly
