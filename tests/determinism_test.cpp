#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "core/hash.h"
#include "layout/furnish.h"
#include "session/paper_scenes.h"

/// Same input, seed and build: same bits, at any number of threads and at any optimisation. This file is built twice,
/// the second time with the solver at -O0 (tests/CMakeLists.txt); both compare with tests/golden_layouts.txt, whose
/// lines say `scene digest`. When the solver has changed on purpose: `cmake --build build/release --target
/// update_golden`, and say in the change why the layouts differ.
using namespace inhabit;
using namespace inhabit::layout;

namespace {

const std::string kTable = INHABIT_SOURCE_DIR "/tests/golden_layouts.txt";

Options two_starts(int threads, std::uint64_t seed = 1) {
  Options o;
  o.seed = seed, o.starts = 2, o.threads = threads;
  return o;
}

std::uint64_t digest(const Placement& p) {
  core::Digest d;
  for (const Placement::Spot& o : p.objects)
    d.add(o.position.x), d.add(o.position.y), d.add(o.position.z), d.add(o.angle);
  for (const Pose& g : p.groups) d.add(g.p.x), d.add(g.p.y), d.add(g.angle);
  return d.value();
}

/// Of every start, and of the one that was chosen.
std::uint64_t digest(const Outcome& outcome) {
  core::Digest d;
  for (const Layout& l : outcome.starts) d.add(digest(l.placement)), d.add(l.energy);
  d.add(digest(outcome.best.placement));
  return d.value();
}

std::string hex(std::uint64_t v) {
  std::ostringstream s;
  s << std::hex << v;
  return s.str();
}

std::uint64_t solved(const Scene& scene, const Options& options) {
  const auto outcome = furnish(scene, options);
  REQUIRE(outcome.ok());
  return digest(*outcome);
}

std::map<std::string, std::string> golden() {
  std::map<std::string, std::string> table;
  std::ifstream in(kTable);
  for (std::string name, value; in >> name >> value;) table[name] = value;
  return table;
}

}  // namespace

TEST_CASE("golden layouts: every scene of the papers ends as recorded") {
  const char* update = std::getenv("INHABIT_UPDATE_GOLDEN");
  const auto table = golden();
  std::ostringstream now;
  for (const session::PaperScene& paper : session::paper_scenes()) {
    const std::string name(paper.name), value = hex(solved(paper.build(), two_starts(2)));
    now << name << ' ' << value << '\n';
    if (update != nullptr) continue;
    const auto entry = table.find(name);
    INFO(name, ": ", value, "; a wanted change is recorded by `cmake --build build/release --target update_golden`");
    CHECK((entry != table.end() && entry->second == value));
  }
  if (update != nullptr) std::ofstream(kTable) << now.str();
}

TEST_CASE("determinism: any number of threads gives the same bytes") {
  for (const session::PaperScene& paper : session::paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    const std::uint64_t one = solved(scene, two_starts(1));
    for (const int threads : {2, 8}) CHECK(solved(scene, two_starts(threads)) == one);
  }
}

TEST_CASE("determinism: different seeds give different layouts") {
  for (const char* name : {"picnic", "living-room", "desk", "tight-bedroom"}) {
    const Scene scene = session::find_paper_scene(name)->build();
    CHECK(solved(scene, two_starts(1, 1)) != solved(scene, two_starts(1, 2)));
  }
}

TEST_CASE("determinism: a start does not depend on the others") {
  const Scene scene = session::living_room();
  Options few = two_starts(1), many = two_starts(4);
  many.starts = 6;
  const auto a = furnish(scene, few), b = furnish(scene, many);
  REQUIRE((a.ok() && b.ok()));
  REQUIRE(b->starts.size() == 6);
  for (std::size_t i = 0; i < 2; ++i) CHECK(digest(a->starts[i].placement) == digest(b->starts[i].placement));
}

TEST_CASE("determinism: a trace is the same at any number of threads") {
  const Scene scene = session::desk();
  Options options = two_starts(1);
  options.trace = true;
  const auto a = furnish(scene, options);
  options.threads = 8;
  const auto b = furnish(scene, options);
  REQUIRE((a.ok() && b.ok()));
  REQUIRE(a->trace.size() == b->trace.size());
  for (std::size_t i = 0; i < a->trace.size(); ++i) {
    CHECK(a->trace[i].energy == b->trace[i].energy);
    CHECK(a->trace[i].start == b->trace[i].start);
  }
}
