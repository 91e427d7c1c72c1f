#include "fuzz/check.h"
#include "io/formats/priors_json.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto priors = inhabit::io::read_priors(inhabit::fuzz::text_of(data, size));
  if (!priors.ok()) return 0;
  const std::string text = inhabit::io::write_priors(*priors);
  const auto again = inhabit::io::read_priors(text);
  if (!again.ok() || !(*again == *priors) || inhabit::io::write_priors(*again) != text) std::abort();
  return 0;
}
