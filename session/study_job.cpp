#include "session/study_job.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/text.h"
#include "io/file.h"
#include "io/formats/study.h"

namespace inhabit::session {
namespace {

constexpr int kMostChoices = 100'000'000;

/// Everybody once, in order of id.
Result<std::vector<const StudyParticipant*>> people_of(std::span<const StudyFile> files) {
  std::map<std::string_view, const StudyParticipant*> people;
  std::string_view study;
  bool any = false;
  for (const StudyFile& file : files) {
    if (file.data.participants.empty()) continue;
    if (any && study != file.data.study)
      return invalid(file.name, "answers another study's page than the files before");
    study = file.data.study, any = true;
    for (const StudyParticipant& person : file.data.participants) {
      const auto [at, fresh] = people.emplace(person.id, &person);
      if (fresh) continue;
      const std::vector<StudyAnswer>&a = at->second->answers, &b = person.answers;
      if (!std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), b.size())), b.begin()))
        return invalid(file.name, "participant " + person.id + " answered differently in a file before");
      if (b.size() > a.size()) at->second = &person;
    }
  }
  std::vector<const StudyParticipant*> list;
  for (const auto& [id, person] : people) list.push_back(person);
  return list;
}

using Names = std::pair<std::string, std::string>;

/// Adds up what everybody chose and looks for what a person who reads the counts should know.
void count_answers(const std::vector<const StudyParticipant*>& people, StudyReport& report,
                   std::map<Names, StudyCount>& counts) {
  std::vector<double> seconds;
  std::map<Names, int> shown_left;
  for (const StudyParticipant* person : people) {
    std::map<Names, std::array<int, 4>> seen;  // human design left, right; it was chosen then
    for (const StudyAnswer& answer : person->answers) {
      const Names names{answer.scene, answer.synthesis};
      StudyCount& count = counts[names];
      count.scene = answer.scene, count.synthesis = answer.synthesis;
      ++count.of, count.human += answer.chose_human() ? 1 : 0;
      ++report.answers, report.left += answer.chosen == Side::left ? 1 : 0;
      seconds.push_back(answer.seconds);
      const std::size_t side = answer.human == Side::left ? 0 : 1;
      shown_left[names] += side == 0 ? 1 : -1;
      ++seen[names][side], seen[names][2 + side] += answer.chose_human() ? 1 : 0;
    }
    for (const auto& [names, s] : seen)
      if (s[0] == 1 && s[1] == 1) ++report.twice, report.alike += s[2] == s[3] ? 1 : 0;
  }
  report.participants = static_cast<int>(people.size());
  report.median_seconds = median(std::move(seconds));
  const auto uneven = std::ranges::count_if(shown_left, [](const auto& entry) { return entry.second != 0; });
  if (uneven > 0)
    report.notes.push_back(std::to_string(uneven) + " of " + std::to_string(shown_left.size()) +
                           " pairs did not stand equally often on both sides: somebody stopped early");
}

StudyRow row_of(StudyCount count, bool as_paper) {
  StudyRow row;
  row.chi_square = as_paper ? chi_square_of_paper(count.human, count.of) : chi_square(count.human, count.of);
  row.p = chi_square_p(row.chi_square);
  row.coin_p = coin_p(count.human, count.of);
  row.odds = odds_for_chance(count.human, count.of);
  row.evidence = evidence_of(row.odds);
  row.count = std::move(count);
  return row;
}

const char* words_of(const StudyRow& row) {
  if (row.evidence == Evidence::no_difference) return "no difference";
  if (row.evidence == Evidence::inconclusive) return "inconclusive";
  return 2 * row.count.human > row.count.of ? "human preferred" : "synthesis preferred";
}

Table people_table(const StudyReport& r) {
  Table table{"people", "Participants", {}, {}, {}};
  table.columns = {{"participants", 0},     {"answers", 0},        {"chose left", 0},    {"p of a coin", 3},
                   {"pairs seen twice", 0}, {"answered alike", 0}, {"median seconds", 1}};
  table.rows.push_back({static_cast<double>(r.participants), static_cast<double>(r.answers),
                        static_cast<double>(r.left), coin_p(r.left, r.answers), static_cast<double>(r.twice),
                        static_cast<double>(r.alike), r.median_seconds});
  return table;
}

Table pair_table(const StudyReport& r) {
  Table table{"pairs", "How often the human design was chosen", {}, {}, {}};
  table.columns = {{"scene"},   {"synthesis"}, {"human", 0},       {"of", 0},   {"share %", 0},
                   {"chi2", 3}, {"p", 3},      {"p of a coin", 3}, {"odds", 3}, {"evidence"}};
  for (const StudyRow& row : r.rows)
    table.rows.push_back({row.count.scene, row.count.synthesis, static_cast<double>(row.count.human),
                          static_cast<double>(row.count.of), 100.0 * row.count.human / row.count.of, row.chi_square,
                          row.p, row.coin_p, row.odds, words_of(row)});
  table.notes.push_back(r.as_paper ? "chi2: (|human - of/2| - 1/2)^2 / (of/2) as in Yu et al. 2011, one of two cells"
                                   : "chi2: both cells, 1 degree of freedom; p < 0.05 is a difference");
  table.notes.push_back(
      "odds: of chance (P = 1/2) over any preference (P uniform); above 3 no difference, below 1/3 one");
  return table;
}

