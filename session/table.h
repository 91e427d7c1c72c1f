#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/statistics.h"

namespace inhabit::session {

/// One value of a table: nothing (printed as "-", null in JSON), text, a number, a truth.
struct Cell {
  enum class Kind { nothing, text, number, truth } kind = Kind::nothing;
  std::string text;
  double number = 0;

  Cell() = default;
  Cell(double value) : kind(Kind::number), number(value) {}
  Cell(std::string value) : kind(Kind::text), text(std::move(value)) {}
  Cell(const char* value) : kind(Kind::text), text(value) {}
  static Cell truth(bool value) {
    Cell cell(value ? 1.0 : 0.0);
    cell.kind = Kind::truth;
    return cell;
  }
};

struct Column {
  std::string name;  ///< unit included, as people read it: "median ms"
  int digits = 2;    ///< behind the point
};

/// Measured figures: printed for people and written as JSON from the same cells.
struct Table {
  std::string id, title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> notes;
};

/// Aligned columns under a title, numbers to the right; ends with a newline.
std::string table_text(const Table& table);
/// `{"id": …, "title": …, "rows": [{"column": value, …}], "notes": […]}`, numbers in full.
std::string table_json(const Table& table);

using core::median;
using core::quantile;

}  // namespace inhabit::session
