#include "io/json_document.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/text.h"
#include "io/file.h"

namespace inhabit::io {
namespace {

/// `/` and `~` in a key, as RFC 6901 wants them.
void append_escaped(std::string& out, std::string_view key) {
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
}

/// The library's sentence without its own prefix and place, which stand in `where`.
std::string plain_message(std::string what) {
  for (const std::string_view mark : {"] ", ": "}) {
    if (const std::size_t at = what.find(mark); at != std::string::npos) what.erase(0, at + mark.size());
  }
  if (!is_utf8(what))
    std::ranges::replace_if(
        what, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
  if (what.size() > 300) what.resize(300), what += "...";
  return what;
}

}  // namespace

/// Receives the parser's events and lays the values down one after the other.
class JsonBuilder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  JsonBuilder(JsonDocument& document, std::string_view text, const JsonLimits& limits)
      : document_(document), text_(text), limits_(limits) {}

  bool null() { return leaf(Json::null, 0, {}); }
  bool boolean(bool value) { return leaf(Json::boolean, value ? 1 : 0, {}); }
  bool number_integer(number_integer_t value) { return integer(value); }
  bool number_unsigned(number_unsigned_t value) { return integer(value); }
  bool number_float(number_float_t value, const string_t& raw) { return leaf(Json::number, value, raw); }
  bool string(string_t& value) { return leaf(Json::text, 0, value); }
  bool binary(binary_t&) { return false; }
  bool key(string_t& name) {
    key_ = put(name);
    key_size_ = static_cast<std::uint32_t>(name.size());
    return true;
  }
  bool start_object(std::size_t) { return open(Json::object); }
  bool start_array(std::size_t) { return open(Json::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& e) {
    error = invalid(line_and_column(text_, position > 0 ? position - 1 : 0), plain_message(e.what()));
    return false;
  }

  std::optional<Error> error;

 private:
  std::uint32_t put(std::string_view text) {
    const auto at = static_cast<std::uint32_t>(document_.pool_.size());
    document_.pool_ += text;
    return at;
  }
  template <class T>
  bool integer(T value) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return leaf(Json::number, static_cast<double>(value), {digits, end});
  }
  bool add(Json kind) {
    if (document_.nodes_.size() >= limits_.values)
      return error = invalid("", "more than " + std::to_string(limits_.values) + " values"), false;
    if (!open_.empty()) ++document_.nodes_[open_.back()].size;
    JsonDocument::Node& node = document_.nodes_.emplace_back();
    node.kind = kind, node.key = key_, node.key_size = key_size_;
    key_size_ = 0;
    return true;
  }
  bool leaf(Json kind, double number, std::string_view text) {
    if (!add(kind)) return false;
    JsonDocument::Node& node = document_.nodes_.back();
    node.number = number, node.text = put(text), node.size = static_cast<std::uint32_t>(text.size());
    node.end = static_cast<std::uint32_t>(document_.nodes_.size());
    return true;
  }
  bool open(Json kind) {
    if (!add(kind)) return false;
    open_.push_back(static_cast<std::uint32_t>(document_.nodes_.size() - 1));
    if (static_cast<int>(open_.size()) <= limits_.depth) return true;
    const std::string where = document_.pointer(open_.back());
    error =
        invalid(where.size() <= 100 ? where : "", "nested deeper than " + std::to_string(limits_.depth) + " levels");
    return false;
  }
  bool close() {
    document_.nodes_[open_.back()].end = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  JsonDocument& document_;
  std::string_view text_;
  JsonLimits limits_;
  std::vector<std::uint32_t> open_;
  std::uint32_t key_ = 0, key_size_ = 0;
};

Result<JsonDocument> JsonDocument::parse(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes) return invalid("", "larger than " + std::to_string(limits.bytes >> 20) + " MiB");
  // The parser would take a zero byte for the end and never look at what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    return invalid(line_and_column(text, zero), "a zero byte");
  JsonDocument document;
  JsonBuilder builder(document, text, limits);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder) || builder.error)
    return builder.error.value_or(invalid("", "not JSON"));
  if (const Status keys = document.check_keys(); !keys) return keys.error();
  return document;
}

Status JsonDocument::check_keys() const {
  std::vector<std::pair<std::string_view, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].kind != Kind::object || nodes_[i].size < 2) continue;
    keys.clear();
    for (const Value member : Value(this, i)) keys.emplace_back(member.key(), static_cast<std::uint32_t>(keys.size()));
    std::ranges::sort(keys);
    const auto twice = std::ranges::adjacent_find(keys, {}, &std::pair<std::string_view, std::uint32_t>::first);
    if (twice == keys.end()) continue;
    std::string where = pointer(i);
    where += '/', append_escaped(where, twice->first);
    return invalid(std::move(where), "the key \"" + std::string(twice->first) + "\" appears twice in one object");
  }
  return Done{};
}

std::string JsonDocument::pointer(std::uint32_t target) const {
  std::string path;
  const auto end_of = [&](std::uint32_t i) {
    return nodes_[i].end != 0 ? nodes_[i].end : static_cast<std::uint32_t>(nodes_.size());
  };
  for (std::uint32_t i = 0; i != target;) {
    std::uint32_t child = i + 1;
    std::size_t place = 0;
    while (end_of(child) <= target) child = end_of(child), ++place;
    path += '/';
    if (nodes_[i].kind == Kind::array) {
      path += std::to_string(place);
    } else {
      append_escaped(path, Value(this, child).key());
    }
    i = child;
  }
  return path;
}

JsonValue JsonDocument::Value::find(std::string_view name) const {
  if (is(Kind::object)) {
    for (const Value member : *this) {
      if (member.key() == name) return member;
    }
  }
  return {nullptr, 0};
}

std::string_view name_of(Json kind) {
  switch (kind) {
    case Json::null:
      return "null";
    case Json::boolean:
      return "true or false";
    case Json::number:
      return "a number";
    case Json::text:
      return "a text";
    case Json::array:
      return "a list";
    case Json::object:
      return "an object";
  }
  return "";
}

}  // namespace inhabit::io
