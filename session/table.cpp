#include "session/table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"

namespace inhabit::session {
namespace {

std::string cell_text(const Cell& cell, int digits) {
  switch (cell.kind) {
    case Cell::Kind::text:
      return cell.text;
    case Cell::Kind::number:
      return std::isfinite(cell.number) ? core::fixed(cell.number, digits) : "inf";
    case Cell::Kind::truth:
      return cell.number != 0 ? "yes" : "no";
    case Cell::Kind::nothing:
      break;
  }
  return "-";
}

/// Characters, not bytes, of well-formed UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void pad(std::string& line, const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  line += right ? space + text : text + space;
}

/// Counts without a point: 201, not 201.0.
nlohmann::ordered_json json_number(double number) {
  if (std::abs(number) < 1e15 && std::trunc(number) == number) return static_cast<std::int64_t>(number);
  return number;
}

}  // namespace

std::string table_text(const Table& table) {
  std::vector<std::size_t> widths;
  std::vector<bool> right;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t width = width_of(table.columns[c].name);
    bool numbers = true;
    for (const auto& row : table.rows) {
      width = std::max(width, width_of(cell_text(row[c], table.columns[c].digits)));
      numbers = numbers && row[c].kind != Cell::Kind::text;
    }
    widths.push_back(width);
    right.push_back(numbers);
  }
  const auto add_line = [&](std::string& out, auto&& text_of) {
    std::string line;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      if (c > 0) line += "  ";
      pad(line, text_of(c), widths[c], right[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  };
  std::string out;
  if (!table.title.empty()) out += table.title + '\n';
  if (!table.rows.empty()) add_line(out, [&](std::size_t c) { return table.columns[c].name; });
  for (const auto& row : table.rows)
    add_line(out, [&](std::size_t c) { return cell_text(row[c], table.columns[c].digits); });
  for (const std::string& note : table.notes) out += note + '\n';
  return out;
}

std::string table_json(const Table& table) {
  nlohmann::ordered_json json;
  json["id"] = table.id;
  json["title"] = table.title;
  json["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t c = 0; c < row.size(); ++c) {
      auto& value = object[table.columns[c].name];
      if (row[c].kind == Cell::Kind::text) value = row[c].text;
      if (row[c].kind == Cell::Kind::number) value = json_number(row[c].number);
      if (row[c].kind == Cell::Kind::truth) value = row[c].number != 0;
    }
    json["rows"].push_back(std::move(object));
  }
  json["notes"] = table.notes;
  return json.dump();
}

}  // namespace inhabit::session
