#include "io/formats/sweethome3d.h"

#include <cstddef>
#include <cstdint>
#include <string>

/// Bytes as a home: the zip archive or Home.xml alone. What opens must become rooms and be written back.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto home = inhabit::io::open_sh3d(std::string(reinterpret_cast<const char*>(data), size));
  if (!home) return 0;
  const auto scenes = inhabit::io::rooms(*home);
  if (scenes) static_cast<void>(inhabit::io::write_sh3d(*home, *scenes));
  return 0;
}
