#pragma once
#include <span>
#include <string>
#include <vector>

#include "scene/study.h"
#include "session/document.h"
#include "session/study_statistics.h"
#include "session/table.h"

/// What a study's answers say (`inhabit study analyse`, docs/study.md).
namespace inhabit::session {

struct StudyFile {
  std::string name;
  StudyData data;
};

/// Answers or counts in a file. Errors name the place.
Result<StudyData> open_study_data(const std::string& path);

struct StudyRow {
  StudyCount count;
  double chi_square = 0, p = 1;  ///< of both cells, or as Yu11 printed it
  double coin_p = 1;             ///< the exact probability, of which p is the limit
  double odds = 1;
  Evidence evidence = Evidence::inconclusive;
};

struct StudyReport {
  bool as_paper = false;       ///< chi_square and p are Yu11's figure
  std::vector<StudyRow> rows;  ///< of counts in order of appearance, of answers by name
  // Of answers; all zero for counts.
  int participants = 0, answers = 0;
  int left = 0;              ///< answers that chose the left side
  int twice = 0, alike = 0;  ///< pairs that somebody saw on both sides; of these with the same choice both times
  double median_seconds = 0;
  std::vector<std::string> notes;
};

/// Files are added up; who is in several files counts once, with most answers. Errors (`where` is the file's name):
/// answers of different pages, somebody who answered differently in two files, nothing to count.
Result<StudyReport> study_analyse(std::span<const StudyFile> files, bool as_paper);

/// The tables: who answered, every pair, and of several scenes the paper's tables 2 and 3.
std::vector<Table> study_tables(const StudyReport& report);
std::string study_text(const StudyReport& report);
/// One object: "tables" and "notes".
std::string study_json(const StudyReport& report);
/// The pairs as CSV; `inhabit study analyse` reads it again as counts.
std::string study_csv(const StudyReport& report);

}  // namespace inhabit::session
