#include <doctest/doctest.h>

#include "core/rng.h"
#include "layout/constraint_instances.h"

/// What every term type promises (style-guide.md 8), over thousands of random instances of each. An instance is named
/// by its type and number: Rng(kSeed, number).
using namespace inhabit::layout;
using namespace inhabit::layout::testing;

namespace {

constexpr std::uint64_t kSeed = 2026;
constexpr std::uint64_t kCases = 2000;

/// Calls f(term, world, scale) for random instances of every type.
template <class F>
void for_each_instance(Form form, F f) {
  for_each_type(TermTypes{}, [&]<class T>(std::type_identity<T>) {
    if (form == Form::pair && !Instances<T>::kPairs) return;
    for (std::uint64_t n = 0; n < kCases; ++n) {
      const std::string_view type = Instances<T>::kName;
      INFO(type, " ", n, " of seed ", kSeed);
      Rng rng(kSeed, n);
      const double scale = std::pow(10.0, rng.uniform(-3, 3));
      World w(rectangle(10 * scale, 8 * scale));
      const T term = Instances<T>::random(w, rng, scale, form);
      f(term, w, scale);
    }
  });
}

bool finite(const State& x) {
  for (const State::Body& b : x.bodies) {
    if (!std::isfinite(b.p.x) || !std::isfinite(b.p.y) || !std::isfinite(b.angle)) return false;
  }
  return true;
}

/// What rounding may do: some units in the last place of coordinates of ten scales and of headings.
double rounding(double scale) { return 1e-13 * std::max(100 * scale, 10.0); }

/// True when a documented tie makes the order of the particles matter.
template <class T>
bool tied(const T& term, const World& w) {
  if constexpr (requires { Instances<T>::tied(term, w); }) return Instances<T>::tied(term, w);
  return false;
}

/// The same world with its particles in another order.
World permuted(const World& w, const std::vector<std::uint32_t>& to) {
  World out(w.room().outline());
  State y = w.x;
  auto& data = out.data();
  data = *w.x.data;
  out.x = State(data, out.room());
  out.x.frames = w.x.frames;
  for (std::uint32_t b = 0; b < to.size(); ++b) {
    data.bodies[to[b]] = w.x.data->bodies[b];
    data.bodies[to[b]].first_box = to[b];
    data.boxes[to[b]] = w.x.data->boxes[b];
    data.boxes[to[b]].body = to[b];
  }
  for (GroupData& g : data.groups) {
    for (std::uint32_t& b : g.bodies) b = to[b];
  }
  for (std::uint32_t b = 0; b < to.size(); ++b) out.x.place(to[b], y.bodies[b].p, y.bodies[b].angle);
  return out;
}

}  // namespace

TEST_CASE("every term: satisfied means no move") {
  for_each_instance(Form::any, [](auto term, World& w, double scale) {
    using T = std::decay_t<decltype(term)>;
    if (!Instances<T>::satisfy(term, w)) return;
    CHECK(std::abs(error(term, w.x)) <= rounding(scale));
    CHECK(change(w.x, projected(term, w.x)) <= 10 * rounding(scale));
  });
}

TEST_CASE("every term: pinned means no move") {
  for_each_instance(Form::any, [](const auto& term, World& w, double) {
    for (std::uint32_t b = 0; b < w.x.bodies.size(); ++b) w.pin({b});
    for (GroupData& g : w.data().groups) g.w = 0;
    CHECK(change(w.x, projected(term, w.x)) == 0);
  });
}

TEST_CASE("every term: whoever is pinned stays while the others move") {
  for_each_instance(Form::any, [](const auto& term, World& w, double) {
    w.pin({0});
    const State y = projected(term, w.x);
    CHECK(y.bodies[0].p == w.x.bodies[0].p);
    CHECK(y.bodies[0].angle == w.x.bodies[0].angle);
  });
}

