#include "io/formats/study.h"

#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text = inhabit::fuzz::text_of(data, size);
  (void)inhabit::io::read_study_plan(text).ok();
  const auto answers = inhabit::io::read_study_data(text);
  if (!answers.ok()) return 0;
  const std::string written = inhabit::io::write_study_data(*answers);
  const auto again = inhabit::io::read_study_data(written);
  if (!again.ok() || !(*again == *answers) || inhabit::io::write_study_data(*again) != written) std::abort();
  return 0;
}
