#pragma once
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

/// For tests only: real files that do not belong to the project, and how much a build can do.
namespace inhabit::core {

/// Whether a sanitizer makes the build ten or more times slower. A large input may then be a smaller one, and a long
/// row of inputs a shorter one, where the test still sees the same property.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSlowBuild = true;
#else
inline constexpr bool kSlowBuild = false;
#endif

/// `relative` in the data folder: the environment variable INHABIT_DATA, or ../shared/data beside the source tree or
/// beside the folder that holds it. Nothing when it is not there; then say so and skip the test.
inline std::optional<std::filesystem::path> test_data(std::string_view relative, std::string_view source_dir) {
  namespace fs = std::filesystem;
  std::error_code error;
  const char* variable = std::getenv("INHABIT_DATA");
  const fs::path source(source_dir);
  for (const fs::path& root :
       {fs::path(variable != nullptr ? variable : ""), source / "../shared/data", source / "../../shared/data"}) {
    if (root.empty()) continue;
    const fs::path path = root / relative;
    if (fs::exists(path, error)) return path;
  }
  return std::nullopt;
}

}  // namespace inhabit::core

#ifdef INHABIT_SOURCE_DIR
/// The path of a real file, or std::nullopt with a message that the test is skipped. Requires: doctest is included.
#define INHABIT_TEST_DATA(relative)                                                                      \
  [&] {                                                                                                  \
    auto path = inhabit::core::test_data(relative, INHABIT_SOURCE_DIR);                                  \
    if (!path) MESSAGE("skipped: no ", std::string(relative), " in the data folder (set INHABIT_DATA)"); \
    return path;                                                                                         \
  }()
#endif