std::vector<std::string> distinct(const StudyReport& r, std::string StudyCount::*name) {
  std::vector<std::string> names;
  for (const StudyRow& row : r.rows)
    if (std::ranges::find(names, row.count.*name) == names.end()) names.push_back(row.count.*name);
  return names;
}

/// Scenes down, syntheses across; `values` gives the cells of a pair, one a column of `parts`.
template <class F>
Table cross_table(const StudyReport& r, Table table, const std::vector<std::string>& parts, F&& values) {
  const std::vector<std::string> across = distinct(r, &StudyCount::synthesis);
  table.columns = {{"scene"}};
  for (const std::string& name : across)
    for (const std::string& part : parts) table.columns.push_back({name + " " + part, 3});
  for (const std::string& scene : distinct(r, &StudyCount::scene)) {
    std::vector<Cell> cells(table.columns.size());
    cells[0] = scene;
    for (const StudyRow& row : r.rows) {
      if (row.count.scene != scene) continue;
      const auto at = static_cast<std::size_t>(std::ranges::find(across, row.count.synthesis) - across.begin());
      const std::vector<double> numbers = values(row);
      for (std::size_t k = 0; k < parts.size(); ++k) cells[1 + at * parts.size() + k] = numbers[k];
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

Result<StudyData> open_study_data(const std::string& path) {
  const Result<std::string> bytes = io::read_file(path);
  if (!bytes) return Error{bytes.error().code, bytes.error().message, ""};
  return io::read_study_data(*bytes);
}

Result<StudyReport> study_analyse(std::span<const StudyFile> files, bool as_paper) {
  const auto people = people_of(files);
  if (!people) return people.error();
  StudyReport report;
  report.as_paper = as_paper;
  std::map<Names, StudyCount> answered;
  count_answers(*people, report, answered);
  std::vector<StudyCount> counts;
  for (auto& [names, count] : answered) counts.push_back(std::move(count));
  for (const StudyFile& file : files)
    for (const StudyCount& count : file.data.counts) {
      const auto same = std::ranges::find_if(counts, [&](const StudyCount& c) {
        return std::tie(c.scene, c.synthesis) == std::tie(count.scene, count.synthesis);
      });
      if (same == counts.end()) {
        counts.push_back(count);
        continue;
      }
      same->human += count.human, same->of += count.of;
      if (same->of > kMostChoices)
        return invalid(file.name, "more than " + std::to_string(kMostChoices) + " choices of one pair");
    }
  if (counts.empty()) return invalid(files.empty() ? "" : files.front().name, "nobody has answered anything");
  for (StudyCount& count : counts) report.rows.push_back(row_of(std::move(count), as_paper));
  return report;
}

std::vector<Table> study_tables(const StudyReport& report) {
  std::vector<Table> tables;
  if (report.answers > 0) tables.push_back(people_table(report));
  tables.push_back(pair_table(report));
  if (distinct(report, &StudyCount::scene).size() < 2) return tables;
  tables.push_back(
      cross_table(report, {"chi2", "Chi-square and its p", {}, {}, {}}, {"chi2", "p"}, [](const StudyRow& row) {
        return std::vector{row.chi_square, row.p};
      }));
  tables.push_back(cross_table(report, {"odds", "Odds of no difference over a difference", {}, {}, {}}, {"odds"},
                               [](const StudyRow& row) { return std::vector{row.odds}; }));
  return tables;
}

std::string study_text(const StudyReport& report) {
  std::string text;
  for (const Table& table : study_tables(report)) text += (text.empty() ? "" : "\n") + table_text(table);
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  return text;
}

std::string study_json(const StudyReport& report) {
  nlohmann::ordered_json json;
  json["tables"] = nlohmann::ordered_json::array();
  for (const Table& table : study_tables(report))
    json["tables"].push_back(nlohmann::ordered_json::parse(table_json(table)));
  json["notes"] = report.notes;
  return json.dump() + "\n";
}

std::string study_csv(const StudyReport& report) {
  std::string text = "scene,synthesis,human,of,chi2,p,coin_p,odds,evidence\n";
  for (const StudyRow& row : report.rows) {
    text += io::csv_field(row.count.scene) + "," + io::csv_field(row.count.synthesis);
    for (const double value : {static_cast<double>(row.count.human), static_cast<double>(row.count.of), row.chi_square,
                               row.p, row.coin_p, row.odds})
      text += "," + core::shortest(value);
    text += std::string(",") + words_of(row) + "\n";
  }
  return text;
}

}  // namespace inhabit::session