TEST_CASE("every term between two: equal masses keep their centre") {
  for_each_instance(Form::pair, [](const auto& term, World& w, double scale) {
    const State y = projected(term, w.x);
    Vec2 before, after;
    for (const State::Body& b : w.x.bodies) before += b.p;
    for (const State::Body& b : y.bodies) after += b.p;
    CHECK(length(after - before) <= rounding(scale));
  });
}

TEST_CASE("every term: a small step does not raise the error") {
  for_each_instance(Form::simple, [](const auto& term, World& w, double scale) {
    const State y = projected(term, w.x, 0.1);
    CHECK(std::abs(error(term, y)) <= std::abs(error(term, w.x)) + rounding(scale));
  });
}

TEST_CASE("every term: a whole step satisfies what is linear") {
  for_each_instance(Form::simple, [](const auto& term, World& w, double scale) {
    const State y = projected(term, w.x);
    CHECK(std::abs(error(term, y)) <= 10 * rounding(scale));
  });
}

TEST_CASE("every term: half a step halves what is linear") {
  for_each_instance(Form::simple, [](const auto& term, World& w, double scale) {
    using T = std::decay_t<decltype(term)>;
    const double e = std::abs(error(term, w.x));
    CHECK(std::abs(error(term, projected(term, w.x, 0.5))) <= Instances<T>::kHalf * e + 10 * rounding(scale));
  });
}

TEST_CASE("every term: permuting the particles permutes the result") {
  for_each_instance(Form::any, [](const auto& term, World& w, double scale) {
    if (tied(term, w)) return;
    const auto n = static_cast<std::uint32_t>(w.x.bodies.size());
    std::vector<std::uint32_t> to(n);
    for (std::uint32_t b = 0; b < n; ++b) to[b] = n - 1 - b;
    const World other = permuted(w, to);
    auto renamed = term;
    // anchors() shows them as const; `renamed` is not.
    anchors(renamed, [&](const Anchor& a) {
      if (!a.group()) const_cast<Anchor&>(a).body = to[a.body];
    });
    const State y = projected(term, w.x), z = projected(renamed, other.x);
    CHECK(std::abs(error(term, y) - error(renamed, z)) <= rounding(scale));
    double most = 0;
    for (std::uint32_t b = 0; b < n; ++b) most = std::max(most, length(y.bodies[b].p - z.bodies[to[b]].p));
    CHECK(most <= rounding(scale));
  });
}

TEST_CASE("every term: the order of the members in the list does not matter") {
  for_each_instance(Form::any, [](const auto& term, World& w, double scale) {
    if constexpr (requires { term.members; }) {
      if (tied(term, w)) return;
      auto turned = term;
      std::ranges::reverse(turned.members);
      if constexpr (requires { turned.masses; }) std::ranges::reverse(turned.masses);
      CHECK(change(projected(term, w.x), projected(turned, w.x)) <= rounding(scale));
    }
  });
}

TEST_CASE("every term: nothing that degenerates makes a number that is none") {
  for_each_instance(Form::any, [](const auto& term, World& w, double scale) {
    for (const Vec2 p : {Vec2{}, Vec2{scale, scale}, Vec2{-scale, 1e6 * scale}, Vec2{5 * scale, 4 * scale}}) {
      State x = w.x;
      for (std::uint32_t b = 0; b < x.bodies.size(); ++b) x.place(b, p, 0);
      for (int i = 0; i < 3; ++i) x = projected(term, x, i == 0 ? 0.1 : 1);
      CHECK(finite(x));
      CHECK(std::isfinite(error(term, x)));
    }
    // Coincident two by two.
    State x = w.x;
    for (std::uint32_t b = 1; b < x.bodies.size(); b += 2) x.place(b, x.bodies[b - 1].p, x.bodies[b].angle);
    CHECK(finite(projected(term, x)));
  });
}

TEST_CASE("every term: the same state gives the same bits") {
  for_each_instance(Form::any, [](const auto& term, World& w, double) {
    CHECK(change(projected(term, w.x), projected(term, w.x)) == 0);
  });
}
