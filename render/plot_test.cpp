#include "render/plot.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "render/sheet.h"

using namespace inhabit;
using namespace inhabit::render;

TEST_CASE("ticks are nice and cover the range") {
  CHECK(nice_ticks(0, 10, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
  core::Rng rng(3);
  for (int i = 0; i < 1000; ++i) {
    const double low = rng.uniform(-1, 1) * std::exp(rng.uniform(-20, 20)), high = low + std::exp(rng.uniform(-10, 20));
    if (!(high - low > 1e-9 * std::abs(low))) continue;
    const auto ticks = nice_ticks(low, high, 6);
    const double slack = 1e-6 * (high - low) + 1e-12 * std::abs(low);
    CHECK(ticks.front() <= low + slack);
    CHECK(ticks.back() >= high - slack);
    CHECK(ticks.size() >= 3);
    CHECK(ticks.size() <= 10);
  }
}

TEST_CASE("logarithmic ticks are powers of ten") {
  CHECK(log_ticks(1, 1000).size() == 4);
  CHECK(log_ticks(0.9, 30).size() == 5);  // 1 2 5 10 20
  for (const double t : log_ticks(1e-12, 1e12)) CHECK(std::abs(std::log10(t) - std::round(std::log10(t))) < 1e-9);
  CHECK(log_ticks(1e-12, 1e12).size() <= 10);
}

TEST_CASE("an energy plot names the best start and its first feasible iteration") {
  std::vector<layout::TraceRow> trace;
  for (int start = 0; start < 3; ++start)
    for (int i = 0; i < 50; ++i)
      trace.push_back({start, i, 100.0 / (1 + i) + start, 0, start > 0 && i >= 20 + start, false});
  const auto svg = encode(draw_energy(trace), Format::svg);
  REQUIRE(svg.ok());
  CHECK(svg->find("start 1 (best)") != std::string::npos);
  CHECK(svg->find("feasible at 21") != std::string::npos);
  CHECK(svg->find("3 starts, 2 feasible") != std::string::npos);
  CHECK(*encode(draw_energy(trace), Format::png) == *encode(draw_energy(trace), Format::png));
}

TEST_CASE("plots without data or with numbers that are not finite are drawn all the same") {
  Plot plot;
  CHECK(encode(draw_plot(plot), Format::png).ok());
  CHECK(encode(draw_energy({}), Format::svg).ok());
  plot.x.log = plot.y.log = true;
  plot.series = {{"a", {{0, 1}, {1, std::nan("")}, {-2, 3}, {1, 1e308}}}, {"", {{1, 1}}, {{2, 3}, {4, 5}}}};
  plot.guide_slope = 0;
  plot.annotations = {{{0, 0}, "nowhere", {}}, {{1, 1}, "here", {}}};
  for (const bool log : {true, false}) {
    plot.x.log = plot.y.log = log;
    const auto svg = encode(draw_plot(plot), Format::svg);
    REQUIRE(svg.ok());
    CHECK(svg->find("nan") == std::string::npos);
  }
}

TEST_CASE("a sheet holds every caption at one scale") {
  scene::Scene a, b;
  a.space.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  b.space.outline = {{0, 0}, {2, 0}, {2, 5}, {0, 5}};
  const std::vector<SheetCell> cells = {{&a, "before"}, {&b, "after", true, 0.5}, {nullptr, "missing"}, {&a}};
  const auto svg = encode(draw_sheet(cells, {.title = "variants"}), Format::svg);
  REQUIRE(svg.ok());
  for (const char* text : {">variants<", ">before<", ">after<", ">feasible<", ">energy 0.500<", ">4<"})
    CHECK_MESSAGE(svg->find(text) != std::string::npos, text);
  CHECK(encode(draw_sheet({}), Format::pdf).ok());
}
