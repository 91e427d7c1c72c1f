#include "io/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"

namespace inhabit::io {
namespace {

constexpr std::size_t kColumns = 110;

/// Appends `value` on one line; gives up (false) beyond `limit` bytes of `out`.
bool append_flat(std::string& out, JsonValue value, std::size_t limit) {
  if (out.size() > limit) return false;
  switch (value.kind()) {
    case Json::null:
      out += "null";
      break;
    case Json::boolean:
      out += value.boolean() ? "true" : "false";
      break;
    case Json::number:
      out += value.text();
      break;
    case Json::text:
      append_quoted(out, value.text());
      break;
    case Json::array:
    case Json::object: {
      const bool object = value.is(Json::object);
      out += object ? '{' : '[';
      bool first = true;
      for (const JsonValue child : value) {
        if (!first) out += ", ";
        first = false;
        if (object) append_quoted(out, child.key()), out += ": ";
        if (!append_flat(out, child, limit)) return false;
      }
      out += object ? '}' : ']';
    }
  }
  return out.size() <= limit;
}

bool is_leaf(JsonValue value) { return !value.is(Json::array) && !value.is(Json::object); }

/// Lists that read best as running text: numbers, names, points.
bool is_running(JsonValue list) {
  return std::all_of(list.begin(), list.end(), [](JsonValue item) {
    return is_leaf(item) || (item.is(Json::array) && std::all_of(item.begin(), item.end(), is_leaf));
  });
}

void append_pretty(std::string& out, JsonValue value, std::size_t indent);

void append_running(std::string& out, JsonValue list, std::size_t indent) {
  std::size_t start = out.size() - indent;
  bool first = true;
  for (const JsonValue item : list) {
    std::string text;
    append_flat(text, item, std::string::npos);
    if (!first) out += ',';
    if (first || out.size() - start + text.size() + 2 > kColumns) {
      out += '\n', start = out.size(), out.append(indent, ' ');
    } else {
      out += ' ';
    }
    first = false;
    out += text;
  }
}

void append_broken(std::string& out, JsonValue value, std::size_t indent) {
  const bool object = value.is(Json::object);
  out += object ? '{' : '[';
  if (!object && is_running(value)) {
    append_running(out, value, indent + 2);
  } else {
    bool first = true;
    for (const JsonValue child : value) {
      if (!first) out += ',';
      first = false;
      out += '\n', out.append(indent + 2, ' ');
      if (object) append_quoted(out, child.key()), out += ": ";
      append_pretty(out, child, indent + 2);
    }
  }
  out += '\n', out.append(indent, ' ');
  out += object ? '}' : ']';
}

void append_pretty(std::string& out, JsonValue value, std::size_t indent) {
  // Lines may be as long as is still readable; the name before the value counts, what stands before that does not.
  const std::size_t line = out.rfind('\n') == std::string::npos ? 0 : out.rfind('\n') + 1;
  const std::size_t before = out.size(), limit = is_leaf(value) ? std::string::npos : line + kColumns;
  if (append_flat(out, value, limit)) return;
  out.resize(before);
  append_broken(out, value, indent);
}

}  // namespace

void append_quoted(std::string& out, std::string_view text) {
  const bool plain = std::ranges::all_of(text, [](char c) { return c >= ' ' && c != '"' && c != '\\' && c != 0x7f; });
  if (plain) {
    out += '"', out += text, out += '"';
  } else {
    out += nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
}

std::string quoted(std::string_view text) {
  std::string out;
  append_quoted(out, text.substr(0, 80));
  return out;
}

void append_number(std::string& out, double value) { out += number_text(value); }

std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-6 || size >= 1e15) return shortest(value);
  char digits[64];
  return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed).ptr};
}

std::string flat_json(JsonValue value) {
  std::string out;
  append_flat(out, value, std::string::npos);
  return out;
}

std::string pretty_json(JsonValue value) {
  std::string out;
  // The outermost value is always broken up, as people expect of a document.
  if (is_leaf(value) || value.size() == 0) {
    append_flat(out, value, std::string::npos);
  } else {
    append_broken(out, value, 0);
  }
  return out += '\n';
}

std::string pretty_json(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  return document ? pretty_json(document->root()) : std::string(text);
}

}  // namespace inhabit::io
