#include "session/paper_scenes.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "session/scene_builder.h"

using namespace inhabit::session;

namespace {

bool in_range(const Scene& scene, Ref ref) {
  switch (ref.kind) {
    case Ref::Kind::object:
      return ref.index < scene.objects.size();
    case Ref::Kind::group:
      return ref.index < scene.groups.size();
    case Ref::Kind::door:
      return ref.index < scene.space.doors.size();
    case Ref::Kind::none:
      return true;
  }
  return false;
}

template <class T>
void check_refs(const Scene& scene, const T& constraint) {
  for (const Field<T>& field : T::kFields) {
    if (const auto* ref = std::get_if<Ref T::*>(&field.member)) {
      CHECK(in_range(scene, constraint.**ref));
      CHECK_FALSE((field.required && (constraint.**ref).none()));
    }
    if (const auto* pair = std::get_if<std::array<Ref, 2> T::*>(&field.member))
      for (const Ref ref : constraint.**pair) CHECK((in_range(scene, ref) && !ref.none()));
    if (const auto* members = std::get_if<Members T::*>(&field.member)) {
      CHECK_FALSE((field.required && (constraint.**members).empty()));
      for (const Ref ref : (constraint.**members).list) CHECK((in_range(scene, ref) && !ref.none()));
    }
  }
}

int count_kind(const Scene& scene, std::string_view kind) {
  int n = 0;
  for (const Object& o : scene.objects) n += o.kind == kind;
  return n;
}

}  // namespace

TEST_CASE("every scene of the papers has the published number of objects") {
  CHECK(paper_scenes().size() == 17);
  for (const PaperScene& paper : paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    CHECK(scene.name == paper.name);
    if (paper.published_objects)
      CHECK(static_cast<int>(scene.objects.size()) == paper.published_objects);
    else
      CHECK((scene.objects.size() >= 7 && scene.objects.size() <= 15));
    MESSAGE(std::string(paper.name), ": ", scene.objects.size(), " objects, ", scene.constraints.size(),
            " constraints, ", scene.space.outline[2].x, " m x ", scene.space.outline[2].y, " m, coverage ",
            floor_coverage(scene));
  }
}

TEST_CASE("ids are unique and every reference points at something") {
  for (const PaperScene& paper : paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    std::set<std::string> ids;
    for (const Object& o : scene.objects) CHECK(ids.insert(o.id).second);
    for (const Group& g : scene.groups) {
      CHECK(ids.insert(g.id).second);
      for (const Ref member : g.members) CHECK(in_range(scene, member));
    }
    for (const Door& d : scene.space.doors) {
      CHECK(ids.insert(d.id).second);
      const Vec2 wall = scene.space.wall_end(static_cast<std::size_t>(d.wall)) -
                        scene.space.wall_start(static_cast<std::size_t>(d.wall));
      CHECK(d.from >= 0);
      CHECK(d.from + d.width <= length(wall));
    }
    for (const Window& w : scene.space.windows) {
      const Vec2 wall = scene.space.wall_end(static_cast<std::size_t>(w.wall)) -
                        scene.space.wall_start(static_cast<std::size_t>(w.wall));
      CHECK(w.from + w.width <= length(wall));
    }
    for_each_type(ConstraintKinds{}, [&]<class K>(std::type_identity<K>) {
      for (const K& constraint : scene.constraints.of<K>()) check_refs(scene, constraint);
    });
  }
}

TEST_CASE("the picnic is made of what the thesis counts") {
  const Scene scene = picnic();
  CHECK(count_kind(scene, "table") == 14);
  CHECK(count_kind(scene, "chair") == 48);
  CHECK(count_kind(scene, "trash can") == 8);
  CHECK(count_kind(scene, "grill") == 6);
  CHECK(count_kind(scene, "carousel") == 1);
}

TEST_CASE("the desk carries twelve books in two stacks") {
  const Scene scene = desk();
  CHECK(count_kind(scene, "book") == 12);
  CHECK(scene.constraints.of<Stacking>().size() == 10);
}

TEST_CASE("the tight scenes are tight") {
  CHECK(floor_coverage(tight_bedroom()) >= 0.5);
  for (const double coverage : {0.5, 0.6, 0.66, 0.7, 0.75, 0.8})
    CHECK(floor_coverage(tight_bedroom(coverage)) == doctest::Approx(coverage).epsilon(1e-9));
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Scene scene = tight_picnic(seed);
    sizes.insert(scene.objects.size());
    CHECK(floor_coverage(scene) >= 0.5);
    CHECK(scene.objects.size() >= 44);
    CHECK(scene.objects.size() <= 64);
  }
  CHECK(sizes.size() > 5);
}

TEST_CASE("the theatre grows with its seats, by a few constraints each") {
  for (const int seats : {1, 2, 25, 50, 100, 200, 400, 800, 1600, 3200, 100000}) {
    CAPTURE(seats);
    const Scene scene = theater_1(seats);
    CHECK(static_cast<int>(scene.objects.size()) == seats + 1);
    if (seats >= 25) CHECK(floor_coverage(scene) > 0.15);
    CHECK(floor_coverage(scene) < 0.5);
    CHECK(scene.constraints.size() <= 4 * scene.objects.size());
    const Vec2 size = scene.space.outline[2];
    MESSAGE(seats, " seats: ", scene.constraints.of<FocalDistance>().size(), " tiers, ", size.x, " m x ", size.y,
            " m, coverage ", floor_coverage(scene));
  }
}
