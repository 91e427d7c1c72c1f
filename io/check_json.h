#pragma once
#include <string>

#include "layout/check.h"

namespace inhabit::io {

/// One JSON object, the keys in the order of the scene reference; an infinite depth (a missing object) is null. Bytes
/// of ids that are no UTF-8 are replaced.
std::string check_json(const layout::CheckReport& report);

/// The same for people: a verdict per question, the worst offenders first (at most ten of each), and what to do.
std::string check_table(const layout::CheckReport& report);

}  // namespace inhabit::io
