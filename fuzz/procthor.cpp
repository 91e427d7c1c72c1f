#include "io/formats/procthor.h"

#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace inhabit;
  const std::string_view text = fuzz::text_of(data, size);
  static const io::Assets assets = {{"A", {{1, 0.5, 0.8}, "tv_stand"}}, {"B", {{0.1, 0.1, 0.1}, "cup"}}};
  fuzz::check_scenes(io::read_procthor(text, assets));
  (void)io::read_procthor_assets(text).ok();
  return 0;
}
