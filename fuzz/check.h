#pragma once
#include <cstdlib>
#include <string_view>
#include <vector>

#include "io/formats/scene_json.h"

namespace inhabit::fuzz {

inline std::string_view text_of(const unsigned char* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Whatever a reader lets through must survive as a scene document: the crash that is looked for beside the obvious
/// ones.
inline void check_scene(const scene::Scene& scene) {
  const std::string text = io::write_scene(scene);
  const auto again = io::read_scene(text);
  if (!again.ok() || !(*again == scene) || io::write_scene(*again) != text) std::abort();
}

/// The same for everything that an importer made. Its rooms may be of any form; a scene document may refuse one only
/// for what it says about sizes, which importers pass on as they are.
inline void check_scenes(const core::Result<std::vector<scene::Scene>>& scenes) {
  if (!scenes.ok()) return;
  for (const scene::Scene& scene : *scenes) {
    const auto again = io::read_scene(io::write_scene(scene));
    if (!again.ok() && again.error().message.find("larger than the room") == std::string::npos) std::abort();
    if (again.ok() && !(*again == scene)) std::abort();
  }
}

}  // namespace inhabit::fuzz
