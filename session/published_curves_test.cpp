#include "session/published_curves.h"

#include <doctest/doctest.h>

#include "core/test_data.h"

using namespace inhabit::session;

TEST_CASE("fundamental diagrams of recordings are those that were published for them") {
  if (!INHABIT_TEST_DATA("pedestrians/juelich") || !INHABIT_TEST_DATA("pedestrians/reference_fd")) return;
  const auto data = INHABIT_TEST_DATA("pedestrians")->parent_path();
  const auto agreements = curve_agreements(data);
  REQUIRE(agreements.ok());
  CHECK(agreements->size() == 9);
  for (const CurveAgreement& a : *agreements) {
    MESSAGE(a.experiment, " against ", a.against, ": ", a.speed.bins, " slices, mean ", a.speed.mean, " m/s, rms ",
            a.speed.rmse, ", worst ", a.speed.worst, "; medians ", a.our_median.density, " and ",
            a.their_median.density, " people, ", a.our_median.speed, " and ", a.their_median.speed, " m/s");
    CHECK(a.speed.bins >= 1);
    // The published points of one slice have quartiles 0.05 to 0.15 m/s from their median, and series of other widths
    // and countries differ by as much: two honest measurements of a curve may differ by 0.1 m/s.
    CHECK(std::abs(a.speed.mean) < 0.08);
    CHECK(a.speed.rmse < 0.1);
    if (!a.same_run) continue;
    // Where exactly their areas lay along the arms is not known; half a metre moves the medians by about this much.
    CHECK(std::abs(a.our_median.density - a.their_median.density) < 0.05);
    CHECK(std::abs(a.our_median.speed - a.their_median.speed) < 0.05);
  }
}

TEST_CASE("bottlenecks let as many people through as others of the same width") {
  if (!INHABIT_TEST_DATA("pedestrians/juelich") || !INHABIT_TEST_DATA("pedestrians/reference_fd")) return;
  const auto agreements = flow_agreements(INHABIT_TEST_DATA("pedestrians")->parent_path());
  REQUIRE(agreements.ok());
  for (const FlowAgreement& a : *agreements) {
    MESSAGE(a.experiment, ": ", a.flow, " people/s at ", a.width, " m; published ", a.low, " to ", a.high);
    CHECK(a.published >= 4);
    // A run is one sample: what the last of the queue do moves its mean flow by a tenth.
    CHECK(a.flow > 0.9 * a.low);
    CHECK(a.flow < 1.1 * a.high);
  }
}
