#pragma once
#include "session/bench.h"

namespace inhabit::session {

struct BenchAnswer {
  std::vector<Table> tables;  ///< the machine first
  std::vector<BenchCurve> curves;
  std::vector<BenchSheet> sheets;
};
/// The groups called `groups`, all when empty; `layout` means all. Errors name the nearest group.
Result<BenchAnswer> bench_job(const std::vector<std::string>& groups, const BenchOptions& options);
std::string bench_text(const BenchAnswer& answer);
std::string bench_json(const BenchAnswer& answer);
/// "name  sentence" per line.
std::string bench_group_lines();

}  // namespace inhabit::session
