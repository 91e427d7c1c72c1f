#include <cairo-pdf.h>
#include <cairo.h>

#include <memory>

#include "render/encode.h"

namespace inhabit::render {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Face = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;
using FontOptions = std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)>;
using ScaledFont = std::unique_ptr<cairo_scaled_font_t, decltype(&cairo_scaled_font_destroy)>;

Face face(bool bold) {
  return {cairo_toy_font_face_create("DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                                     bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL),
          cairo_font_face_destroy};
}

/// Without hinting, text is as wide on every page and at every scale.
FontOptions unhinted() {
  FontOptions options(cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  return options;
}

void source(cairo_t* c, Color color) {
  cairo_set_source_rgba(c, color.r / 255.0, color.g / 255.0, color.b / 255.0, color.alpha);
}

void draw(cairo_t* c, const Shape& s) {
  const Vec2* p = s.path.points.data();
  cairo_new_path(c);
  for (const Path::Verb verb : s.path.verbs) {
    switch (verb) {
      case Path::Verb::move:
        cairo_move_to(c, p->x, p->y), ++p;
        break;
      case Path::Verb::line:
        cairo_line_to(c, p->x, p->y), ++p;
        break;
      case Path::Verb::curve:
        cairo_curve_to(c, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y), p += 3;
        break;
      case Path::Verb::close:
        cairo_close_path(c);
        break;
    }
  }
  if (s.style.fill) {
    source(c, *s.style.fill);
    cairo_set_fill_rule(c, s.style.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
    cairo_fill_preserve(c);
  }
  if (!s.style.stroke) return;
  source(c, *s.style.stroke);
  cairo_set_line_width(c, s.style.width);
  cairo_set_line_cap(c, s.style.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(c, s.style.round ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
  cairo_set_miter_limit(c, 4);  // as in SVG
  const double dashes[] = {s.style.dash, s.style.gap};
  cairo_set_dash(c, dashes, s.style.dash > 0 ? 2 : 0, 0);
  cairo_stroke_preserve(c);
}

void draw(cairo_t* c, const Text& t) {
  const Face f = face(t.bold);
  cairo_save(c);
  cairo_set_font_face(c, f.get());
  cairo_set_font_size(c, t.size);
  cairo_translate(c, t.at.x, t.at.y);
  if (t.angle != 0) cairo_rotate(c, t.angle);
  const double width = t.anchor == Anchor::start ? 0 : text_width(t.text, t.size, t.bold);
  cairo_move_to(c, t.anchor == Anchor::middle ? -width / 2 : -width, 0);
  source(c, t.color);
  cairo_show_text(c, t.text.c_str());
  cairo_restore(c);
}

/// Draws everything; the surface's state when that is no success.
cairo_status_t play(cairo_surface_t* surface, const Drawing& drawing, double scale) {
  const Context context(cairo_create(surface), cairo_destroy);
  cairo_t* c = context.get();
  const FontOptions options = unhinted();
  cairo_set_font_options(c, options.get());
  cairo_scale(c, scale, scale);
  if (drawing.background.alpha > 0) {
    source(c, drawing.background);
    cairo_paint(c);
  }
  for (const auto& item : drawing.items) {
    if (const auto* shape = std::get_if<Shape>(&item))
      draw(c, *shape);
    else
      draw(c, std::get<Text>(item));
  }
  return cairo_status(c);
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Result<std::string> failed(cairo_status_t status) {
  return Error{ErrorCode::io, cairo_status_to_string(status), "picture"};
}

Result<std::string> encode_png(const Drawing& drawing, int long_side) {
  const double scale = long_side / std::max(drawing.size.x, drawing.size.y);
  const auto pixels = [&](double v) { return std::max(1, static_cast<int>(std::lround(scale * v))); };
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels(drawing.size.x), pixels(drawing.size.y)),
                        cairo_surface_destroy);
  std::string bytes;
  cairo_status_t status = play(surface.get(), drawing, scale);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) return failed(status);
  return bytes;
}

Result<std::string> encode_pdf(const Drawing& drawing) {
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, drawing.size.x, drawing.size.y),
                        cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "inhabit");
  if (!drawing.title.empty())
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, printable(drawing.title).c_str());
  const cairo_status_t status = play(surface.get(), drawing, 1);
  cairo_surface_finish(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) return failed(status);
  return bytes;
}

}  // namespace

Result<Pixels> rasterize(const Drawing& drawing, int width, const Pixels* under) {
  const double scale = width / drawing.size.x, tall = scale * drawing.size.y;
  if (!(width >= 1 && width <= 16384 && tall >= 0.5 && tall < 16384.5))
    return invalid("picture", "both sides must have 1 to 16384 pixels");
  Pixels pixels{width, static_cast<int>(std::lround(tall)), {}};
  const std::size_t row = 4 * static_cast<std::size_t>(width), size = row * static_cast<std::size_t>(pixels.height);
  INHABIT_ASSERT(!under || under->bytes.size() == size);
  if (under)
    pixels.bytes = under->bytes;
  else
    pixels.bytes.assign(size, 0xff);
  // RGB24 lies in memory as blue, green, red, unused on the little-endian machines that we run on.
  const Surface surface(cairo_image_surface_create_for_data(pixels.bytes.data(), CAIRO_FORMAT_RGB24, width,
                                                            pixels.height, static_cast<int>(row)),
                        cairo_surface_destroy);
  const cairo_status_t status = play(surface.get(), drawing, scale);
  cairo_surface_finish(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) return Error{ErrorCode::io, cairo_status_to_string(status), "picture"};
  return pixels;
}

Result<std::string> encode_png(const Pixels& pixels) {
  std::vector<std::uint8_t> bytes = pixels.bytes;
  const Surface surface(cairo_image_surface_create_for_data(bytes.data(), CAIRO_FORMAT_RGB24, pixels.width,
                                                            pixels.height, 4 * pixels.width),
                        cairo_surface_destroy);
  std::string file;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &file);
  if (status != CAIRO_STATUS_SUCCESS) return failed(status);
  return file;
}

double text_width(std::string_view text, double size, bool bold) {
  // Measured at a fixed size and scaled: cairo keeps one font instead of one for every size.
  constexpr double kSize = 100;
  cairo_matrix_t font, identity;
  cairo_matrix_init_scale(&font, kSize, kSize);
  cairo_matrix_init_identity(&identity);
  const Face f = face(bold);
  const FontOptions options = unhinted();
  const ScaledFont scaled(cairo_scaled_font_create(f.get(), &font, &identity, options.get()),
                          cairo_scaled_font_destroy);
  cairo_text_extents_t extents{};
  cairo_scaled_font_text_extents(scaled.get(), printable(text).c_str(), &extents);
  return extents.x_advance * size / kSize;
}

Result<std::string> encode(const Drawing& drawing, Format format, const EncodeOptions& options) {
  const auto usable = [](double v) { return v > 0 && v < 1e6; };
  if (!usable(drawing.size.x) || !usable(drawing.size.y)) return invalid("picture", "the page has no usable size");
  if (format == Format::svg) return encode_svg(drawing);
  if (format == Format::pdf) return encode_pdf(drawing);
  if (options.png_long_side < 16 || options.png_long_side > 16384)
    return invalid("picture",
                   "the long side must have 16 to 16384 pixels, not " + std::to_string(options.png_long_side));
  return encode_png(drawing, options.png_long_side);
}

}  // namespace inhabit::render
