#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "io/check_json.h"

namespace inhabit::io {
namespace {

using core::fixed;
using layout::CheckReport;

constexpr std::size_t kMostRows = 10;

/// Columns that a text takes on a terminal: its code points.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string metres(double depth) { return std::isfinite(depth) ? fixed(depth, 3) + " m" : "missing"; }
std::string percent(double share) { return fixed(100 * share, 1) + " %"; }

/// Rows of cells, printed with every column as wide as its widest cell; numbers (all but the first column) to the right
/// where `right` says so.
struct Grid {
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> right;

  std::string print(std::string_view indent) const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width(row[k]));
    }
    std::string text;
    for (const auto& row : rows) {
      std::string line(indent);
      for (std::size_t k = 0; k < row.size(); ++k) {
        const std::string pad(widths[k] - width(row[k]), ' ');
        const bool to_right = k < right.size() && right[k];
        if (k > 0) line.append("  ");
        line.append(to_right ? pad : row[k]).append(to_right ? row[k] : pad);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      text.append(line).append("\n");
    }
    return text;
  }
};

/// How much of the floor is reached. Never 100 % when something is not.
std::string reached(const layout::CheckReport::Reachable& r) {
  if (r.unreachable.empty() || r.share <= 0.999) return percent(r.share);
  const std::size_t n = r.unreachable.size();
  return "all but " + std::to_string(n) + (n == 1 ? " object" : " objects");
}

void verdict(Grid& grid, bool good, std::string what, std::string value, std::string advice) {
  grid.rows.push_back({good ? "✓" : "✗", std::move(what), std::move(value), good ? "" : std::move(advice)});
}

std::string count_or_none(std::size_t n) { return n == 0 ? "none" : std::to_string(n); }

std::string verdicts(const CheckReport& r) {
  Grid grid{{}, {false, false, true, false}};
  verdict(grid, r.feasible, "feasible", r.feasible ? "yes" : "no", "furnish again, or move what is listed below");
  verdict(grid, r.overlap_count == 0, "overlaps", count_or_none(r.overlap_count), "part the pairs below");
  const std::size_t outside = r.outside.size() - std::min(r.missing, r.outside.size());
  verdict(grid, outside == 0, "outside the room", count_or_none(outside), "move them in by the depth below");
  if (r.missing > 0) verdict(grid, false, "without a place", std::to_string(r.missing), "furnish places them");
  verdict(grid, r.blocked_doors.empty(), "blocked doors", count_or_none(r.blocked_doors.size()),
          "clear the swing and 0.6 m in front");
  verdict(grid, r.clearances.empty(), "blocked clearances", count_or_none(r.clearances.size()),
          "clear the faces below, or ask for less");
  verdict(grid, r.views.empty(), "blocked views", count_or_none(r.views.size()), "move lower things into the view");
  verdict(grid, r.reachable.share > 0.999 && r.reachable.unreachable.empty(), "reachable from the doors",
          reached(r.reachable),
          r.walkable_share == 0 ? "no place holds a person of 0.25 m radius"
                                : "a passage or a door is narrower than 0.5 m");
  verdict(grid, r.violations.empty(), "constraints not kept", count_or_none(r.violations.size()), "see the list below");
  std::string text = grid.print("");
  text.append("  walkable ")
      .append(percent(r.walkable_share))
      .append(", energy ")
      .append(fixed(r.energy, 3))
      .append("\n");
  if (r.exempt_pairs > 0) {
    text.append("  ").append(std::to_string(r.exempt_pairs)).append(" pairs need not keep apart; ");
    text.append(std::to_string(r.overlaps_exempt)).append(" of them overlap\n");
  }
  if (r.overlaps_pinned + r.outside_pinned > 0)
    text.append("  of what cannot move, ")
        .append(std::to_string(r.overlaps_pinned))
        .append(r.overlaps_pinned == 1 ? " pair overlaps" : " pairs overlap")
        .append(" and ")
        .append(std::to_string(r.outside_pinned))
        .append(r.outside_pinned == 1 ? " reaches" : " reach")
        .append(" out of the room; no arrangement changes that\n");
  if (r.overlaps_rigid > 0)
    text.append("  ")
        .append(std::to_string(r.overlaps_rigid))
        .append(" overlaps inside rigid groups, as the scene draws them\n");
  return text;
}

/// A heading and the first rows, if there are any.
template <class T, class F>
std::string section(std::string_view title, const std::vector<T>& items, std::vector<bool> right, F&& row) {
  if (items.empty()) return "";
  Grid grid{{}, std::move(right)};
  for (std::size_t k = 0; k < std::min(items.size(), kMostRows); ++k) grid.rows.push_back(row(items[k]));
  std::string text("\n");
  text.append(title).append("\n").append(grid.print("  "));
  if (items.size() > kMostRows)
    text.append("  … and ").append(std::to_string(items.size() - kMostRows)).append(" more\n");
  return text;
}

using Row = std::vector<std::string>;

std::string constraint_table(const CheckReport& r) {
  if (r.constraints.empty()) return "";
  Grid grid{{{"constraint", "count", "median", "95 %", "max", ""}}, {false, true, true, true, true, false}};
  for (const auto& k : r.constraints) {
    const int digits = k.unit == "deg" ? 1 : 3;
    grid.rows.push_back({k.type, std::to_string(k.count), fixed(k.median, digits), fixed(k.p95, digits),
                         fixed(k.max, digits), k.unit == "deg" ? "°" : k.unit});
  }
  return std::string("\n").append(grid.print("  "));
}

std::string published_table(const layout::PublishedMetrics& p) {
  Grid grid{{}, {false, false, true, false}};
  for (const auto& m : p.measures) grid.rows.push_back({m.source, m.name, m.value ? fixed(*m.value, 4) : "–", m.unit});
  std::string text("\npublished measures, ");
  text.append(std::to_string(p.placed)).append(" of ").append(std::to_string(p.asked)).append(" objects placed\n");
  return text.append(grid.print("  "));
}

}  // namespace

std::string check_table(const CheckReport& r) {
  std::string text = verdicts(r);
  text += section("overlaps", r.overlaps, {false, false, true}, [](const auto& o) {
    return Row{o.a, o.b, metres(o.depth)};
  });
  text += section("outside", r.outside, {false, true}, [](const auto& o) { return Row{o.id, metres(o.depth)}; });
  text += section("blocked doors", r.blocked_doors, {false, true}, [](const auto& d) {
    return Row{d.id, percent(d.share)};
  });
  text += section("blocked clearances", r.clearances, {false, false, true}, [](const auto& c) {
    return Row{c.id, c.face, percent(c.blocked_share)};
  });
  text += section("blocked views", r.views, {false, true}, [](const auto& v) {
    return Row{v.id, percent(v.blocked_share)};
  });
  text += section("nobody gets to", r.reachable.unreachable, {}, [](const std::string& id) { return Row{id}; });
  text += section("constraints not kept", r.violations, {}, [](const auto& v) { return Row{v.text}; });
  text += constraint_table(r);
  if (r.published) text += published_table(*r.published);
  return text;
}

}  // namespace inhabit::io
