#include <doctest/doctest.h>

#include "layout/check.h"
#include "layout/furnish.h"
#include "session/paper_scenes.h"

/// What the solver says of its layouts and what the check finds in them.
using namespace inhabit;
using namespace inhabit::layout;

TEST_CASE("paper scenes: the solver calls feasible what the check calls feasible") {
  for (const session::PaperScene& paper : session::paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    Options options;
    options.starts = 1;
    const auto outcome = furnish(scene, options);
    REQUIRE(outcome.ok());
    const CheckReport report = check(with_placement(scene, outcome->best.placement));
    for (std::size_t i = 0; i < std::min<std::size_t>(3, report.overlaps.size()); ++i)
      MESSAGE(paper.name, ": ", report.overlaps[i].a, " and ", report.overlaps[i].b, " overlap by ",
              report.overlaps[i].depth);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, report.outside.size()); ++i)
      MESSAGE(paper.name, ": ", report.outside[i].id, " is outside by ", report.outside[i].depth);
    CHECK(outcome->best.feasible == report.feasible);
  }
}

TEST_CASE("paper scenes: the energy of a layout is that of its residuals") {
  for (const session::PaperScene& paper : session::paper_scenes()) {
    CAPTURE(paper.name);
    const Scene scene = paper.build();
    Options options;
    options.starts = 1;
    const auto outcome = furnish(scene, options);
    REQUIRE(outcome.ok());
    const double energy = residuals(with_placement(scene, outcome->best.placement)).energy;
    CHECK(std::abs(energy - outcome->best.energy) <= 1e-9 * energy);
  }
}
