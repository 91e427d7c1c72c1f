#include "exemplar/cluster.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exemplar/ward.h"
#include "geometry/vec2.h"

namespace inhabit::exemplar {
namespace {

using geometry::Vec2;

constexpr double kPriorSamples = 3, kPriorLength = 0.05, kPriorAngle = 5 * kPi / 180;

/// One component of the mixture while it is being fitted.
struct Component {
  double weight = 1, mean = 0, variance = 1;
  std::array<Vec2, 2> direction{{{1, 0}, {1, 0}}};  ///< of the mean angle, unit
  std::array<double, 2> kappa{}, log_norm{};        ///< von Mises
};

/// ln(2 pi I0(k)); I0 by Abramowitz and Stegun 9.8.1 and 9.8.2, relative error below 2e-7.
double log_norm(double k) {
  double log_i0 = 0;
  if (k < 3.75) {
    const double t = (k / 3.75) * (k / 3.75);
    log_i0 = std::log(
        1 + t * (3.5156229 + t * (3.0899424 + t * (1.2067492 + t * (0.2659732 + t * (0.0360768 + t * 0.0045813))))));
  } else {
    const double t = 3.75 / k;
    const double s =
        0.39894228 +
        t * (0.01328592 +
             t * (0.00225319 +
                  t * (-0.00157565 +
                       t * (0.00916281 + t * (-0.02057706 + t * (0.02635537 + t * (-0.01647633 + t * 0.00392377)))))));
    log_i0 = k - 0.5 * std::log(k) + std::log(s);
  }
  return std::log(2 * kPi) + log_i0;
}

/// The concentration whose mean resultant length is r (Fisher 1993, eq. 4.40; within 2 % of A^-1).
double kappa_of(double r) {
  if (r < 0.53) return 2 * r + r * r * r + 5 * r * r * r * r * r / 6;
  if (r < 0.85) return -0.4 + 1.39 * r + 0.43 / (1 - r);
  return 1 / (r * (r - 1) * (r - 3));
}

class Fit {
 public:
  Fit(std::span<const Sample> samples, int angles)
      : samples_(samples), angles_(static_cast<std::size_t>(angles)), directions_(samples.size()) {
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t a = 0; a < angles_; ++a)
        directions_[i][a] = geometry::direction(wrap_angle(samples[i].angles[a]));
  }

  /// Runs from a first assignment; returns ln L and leaves the assignment to the likeliest component.
  double run(std::vector<int>& of, int count) {
    const auto k = static_cast<std::size_t>(count);
    std::vector<double> share(samples_.size() * k);
    for (std::size_t i = 0; i < samples_.size(); ++i) share[i * k + static_cast<std::size_t>(of[i])] = 1;
    std::vector<Component> components(k);
    double last = -1e300;
    for (int iteration = 0; iteration < 200; ++iteration) {
      for (std::size_t c = 0; c < k; ++c) components[c] = maximised(share, k, c);
      const double now = expected(components, share, of);
      if (now - last < 1e-7 * std::abs(now) + 1e-9) return now;
      last = now;
    }
    return last;
  }

