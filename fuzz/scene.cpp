#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto scene = inhabit::io::read_scene(inhabit::fuzz::text_of(data, size));
  if (scene.ok()) inhabit::fuzz::check_scene(*scene);
  return 0;
}
