#include "session/bench_job.h"

#include <algorithm>

#include "core/text.h"

namespace inhabit::session {

Result<BenchAnswer> bench_job(const std::vector<std::string>& groups, const BenchOptions& options) {
  const std::vector<BenchGroupRow> known = bench_groups();
  std::vector<BenchGroupRow> chosen;
  for (const std::string& name : groups) {
    if (name == "layout") continue;
    const auto row = std::find_if(known.begin(), known.end(), [&](const BenchGroupRow& r) { return r.name == name; });
    if (row == known.end()) {
      std::vector<std::string_view> names = {"layout"};
      for (const BenchGroupRow& r : known) names.push_back(r.name);
      return invalid("", "no group called " + name + did_you_mean(name, names));
    }
    chosen.push_back(*row);
  }
  if (chosen.empty()) {
    // Real rooms only where there are some.
    for (const BenchGroupRow& row : known)
      if (row.subject == BenchGroupRow::layout &&
          ((row.name != "rooms" && row.name != "learned") || !options.data.empty()))
        chosen.push_back(row);
  }
  BenchAnswer answer;
  answer.tables.push_back(machine_table());
  for (const BenchGroupRow& row : chosen) {
    Result<BenchGroup> group = row.run(options);
    if (!group) return group.error();
    std::move(group->tables.begin(), group->tables.end(), std::back_inserter(answer.tables));
    std::move(group->curves.begin(), group->curves.end(), std::back_inserter(answer.curves));
    std::move(group->sheets.begin(), group->sheets.end(), std::back_inserter(answer.sheets));
    if (options.cancel && options.cancel->requested()) break;
  }
  return answer;
}

std::string bench_text(const BenchAnswer& answer) {
  std::string text;
  for (const Table& table : answer.tables) {
    if (!text.empty()) text += '\n';
    text += table_text(table);
  }
  return text;
}

std::string bench_json(const BenchAnswer& answer) {
  std::string json = "{\"tables\": [";
  for (std::size_t i = 0; i < answer.tables.size(); ++i) {
    if (i > 0) json += ", ";
    json += table_json(answer.tables[i]);
  }
  json += "]}\n";
  return json;
}

std::string bench_group_lines() {
  std::string lines;
  for (const BenchGroupRow& row : bench_groups()) {
    std::string name(row.name);
    name.resize(12, ' ');
    lines += "  " + name + std::string(row.sentence) + "\n";
  }
  return lines;
}

}  // namespace inhabit::session
