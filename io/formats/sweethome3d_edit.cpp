#include "io/formats/sweethome3d_edit.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace inhabit::io::sh3d {
namespace {

constexpr bool space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
constexpr bool ends_name(char c) { return space(c) || c == '=' || c == '>' || c == '/'; }

/// Bytes of an attribute in a start tag: from the space before its name, and of its value inside the quotes.
struct Span {
  std::size_t begin = 0, end = 0, value_begin = 0, value_end = 0;
};

/// A start tag that has been parsed once, so that it is known to be well formed.
struct Tag {
  std::string_view xml;
  std::size_t element = 0;

  std::size_t name_end() const {
    std::size_t at = element;
    while (at < xml.size() && !ends_name(xml[at])) ++at;
    return at;
  }

  /// Calls visit(name, span) for every attribute until it says true; returns the place of the closing `>` or `/>`.
  template <class Visit>
  std::size_t each(Visit visit) const {
    std::size_t at = name_end();
    while (at < xml.size()) {
      Span span;
      span.begin = at;
      while (at < xml.size() && space(xml[at])) ++at;
      if (at >= xml.size() || xml[at] == '>' || xml[at] == '/') return at;
      const std::size_t name = at;
      while (at < xml.size() && !ends_name(xml[at])) ++at;
      const std::string_view attribute = xml.substr(name, at - name);
      at = xml.find_first_of("'\"", at);
      if (at == std::string_view::npos) return xml.size();
      const std::size_t close = xml.find(xml[at], at + 1);
      if (close == std::string_view::npos) return xml.size();
      span.value_begin = at + 1;
      span.value_end = close;
      at = span.end = close + 1;
      if (visit(attribute, span)) return at;
    }
    return at;
  }

  std::optional<Span> find(std::string_view name) const {
    std::optional<Span> found;
    each([&](std::string_view attribute, const Span& span) {
      if (attribute == name) found = span;
      return found.has_value();
    });
    return found;
  }

  /// The byte behind the whole element, which holds no element of its own name.
  std::size_t element_end() const {
    const std::size_t close = each([](std::string_view, const Span&) { return false; });
    if (close + 1 < xml.size() && xml[close] == '/') return close + 2;
    const std::string end = std::string("</").append(xml.substr(element, name_end() - element));
    const std::size_t last = xml.find(end, close);
    const std::size_t bracket = last == std::string_view::npos ? last : xml.find('>', last);
    return bracket == std::string_view::npos ? xml.size() : bracket + 1;
  }
};

/// Entry names are sometimes written as parts of a URL.
std::string percent_decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    if (text[i] == '%' && i + 2 < text.size() + 0 &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16).ptr == text.data() + i + 3) {
      out += static_cast<char>(value);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool is_url(std::string_view text) {
  return text.starts_with("jar:") || text.starts_with("file:") || text.starts_with("http:") ||
         text.starts_with("https:");
}

}  // namespace

std::string edited(std::string_view xml, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.offset < b.offset; });
  std::string out;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    if (edit.offset < at) continue;  // inside something removed
    out.append(xml.substr(at, edit.offset - at)).append(edit.text);
    at = edit.offset + edit.length;
  }
  return out.append(xml.substr(at));
}

Edit set_attribute(std::string_view xml, std::size_t element, std::string_view name, std::string_view value) {
  const Tag tag{xml, element};
  if (const auto span = tag.find(name))
    return {span->value_begin, span->value_end - span->value_begin, std::string(value)};
  std::string text(" ");
  text.append(name).append("='").append(value).append("'");
  return {tag.name_end(), 0, text};
}

Stripped strip_missing(std::string_view xml, const pugi::xml_document& document, const std::set<std::string>& entries) {
  struct Walker : pugi::xml_tree_walker {
    std::string_view xml;
    const std::set<std::string>* entries = nullptr;
    Stripped out;
    bool missing(const pugi::xml_attribute& a) const {
      return a && !is_url(a.value()) && entries->count(a.value()) == 0 &&
             entries->count(percent_decoded(a.value())) == 0;
    }
    bool for_each(pugi::xml_node& node) override {
      if (node.type() != pugi::node_element) return true;
      const Tag tag{xml, static_cast<std::size_t>(node.offset_debug())};
      const std::string_view name = node.name();
      if (missing(node.attribute("image"))) {
        ++out.images;
        if (name == "texture" || name == "backgroundImage") {
          out.edits.push_back({tag.element - 1, tag.element_end() - (tag.element - 1), ""});
          return true;
        }
      }
      for (const char* attribute : {"model", "icon", "planIcon", "image"}) {
        if (!missing(node.attribute(attribute))) continue;
        if (std::string_view(attribute) == "model") ++out.models;
        if (std::string_view(attribute).ends_with("con")) ++out.icons;
        if (const auto span = tag.find(attribute)) out.edits.push_back({span->begin, span->end - span->begin, ""});
      }
      return true;
    }
  } walker;
  walker.xml = xml;
  walker.entries = &entries;
  const_cast<pugi::xml_document&>(document).traverse(walker);
  return std::move(walker.out);
}

std::string float_text(double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value)).ptr;
  return {buffer, end};
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '\'')
      out += "&apos;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
    else
      out += ' ';
  }
  return out;
}

}  // namespace inhabit::io::sh3d
