#include "render/drawing.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace inhabit;
using namespace inhabit::render;

namespace {

Drawing sample() {
  Drawing d{{300, 200}, rgb(0xffffff), "a <b> & \"c\"", {}};
  add(d, Path{}.circle({100, 100}, 40),
      {.fill = rgb(0x336699, 0.5), .stroke = rgb(0), .width = 2, .dash = 4, .gap = 2});
  write(d, {"Möbel & <Licht>", {150, 50}, 14, rgb(0x222222), Anchor::middle, true, 0.3});
  return d;
}

}  // namespace

TEST_CASE("one drawing becomes three files with the right beginnings and always the same bytes") {
  const Drawing d = sample();
  for (const auto& [format, head] :
       {std::pair{Format::svg, "<?xml"}, {Format::png, "\x89PNG"}, {Format::pdf, "%PDF-"}}) {
    const auto a = encode(d, format), b = encode(d, format);
    REQUIRE(a.ok());
    REQUIRE(b.ok());
    CHECK(a->starts_with(head));
    CHECK(*a == *b);
  }
  CHECK(encode(d, Format::pdf)->find("CreationDate (20000101000000Z)") != std::string::npos);
}

TEST_CASE("svg text is escaped and stays text") {
  const auto svg = encode(sample(), Format::svg);
  REQUIRE(svg.ok());
  CHECK(svg->find("Möbel &amp; &lt;Licht&gt;</text>") != std::string::npos);
  CHECK(svg->find("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>") != std::string::npos);
}

TEST_CASE("a png has the asked number of pixels on its long side") {
  const auto png = encode(sample(), Format::png, {.png_long_side = 600});
  REQUIRE(png.ok());
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>((*png)[i]); };
  CHECK(at(18) * 256 + at(19) == 600);
  CHECK(at(22) * 256 + at(23) == 400);
}

TEST_CASE("unusable pages and sizes are errors") {
  CHECK_FALSE(encode(Drawing{{0, 10}}, Format::png).ok());
  CHECK_FALSE(encode(Drawing{{std::nan(""), 10}}, Format::svg).ok());
  CHECK_FALSE(encode(sample(), Format::png, {.png_long_side = 0}).ok());
  CHECK_FALSE(encode(sample(), Format::png, {.png_long_side = 1000000}).ok());
}

TEST_CASE("any bytes may be written as text") {
  Drawing d = sample();
  core::Rng rng(7);
  for (int i = 0; i < 200; ++i) {
    std::string text;
    for (int k = 0; k < 12; ++k) text += static_cast<char>(rng.index(256));
    write(d, {text, {10, 10}});
    CHECK(text_width(text, 10) >= 0);
    CHECK(text_width(fitted(text, 30, 10), 10) <= std::max(30.0, text_width("…", 10)) + 1e-9);
  }
  const auto svg = encode(d, Format::svg);
  REQUIRE(svg.ok());
  for (const char c : *svg) CHECK((static_cast<unsigned char>(c) >= 0x20 || c == '\n'));
  CHECK(encode(d, Format::png).ok());
  CHECK(encode(d, Format::pdf).ok());
}

TEST_CASE("text widths are proportional to the size") {
  CHECK(text_width("bookcase", 20) == doctest::Approx(2 * text_width("bookcase", 10)).epsilon(1e-12));
  CHECK(text_width("", 20) == 0);
  CHECK(text_width("wardrobe", 10, true) > text_width("wardrobe", 10));
}

TEST_CASE("an arc keeps to its circle") {
  Path path;
  path.arc({0, 0}, {1, 0}, {0, 1}, 0.3, 5.1);
  for (std::size_t i = 0; i < path.points.size(); i += 3)
    CHECK(length(path.points[i]) == doctest::Approx(1).epsilon(1e-12));
  // The middle of every piece.
  for (std::size_t i = 0; i + 3 < path.points.size(); i += 3) {
    const Vec2 m = 0.125 * (path.points[i] + 3 * path.points[i + 1] + 3 * path.points[i + 2] + path.points[i + 3]);
    CHECK(std::abs(length(m) - 1) < 3e-4);
  }
}

TEST_CASE("formats are found by extension") {
  CHECK(format_of("a/b.SVG") == Format::svg);
  CHECK(format_of("x.pdf") == Format::pdf);
  CHECK(format_of("x.png") == Format::png);
  CHECK_FALSE(format_of("png").has_value());
  CHECK_FALSE(format_of("x.jpg").has_value());
}
