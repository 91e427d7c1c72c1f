#pragma once
#include <span>
#include <string>
#include <string_view>

namespace inhabit::core {

/// The candidate with the smallest edit distance to `word`, or "" when none is nearer than half of the word's length.
std::string nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// `; did you mean "…"?`, or nothing when no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// The shortest decimal text that reads back as the same double; integers without a point.
std::string shortest(double value);

/// Decimal text with `digits` places behind the point, independent of the locale.
std::string fixed(double value, int digits);

/// True when the bytes are well-formed UTF-8.
bool is_utf8(std::string_view bytes);

}  // namespace inhabit::core
