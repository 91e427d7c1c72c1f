#include <charconv>

#include "render/encode.h"

namespace inhabit::render {
namespace {

/// At most two decimals: a hundredth of a point is a three-hundredth of a millimetre on paper.
void number(std::string& out, double value) {
  char buffer[48];
  value = std::clamp(value, -1e9, 1e9);
  auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2).ptr;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  out += text == "-0" ? "0" : text;
}

void point(std::string& out, Vec2 p) {
  number(out, p.x);
  out += ' ';
  number(out, p.y);
}

void escaped(std::string& out, std::string_view text) {
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
}

void paint(std::string& out, std::string_view what, const std::optional<Color>& color) {
  out.append(" ").append(what).append("=\"");
  if (!color) {
    out += "none\"";
    return;
  }
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '#';
  for (const std::uint8_t v : {color->r, color->g, color->b}) out += kHex[v >> 4], out += kHex[v & 15];
  out += '"';
  if (color->alpha < 1) {
    out.append(" ").append(what).append("-opacity=\"");
    number(out, color->alpha);
    out += '"';
  }
}

void attribute(std::string& out, std::string_view name, double value) {
  out.append(" ").append(name).append("=\"");
  number(out, value);
  out += '"';
}

void shape(std::string& out, const Shape& s) {
  out += "<path d=\"";
  const Vec2* p = s.path.points.data();
  for (const Path::Verb verb : s.path.verbs) {
    switch (verb) {
      case Path::Verb::move:
        out += 'M', point(out, *p++);
        break;
      case Path::Verb::line:
        out += 'L', point(out, *p++);
        break;
      case Path::Verb::curve:
        out += 'C';
        for (int i = 0; i < 3; ++i) {
          if (i > 0) out += ' ';
          point(out, *p++);
        }
        break;
      case Path::Verb::close:
        out += 'Z';
        break;
    }
  }
  out += '"';
  paint(out, "fill", s.style.fill);
  if (s.style.fill && s.style.even_odd) out += " fill-rule=\"evenodd\"";
  if (s.style.stroke) {
    paint(out, "stroke", s.style.stroke);
    attribute(out, "stroke-width", s.style.width);
    if (s.style.round) out += " stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    if (s.style.dash > 0) {
      out += " stroke-dasharray=\"";
      point(out, {s.style.dash, s.style.gap});
      out += '"';
    }
  }
  out += "/>\n";
}

void text(std::string& out, const Text& t) {
  constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  out += "<text";
  attribute(out, "x", t.at.x);
  attribute(out, "y", t.at.y);
  attribute(out, "font-size", t.size);
  // The measured width, so that another font on the reader's machine takes no more room than was kept for this one.
  attribute(out, "textLength", text_width(t.text, t.size, t.bold));
  out += " lengthAdjust=\"spacingAndGlyphs\"";
  if (t.anchor != Anchor::start)
    out.append(" text-anchor=\"").append(kAnchors[static_cast<int>(t.anchor)]).append("\"");
  if (t.bold) out += " font-weight=\"bold\"";
  if (t.angle != 0) {
    out += " transform=\"rotate(";
    number(out, degrees(t.angle));
    out += ' ';
    point(out, t.at);
    out += ")\"";
  }
  paint(out, "fill", t.color);
  out += '>';
  escaped(out, t.text);
  out += "</text>\n";
}

}  // namespace

std::string encode_svg(const Drawing& drawing) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
  attribute(out, "width", drawing.size.x);
  attribute(out, "height", drawing.size.y);
  out += " viewBox=\"0 0 ";
  point(out, drawing.size);
  out += "\" font-family=\"DejaVu Sans, Verdana, Helvetica, sans-serif\">\n";
  if (!drawing.title.empty()) {
    out += "<title>";
    escaped(out, printable(drawing.title));
    out += "</title>\n";
  }
  if (drawing.background.alpha > 0) {
    out += "<rect width=\"100%\" height=\"100%\"";
    paint(out, "fill", drawing.background);
    out += "/>\n";
  }
  for (const auto& item : drawing.items) {
    if (const auto* s = std::get_if<Shape>(&item))
      shape(out, *s);
    else
      text(out, std::get<Text>(item));
  }
  out += "</svg>\n";
  return out;
}

}  // namespace inhabit::render