 private:
  Component maximised(const std::vector<double>& share, std::size_t k, std::size_t c) const {
    Component out;
    double n = 0, sum = 0;
    std::array<Vec2, 2> resultant{};
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double s = share[i * k + c];
      n += s, sum += s * samples_[i].length;
      for (std::size_t a = 0; a < angles_; ++a) resultant[a] += s * directions_[i][a];
    }
    const double safe = std::max(n, 1e-9);
    out.weight = safe / static_cast<double>(samples_.size());
    out.mean = sum / safe;
    double squares = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double d = samples_[i].length - out.mean;
      squares += share[i * k + c] * d * d;
    }
    out.variance = (squares + kPriorSamples * kPriorLength * kPriorLength) / (n + kPriorSamples);
    for (std::size_t a = 0; a < angles_; ++a) {
      out.direction[a] = geometry::unit(resultant[a]);
      const double prior = kPriorSamples * (1 - kPriorAngle * kPriorAngle / 2);
      const double r = (geometry::length(resultant[a]) + prior) / (n + kPriorSamples);
      out.kappa[a] = kappa_of(std::min(r, 1 - 1e-9));
      out.log_norm[a] = log_norm(out.kappa[a]);
    }
    return out;
  }

  double expected(const std::vector<Component>& components, std::vector<double>& share, std::vector<int>& of) const {
    const std::size_t k = components.size();
    double total = 0;
    std::vector<double> log_density(k);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      double top = -1e300;
      for (std::size_t c = 0; c < k; ++c) {
        const Component& m = components[c];
        const double d = samples_[i].length - m.mean;
        double l = std::log(m.weight) - 0.5 * (std::log(2 * kPi * m.variance) + d * d / m.variance);
        for (std::size_t a = 0; a < angles_; ++a)
          l += m.kappa[a] * geometry::dot(m.direction[a], directions_[i][a]) - m.log_norm[a];
        log_density[c] = l;
        if (l > top) top = l, of[i] = static_cast<int>(c);
      }
      double sum = 0;
      for (std::size_t c = 0; c < k; ++c) sum += share[i * k + c] = std::exp(log_density[c] - top);
      for (std::size_t c = 0; c < k; ++c) share[i * k + c] /= sum;
      total += top + std::log(sum);
    }
    return total;
  }

  std::span<const Sample> samples_;
  std::size_t angles_;
  std::vector<std::array<Vec2, 2>> directions_;
};

Cluster described(std::span<const Sample> samples, const std::vector<int>& of, int c, int angles) {
  Cluster out;
  double sum = 0, squares = 0;
  std::array<Vec2, 2> resultant{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (of[i] != c) continue;
    ++out.count, sum += samples[i].length;
    for (std::size_t a = 0; a < resultant.size(); ++a)
      resultant[a] += geometry::direction(wrap_angle(samples[i].angles[a]));
  }
  if (out.count == 0) return out;
  out.length = sum / out.count;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (of[i] == c) squares += (samples[i].length - out.length) * (samples[i].length - out.length);
  out.length_deviation = std::sqrt(squares / out.count);
  for (std::size_t a = 0; a < static_cast<std::size_t>(angles); ++a) {
    out.angles[a] = geometry::angle_of(resultant[a]);
    const double r = std::clamp(geometry::length(resultant[a]) / out.count, 1e-9, 1.0);
    out.angle_deviations[a] = std::min(kPi, std::sqrt(std::max(0.0, -2 * std::log(r))));
  }
  return out;
}

/// Clusters without samples left out, the most frequent first.
Clustering ordered(std::span<const Sample> samples, std::vector<int> of, int count, const ClusterOptions& options) {
  std::vector<std::pair<Cluster, int>> found;
  for (int c = 0; c < count; ++c)
    if (const Cluster cluster = described(samples, of, c, options.angles); cluster.count > 0)
      found.emplace_back(cluster, c);
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) {
    return a.first.count != b.first.count ? a.first.count > b.first.count : a.first.length < b.first.length;
  });
  Clustering out;
  std::vector<int> rank(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < found.size(); ++i) {
    out.clusters.push_back(found[i].first);
    rank[static_cast<std::size_t>(found[i].second)] = static_cast<int>(i);
  }
  for (const int c : of) out.of.push_back(rank[static_cast<std::size_t>(c)]);
  return out;
}

}  // namespace

Clustering cluster(std::span<const Sample> samples, const ClusterOptions& options) {
  if (samples.empty()) return {};
  const int n = static_cast<int>(samples.size());
  const int most = std::min(options.most, n <= 3 ? std::min(n, 2) : (n + 2) / 3);
  const std::array agglomerations = {agglomerate(samples, options.angles, Spread::fixed, most),
                                     agglomerate(samples, options.angles, Spread::of_samples, most)};
  Fit fit(samples, options.angles);
  Clustering best;
  best.bic = 1e300;
  for (int k = 1; k <= most; ++k) {
    const int parameters = k * (2 + 2 * options.angles) + k - 1;
    for (const auto& levels : agglomerations) {
      std::vector<int> of = levels[static_cast<std::size_t>(k - 1)];
      const double likelihood = fit.run(of, k);
      const double bic = -2 * likelihood + parameters * std::log(static_cast<double>(n));
      if (bic >= best.bic - 1e-9) continue;
      best = ordered(samples, std::move(of), k, options);
      best.bic = bic;
    }
  }
  return best;
}

}  // namespace inhabit::exemplar
