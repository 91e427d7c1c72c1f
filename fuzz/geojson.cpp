#include "io/formats/geojson.h"

#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  inhabit::fuzz::check_scenes(inhabit::io::read_geojson(inhabit::fuzz::text_of(data, size)));
  return 0;
}
