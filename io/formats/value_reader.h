#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/text.h"
#include "io/formats/scene_members.h"
#include "io/json_document.h"
#include "io/json_text.h"

/// The plain values of a scene document: numbers within their ranges, texts, choices, points and rings.
namespace inhabit::io {

/// Reads one value after the other; the first error ends it: every function returns false after one.
class ValueReader {
 public:
  std::optional<Error> error;

 protected:
  bool fail(JsonValue at, std::string message) {
    if (!error) error = at.error(std::move(message));
    return false;
  }
  bool hold(const Status& status) {
    if (!status && !error) error = status.error();
    return status.ok();
  }
  bool expect(JsonValue v, Json kind) {
    if (v.is(kind)) return true;
    return fail(v, "is " + std::string(name_of(v.kind())) + " where " + std::string(name_of(kind)) + " belongs");
  }

  template <class Names>
  static std::string joined(const Names& names) {
    std::string all;
    for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
    return all;
  }

  bool number(JsonValue v, double& out, const Spec& spec) {
    if (!expect(v, Json::number)) return false;
    const double low = file_bound(spec, spec.low), high = file_bound(spec, spec.high);
    if (!(v.number() >= low && v.number() <= high)) {
      const std::string_view unit = file_unit(spec);
      return fail(v, std::string(v.text().substr(0, 40)) + " is outside [" + number_text(low) + ", " +
                         number_text(high) + "]" + (unit.empty() ? "" : " " + std::string(unit)));
    }
    out = spec.unit == "rad" ? radians(std::round(v.number() * 1e9) / 1e9) : v.number();
    return true;
  }
  template <std::size_t N>
  bool numbers(JsonValue v, std::array<double, N>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    if (v.size() != N) return fail(v, "has " + std::to_string(v.size()) + " numbers instead of " + std::to_string(N));
    std::size_t i = 0;
    for (const JsonValue item : v) {
      if (!number(item, out[i++], spec)) return false;
    }
    return true;
  }
  bool choice(JsonValue v, int& out, const Spec& spec) {
    if (!expect(v, Json::text)) return false;
    const auto names = split_choices(spec.choices);
    const auto found = std::ranges::find(names, v.text());
    if (found == names.end()) {
      return fail(v, quoted(v.text()) + " is none of: " + joined(names) + did_you_mean(v.text(), names));
    }
    out = static_cast<int>(found - names.begin());
    return true;
  }

  bool read(JsonValue v, double& out, const Spec& spec) { return number(v, out, spec); }
  bool read(JsonValue v, bool& out, const Spec&) {
    if (!expect(v, Json::boolean)) return false;
    out = v.boolean();
    return true;
  }
  bool read(JsonValue v, int& out, const Spec& spec) {
    if (!spec.choices.empty()) return choice(v, out, spec);
    double value = 0;
    if (!number(v, value, spec)) return false;
    if (value != std::trunc(value)) return fail(v, std::string(v.text().substr(0, 40)) + " is no whole number");
    out = static_cast<int>(value);
    return true;
  }
  bool read(JsonValue v, std::uint64_t& out, const Spec&) {
    if (!expect(v, Json::number)) return false;
    const std::string_view digits = v.text();
    std::uint64_t value = 0;
    for (const char c : digits) {
      if (c < '0' || c > '9') return fail(v, "is no whole number from 0 to 18446744073709551615");
      value = value * 10 + static_cast<std::uint64_t>(c - '0');
    }
    // The parser keeps numbers beyond 64 bits as decimals with their text; they have 20 digits or more.
    if (digits.size() > 20 || (digits.size() == 20 && std::to_string(value) != digits))
      return fail(v, "is no whole number from 0 to 18446744073709551615");
    out = value;
    return true;
  }
  bool read(JsonValue v, std::string& out, const Spec& spec) {
    if (!expect(v, Json::text)) return false;
    if (spec.required && v.text().empty()) return fail(v, "is empty");
    out = v.text();
    return true;
  }
  template <class E>
  requires std::is_enum_v<E>
  bool read(JsonValue v, E& out, const Spec& spec) {
    int index = 0;
    if (!choice(v, index, spec)) return false;
    out = static_cast<E>(index);
    return true;
  }
  bool read(JsonValue v, Vec2& out, const Spec& spec) {
    std::array<double, 2> a{};
    if (!numbers(v, a, spec)) return false;
    out = {a[0], a[1]};
    return true;
  }
  bool read(JsonValue v, Vec3& out, const Spec& spec) {
    std::array<double, 3> a{};
    if (!numbers(v, a, spec)) return false;
    out = {a[0], a[1], a[2]};
    return true;
  }
  bool read(JsonValue v, Ring& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    out.reserve(v.size());
    for (const JsonValue corner : v) {
      if (!read(corner, out.emplace_back(), spec)) return false;
    }
    if (const auto why = why_not_simple(out)) return fail(v, *why);
    ring_turned_ = signed_area(out) < 0;
    if (ring_turned_) std::reverse(out.begin() + 1, out.end());
    return true;
  }
  bool read(JsonValue v, Span& out, const Spec& spec) {
    if (v.is(Json::number)) return number(v, out.low, spec) && number(v, out.high, spec);
    if (!v.is(Json::array)) return fail(v, "is neither a number nor [low, high]");
    std::array<double, 2> ends{};
    if (!numbers(v, ends, spec)) return false;
    out = {ends[0], ends[1]};
    return out.low <= out.high || fail(v, "begins with the larger number");
  }
  bool ring_turned_ = false;  ///< the last ring was clockwise
};

}  // namespace inhabit::io
