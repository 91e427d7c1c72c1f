#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/core.h"
#include "scene/trajectories.h"

/// What the readers of trajectories hand over before anything is checked; io/trajectory_checks.h makes Trajectories of
/// it.
namespace inhabit::io {
using namespace core;

/// More positions than any file may hold: 200 million, 4.8 GB in memory.
constexpr std::size_t kMostRows = 200'000'000;

enum class LengthUnit { metres, centimetres };

/// Positions in the order of the file. The lists beside `fixes` are as long as it or empty.
struct RawTrajectories {
  std::vector<scene::Fix> fixes;          ///< in the file's unit; `frame` is not used when there are times
  std::vector<std::uint32_t> lines;       ///< in the text; empty: the file has rows, counted from 1
  std::vector<std::uint32_t> rows;        ///< where they stood before they were sorted; empty: as they stand
  std::vector<double> times;              ///< seconds, for formats without frames
  std::vector<float> speeds;              ///< metres per second where the file has them: they tell the frame rate
  std::vector<std::int64_t> wide;         ///< people's numbers when one of them does not fit 32 bits
  bool irregular = false;                 ///< the times are those of events: positions between them are interpolated
  std::optional<double> frame_rate;       ///< frames per second, when the file says it
  std::optional<double> row_rate;         ///< when it does not: a person's rows per second, from which frames follow
  std::optional<double> custom_row_rate;  ///< what is usual for such files, to be asked about and not believed
  std::optional<LengthUnit> unit;
  std::vector<scene::Area> walkable;
  std::string title;
  std::vector<std::string> remarks;

  /// Where row `k` stands.
  std::string where(std::size_t k) const {
    if (!lines.empty()) return "line " + std::to_string(lines[k]);
    return "row " + std::to_string((rows.empty() ? k : rows[k]) + 1);
  }
};

/// Takes rows one by one and refuses what no trajectory can hold.
class RawRows {
 public:
  explicit RawRows(RawTrajectories& raw) : raw_(raw) {}

  /// False when the row is refused: then `problem` says why. `line` 0: the file has no lines.
  bool add(std::int64_t person, std::int64_t frame, double x, double y, std::uint32_t line = 0);
  bool add_at(std::int64_t person, double time, double x, double y, std::uint32_t line = 0);

  std::string problem;

 private:
  RawTrajectories& raw_;
};

}  // namespace inhabit::io
