#pragma once
#include <optional>
#include <string>

#include "session/document.h"

namespace inhabit::session {

/// A built-in scene, those of the papers made to measure; what is absent stays as the paper has it.
struct ScenesJob {
  std::string name;
  std::optional<int> seats;           ///< theater-1
  std::optional<double> coverage;     ///< tight-bedroom, share of the floor
  std::optional<std::uint64_t> seed;  ///< tight-picnic: the counts
};
/// The scene's document. Errors: no such scene, a measure that the scene does not have.
Result<std::string> scenes_job(const ScenesJob& job);

/// Every built-in scene, furnished or full of people, with its counts and published times, for people and as JSON.
std::string scenes_text();
std::string scenes_json();

}  // namespace inhabit::session
