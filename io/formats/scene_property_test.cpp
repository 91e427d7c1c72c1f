#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"
#include "io/formats/scene_json.h"
#include "io/formats/scene_members.h"

using namespace inhabit::io;

namespace {

/// Random scenes in which every kind of member occurs; angles are such as a file can hold.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : rng_(seed) {}

  Scene make() {
    Scene s;
    s.name = text(), s.seed = rng_.next(), s.house_rules = coin(), s.extras = extras();
    s.space.outline = star({0, 0}, std::pow(10, rng_.uniform(0.5, 4)));
    s.space.height = rng_.uniform(1, 9);
    for (std::uint32_t i = rng_.index(4); i > 0; --i) s.space.doors.push_back(opening(s.space, Door{id()}));
    for (std::uint32_t i = rng_.index(4); i > 0; --i) s.space.windows.push_back(opening(s.space, Window{id()}));
    if (coin()) s.space.holes.push_back({id(), star({0, 0}, 0.1), extras()});
    for (std::uint32_t i = 2 + rng_.index(8); i > 0; --i) s.objects.push_back(object(s));
    for (std::uint32_t i = 0; i + 1 < s.objects.size() && i < 6; i += 3) s.groups.push_back(group(i));
    for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
      for (std::uint32_t i = rng_.index(3); i > 0; --i) s.constraints.add(constraint<T>(s));
    });
    s.crowd = crowd(s);
    return s;
  }

 private:
  bool coin() { return rng_.index(2) == 0; }
  std::string id() { return text() + std::to_string(next_id_++); }
  std::string text() {
    static constexpr std::string_view kPieces[] = {"a",    "\"", "\\", "ü", "\n", "/",   "~",
                                                   "日本", " ",  "x-", "😀", "\t", "\x7f"};
    std::string out;
    for (std::uint32_t i = rng_.index(5); i > 0; --i) out += kPieces[rng_.index(std::size(kPieces))];
    return out;
  }
  Extras extras() {
    if (coin()) return {};
    return {{"x-" + id(), R"({"a": [1, 2.50, "b"], "c": null})"}, {"x-" + id(), "-0.0e1"}};
  }
  double angle() { return radians(std::round(rng_.uniform(-360, 360) * 1e9) / 1e9); }
  std::optional<double> maybe(double low, double high) {
    return coin() ? std::nullopt : std::optional(rng_.uniform(low, high));
  }
  /// A simple counter-clockwise ring around a point, at least a third of the radius wide.
  Ring star(Vec2 center, double radius) {
    Ring ring;
    const std::uint32_t n = 5 + rng_.index(12);
    for (std::uint32_t k = 0; k < n; ++k)
      ring.push_back(center + rng_.uniform(0.5 * radius, radius) * direction(2 * kPi * k / n - kPi / 2));
    return ring;
  }
  template <class Opening>
  Opening opening(const Space& space, Opening o) {
    const std::uint32_t wall = rng_.index(static_cast<std::uint32_t>(space.walls()));
    const double l = length(space.wall_end(wall) - space.wall_start(wall));
    o.wall = static_cast<int>(wall), o.from = rng_.uniform(0, l / 2), o.width = rng_.uniform(0.02, l / 2);
    o.extras = extras();
    if constexpr (std::is_same_v<Opening, Door>) o.hinge = coin() ? Door::Hinge::start : Door::Hinge::end;
    return o;
  }
  Object object(const Scene& s) {
    Object o{id(), text(), text()};
    o.size = {rng_.uniform(0.01, 1), rng_.uniform(0.01, 1), rng_.uniform(0.01, 3)};
    if (coin()) o.position = Vec3{rng_.uniform(-1e5, 1e5), rng_.uniform(-1, 1), rng_.uniform()};
    if (coin()) o.angle = angle();
    o.fixed = o.position && coin();
    o.lock = static_cast<Lock>(rng_.index(4)), o.mount = static_cast<Mount>(rng_.index(3));
    o.clearance = {rng_.uniform(), coin() ? rng_.uniform() : 0, 0, rng_.uniform()};
    if (coin()) o.view = View{rng_.uniform(), std::abs(angle())};
    o.mass = maybe(0.1, 10), o.model = text(), o.extras = extras();
    if (!s.objects.empty() && coin())
      o.on = {Ref::Kind::object, rng_.index(static_cast<std::uint32_t>(s.objects.size()))};
    return o;
  }
  Group group(std::uint32_t first) {
    Group g{id(), {{Ref::Kind::object, first}, {Ref::Kind::object, first + 1}}, coin(), maybe(0.1, 2)};
    if (coin()) g.position = Vec2{rng_.uniform(), -rng_.uniform()};
    if (coin()) g.angle = angle();
    const Vec2 p{rng_.uniform(), 0}, q{1, rng_.uniform()};
    if (coin()) g.curve = coin() ? Curve{Curve::Kind::arc, p, q, {3, 3}} : Curve{Curve::Kind::segment, p, q};
    if (coin()) g.curve = Curve{Curve::Kind::segment, {}, {}, {}, true};
    g.extras = extras();
    return g;
  }

  // People.
  Span span() {
    const double low = rng_.uniform(0.1, 1);
    return {low, coin() ? low : rng_.uniform(low, 2)};
  }
  Route route(const Crowd& c) {
    Route r;
    for (std::uint32_t legs = rng_.index(4); legs > 0; --legs) {
      auto& leg = r.legs.emplace_back();
      for (std::uint32_t i = rng_.index(3) + 1; i > 0; --i)
        leg.push_back(c.goals[rng_.index(static_cast<std::uint32_t>(c.goals.size()))].id);
    }
    return r;
  }
  Body body(const Crowd& c) {
    return {span(), rng_.uniform(0.1, 9), {rng_.uniform(), rng_.uniform(), maybe(0, 3)}, route(c)};
  }
  Goal goal() {
    Goal g;
    g.id = id() + "g", g.wait = rng_.uniform(0, 60), g.absorb = coin(), g.extras = extras();
    switch (rng_.index(3)) {
      case 0:
        g.area = star({9, 9}, 3);
        if (coin()) g.aim = star({9, 9}, 1);
        break;
      case 1:
        g.direction = angle();
        break;
      default:
        g.offset = Vec2{rng_.uniform(-9, 9), rng_.uniform(-9, 9)}, g.jitter = rng_.uniform();
    }
    return g;
  }
  Crowd crowd(const Scene& s) {
    Crowd c;
    for (std::uint32_t i = 1 + rng_.index(4); i > 0; --i) c.goals.push_back(goal());
    for (std::uint32_t i = rng_.index(3); i > 0; --i) {
      Population& p = c.populations.emplace_back();
      static_cast<Body&>(p) = body(c);
      p.id = id(), p.area = star({-9, 3}, 2), p.walking = coin(), p.extras = extras();
      if (coin()) p.count = static_cast<int>(rng_.index(1000));
      if (!p.count || coin()) p.spacing = rng_.uniform(0.1, 9), p.jitter = rng_.uniform();
    }
    for (std::uint32_t i = rng_.index(3); i > 0; --i) {
      Source& source = c.sources.emplace_back();
      static_cast<Body&>(source) = body(c);
      source.id = id(), source.area = star({5, 3}, 2), source.rate = rng_.uniform(), source.extras = extras();
      source.arrivals = static_cast<Source::Arrivals>(rng_.index(2)), source.from = rng_.uniform(0, 9);
      source.until = maybe(10, 99);
      if (coin()) source.count = static_cast<int>(rng_.index(1000));
    }
    std::size_t which = rng_.index(static_cast<std::uint32_t>(CrowdModels::size));
    for_each_type(CrowdModels{}, [&]<class T>(std::type_identity<T>) {
      if (which-- == 0) c.model = filled<T>(s);
    });
    c.planner = static_cast<Planner>(rng_.index(4)), c.step = rng_.uniform(0.001, 1);
    c.seconds = rng_.uniform(1, 1e4), c.extras = extras();
    return c;
  }

  // Constraints and crowd models: any value that the field's own description allows.
  template <class T>
  T filled(const Scene& s) {
    T c;
    for (const auto& field : T::kFields)
      std::visit(
          [&](auto pointer) {
            fill(c.*pointer, Spec{"", field.unit, field.low, field.high, true, field.choices}, s);
          },
          field.member);
    return c;
  }
  template <class T>
  T constraint(const Scene& s) {
    T c = filled<T>(s);
    if constexpr (requires {
                    c.min;
                    c.max;
                  })
      c.max = *c.min + 1;
    if constexpr (requires { c.wall; })
      c.wall = static_cast<int>(rng_.index(static_cast<std::uint32_t>(s.space.walls())));
    c.stiffness = maybe(0, 1), c.weight = maybe(0, 9), c.extras = extras();
    return c;
  }
  void fill(double& x, const Spec& spec, const Scene&) {
    x = spec.unit == "rad" ? angle() : rng_.uniform(spec.low, spec.high);
  }
  void fill(std::optional<double>& x, const Spec& spec, const Scene& s) { fill(x.emplace(), spec, s); }
  void fill(std::optional<int>& x, const Spec& spec, const Scene& s) { fill(x.emplace(), spec, s); }
  void fill(bool& x, const Spec&, const Scene&) { x = coin(); }
  void fill(int& x, const Spec& spec, const Scene&) {
    x = spec.choices.empty()
            ? static_cast<int>(spec.low +
                               rng_.index(static_cast<std::uint32_t>(std::min(spec.high, 1e3) - spec.low) + 1))
            : static_cast<int>(rng_.index(static_cast<std::uint32_t>(split_choices(spec.choices).size())));
  }
  void fill(Ref& x, const Spec&, const Scene& s) {
    x = {Ref::Kind::object, rng_.index(static_cast<std::uint32_t>(s.objects.size()))};
  }
  void fill(std::array<Ref, 2>& x, const Spec&, const Scene&) {
    x = {Ref{Ref::Kind::object, 0}, Ref{Ref::Kind::object, 1}};
  }
  void fill(Members& x, const Spec&, const Scene& s) {
    if (coin() && !s.groups.empty()) {
      x.all_of = {Ref::Kind::group, 0};
    } else {
      x.list = {{Ref::Kind::object, 1}, {Ref::Kind::object, 0}};
    }
  }
  void fill(Vec2& x, const Spec&, const Scene&) { x = {rng_.uniform(-9, 9), rng_.uniform(-9, 9)}; }
  void fill(Ring& x, const Spec&, const Scene&) { x = star({1, 2}, 3); }

  Rng rng_;
  int next_id_ = 0;
};

}  // namespace

TEST_CASE("random scenes survive writing and reading unchanged") {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const Scene scene = RandomScene(seed).make();
    const std::string text = write_scene(scene);
    const auto again = read_scene(text);
    REQUIRE_MESSAGE(again.ok(), "seed ", seed, ": ", again.error().text());
    REQUIRE_MESSAGE(*again == scene, "seed ", seed);
    REQUIRE_MESSAGE(write_scene(*again) == text, "seed ", seed);
  }
}
