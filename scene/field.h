#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/core.h"
#include "geometry/polygon.h"

namespace inhabit::scene {
using namespace core;
using namespace geometry;

/// What a constraint or an object may point at. Objects and groups are both particles of the solver.
struct Ref {
  enum class Kind : std::uint8_t { none, object, group, door };
  Kind kind = Kind::none;
  std::uint32_t index = 0;
  constexpr bool none() const { return kind == Kind::none; }
  friend constexpr bool operator==(const Ref&, const Ref&) = default;
};

/// A list of objects and groups, or (`all_of` set) every member of one group. In a file: an array of ids, or one
/// group's id.
struct Members {
  std::vector<Ref> list;
  Ref all_of;
  bool empty() const { return list.empty() && all_of.none(); }
  friend bool operator==(const Members&, const Members&) = default;
};

/// A user's own `x-…` member, kept as JSON text.
using Extras = std::vector<std::pair<std::string, std::string>>;

/// A choice by name; the names stand in the field's `choices`, the value is their index.
using Choice = int;

/// One member of a kind, described once: from these descriptions come JSON reading and writing, the JSON Schema, the
/// reference page and the property tests. Angles are radians here and degrees in files: the unit "rad" says so.
template <class T>
struct Field {
  std::string_view name;
  std::variant<double T::*, std::optional<double> T::*, bool T::*, Choice T::*, std::optional<int> T::*, Ref T::*,
               std::array<Ref, 2> T::*, Members T::*, Vec2 T::*, Ring T::*>
      member;
  std::string_view help;
  /// "m", "rad", "" for a pure number.
  std::string_view unit = "";
  double low = -1e6, high = 1e6;
  bool required = false;
  /// What a Choice may be, separated by `|`: "box|sphere|off".
  std::string_view choices = "";
};

/// True when two constraints say the same, member for member.
template <class T>
bool same_fields(const T& a, const T& b) {
  for (const auto& field : T::kFields) {
    if (!std::visit([&](auto member) { return a.*member == b.*member; }, field.member)) return false;
  }
  return true;
}

}  // namespace inhabit::scene
