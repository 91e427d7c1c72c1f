#include "session/machine_limits.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "core/aligned.h"
#include "core/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "session/machine_limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace inhabit::session::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
constexpr D kD;

/// `rounds` rounds of eight independent chains of a multiplication and an addition; the number of operations.
double churn(std::size_t rounds, float* out) {
  const auto a = hn::Set(kD, 0.999f), b = hn::Set(kD, 0.001f);
  auto c0 = hn::Iota(kD, 0), c1 = hn::Iota(kD, 1), c2 = hn::Iota(kD, 2), c3 = hn::Iota(kD, 3);
  auto c4 = hn::Iota(kD, 4), c5 = hn::Iota(kD, 5), c6 = hn::Iota(kD, 6), c7 = hn::Iota(kD, 7);
  for (std::size_t k = 0; k < rounds; ++k) {
    c0 = hn::Add(hn::Mul(c0, a), b), c1 = hn::Add(hn::Mul(c1, a), b);
    c2 = hn::Add(hn::Mul(c2, a), b), c3 = hn::Add(hn::Mul(c3, a), b);
    c4 = hn::Add(hn::Mul(c4, a), b), c5 = hn::Add(hn::Mul(c5, a), b);
    c6 = hn::Add(hn::Mul(c6, a), b), c7 = hn::Add(hn::Mul(c7, a), b);
  }
  const auto sum = hn::Add(hn::Add(hn::Add(c0, c1), hn::Add(c2, c3)), hn::Add(hn::Add(c4, c5), hn::Add(c6, c7)));
  *out = hn::GetLane(hn::SumOfLanes(kD, sum));
  return 16.0 * static_cast<double>(rounds * hn::Lanes(kD));
}

void triad(float* a, const float* b, const float* c, std::size_t count) {
  const auto s = hn::Set(kD, 0.5f);
  for (std::size_t i = 0; i < count; i += hn::Lanes(kD))
    hn::Store(hn::Add(hn::Load(kD, b + i), hn::Mul(s, hn::Load(kD, c + i))), kD, a + i);
}

}  // namespace inhabit::session::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace inhabit::session {
namespace {

HWY_EXPORT(churn);
HWY_EXPORT(triad);

/// Both are the best of so many runs: what else the machine does only makes them slower.
constexpr int kRuns = 7;

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::size_t threads_of(int threads) {
  return threads > 0 ? static_cast<std::size_t>(threads) : std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace

double peak_flops(int threads) {
  const std::size_t parts = 8 * threads_of(threads);
  std::vector<float> results(parts);
  std::vector<double> operations(parts);
  double best = 0;
  for (int run = 0; run < kRuns; ++run) {
    const double seconds = seconds_of([&] {
      core::parallel_for(parts, threads,
                         [&](std::size_t k) { operations[k] = HWY_DYNAMIC_DISPATCH(churn)(400'000, &results[k]); });
    });
    best = std::max(best, static_cast<double>(parts) * operations[0] / seconds);
  }
  return best;
}

double bandwidth(std::size_t bytes, int threads) {
  constexpr std::size_t kPart = 4096;
  const std::size_t parts = std::max<std::size_t>(1, bytes / (3 * sizeof(float) * kPart));
  core::AlignedVector<float> a(parts * kPart), b(parts * kPart, 1), c(parts * kPart, 2);
  const std::size_t chunks = std::min<std::size_t>(parts, 8 * threads_of(threads));
  double best = 0;
  for (int run = 0; run < kRuns; ++run) {
    const double seconds = seconds_of([&] {
      core::parallel_for(chunks, threads, [&](std::size_t k) {
        const std::size_t begin = parts * k / chunks * kPart, end = parts * (k + 1) / chunks * kPart;
        HWY_DYNAMIC_DISPATCH(triad)(a.data() + begin, b.data() + begin, c.data() + begin, end - begin);
      });
    });
    best = std::max(best, static_cast<double>(3 * sizeof(float) * parts * kPart) / seconds);
  }
  return best;
}

}  // namespace inhabit::session
#endif  // HWY_ONCE
