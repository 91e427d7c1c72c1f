#include <doctest/doctest.h>

#include "layout/check.h"
#include "layout/furnish.h"
#include "session/paper_scenes.h"

/// What the solver says of its layouts and what the check finds in them.
using namespace inhabit;
using namespace inhabit::layout;

namespace {

/// Calls f(what the solver says of its layout, the scene so furnished) for every paper's scene.
template <class F>
void for_each_paper_layout(F&& f) {
  for (const session::PaperScene& paper : session::paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    Options options;
    options.starts = 1;
    const auto outcome = furnish(scene, options);
    REQUIRE(outcome.ok());
    f(outcome->best, with_placement(scene, outcome->best.placement));
  }
}

}  // namespace

TEST_CASE("paper scenes: the solver calls feasible what the check calls feasible") {
  for_each_paper_layout([](const Layout& layout, const Scene& scene) {
    const CheckReport report = check(scene);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, report.overlaps.size()); ++i)
      MESSAGE(scene.name, ": ", report.overlaps[i].a, " and ", report.overlaps[i].b, " overlap by ",
              report.overlaps[i].depth);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, report.outside.size()); ++i)
      MESSAGE(scene.name, ": ", report.outside[i].id, " is outside by ", report.outside[i].depth);
    CHECK(layout.feasible == report.feasible);
  });
}

TEST_CASE("paper scenes: the energy of a layout is that of its residuals") {
  for_each_paper_layout([](const Layout& layout, const Scene& scene) {
    const double energy = residuals(scene).energy;
    CHECK(std::abs(energy - layout.energy) <= 1e-9 * energy);
  });
}
