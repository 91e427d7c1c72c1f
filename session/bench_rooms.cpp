#include <algorithm>
#include <filesystem>
#include <map>

#include "layout/check.h"
#include "layout/house_rules.h"
#include "session/bench.h"
#include "session/document.h"

namespace inhabit::session {
namespace {

constexpr std::size_t kLeastPieces = 4;
constexpr std::size_t kProcthorRooms = 100;

/// What a set of rooms came to.
struct RoomCount {
  int rooms = 0, human = 0, one_start = 0, five_starts = 0, errors = 0;
  std::vector<double> milliseconds;
};

bool is_movable(const Object& object) { return !object.fixed && object.mount == Mount::floor && object.on.none(); }

std::size_t movable_pieces(const Scene& scene) {
  return static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(), is_movable));
}

/// One room stripped and furnished again, with one start and with five.
void furnish_again(const Scene& room, const std::string& source, const BenchOptions& options, RoomCount& count,
                   Table& failures) {
  ++count.rooms;
  count.human += layout::check(room).feasible;
  Scene stripped = layout::without_positions(room);
  layout::add_house_rules(stripped);
  for (const int starts : {1, 5}) {
    layout::Options layout = options.layout;
    layout.starts = starts;
    layout.cancel = options.cancel;
    layout.threads = 1;
    const double begin = processor_milliseconds();
    const Result<layout::Outcome> outcome = layout::furnish(stripped, layout);
    const double took = processor_milliseconds() - begin;
    if (!outcome) {
      if (starts == 5) ++count.errors, failures.rows.push_back({source, room.name, outcome.error().text()});
      continue;
    }
    const layout::CheckReport report = layout::check(layout::with_placement(stripped, outcome->best.placement));
    if (starts == 1) {
      count.milliseconds.push_back(took);
      count.one_start += report.feasible;
      continue;
    }
    count.five_starts += report.feasible;
    if (report.feasible) continue;
    std::string why;
    if (!report.overlaps.empty())
      why = report.overlaps.front().a + " overlaps " + report.overlaps.front().b;
    else if (!report.outside.empty())
      why = report.outside.front().id + " stands outside";
    failures.rows.push_back({source, room.name, why});
  }
}

std::vector<Cell> count_row(const std::string& source, const RoomCount& c) {
  const double rooms = std::max(1, c.rooms);
  return {source,
          static_cast<double>(c.rooms),
          100 * c.human / rooms,
          100 * c.one_start / rooms,
          100 * c.five_starts / rooms,
          median(c.milliseconds),
          quantile(c.milliseconds, 0.95)};
}

std::vector<std::string> home_files(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".xml" || entry.path().extension() == ".sh3d")
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Result<BenchGroup> bench_rooms(const BenchOptions& options) {
  const std::filesystem::path rooms = std::filesystem::path(options.data) / "rooms";
  Table table{"rooms", "Real rooms with at least 4 pieces, stripped and furnished by the house rules", {}, {}, {}};
  table.columns = {{"source"},       {"rooms", 0}, {"as built feasible %", 1}, {"1 start %", 1}, {"5 starts %", 1},
                   {"median ms", 2}, {"p95 ms", 2}};
  Table failures{"rooms-failures", "Where it fails", {{"source"}, {"room"}, {"why"}}, {}, {}};
  const std::vector<std::string> files = home_files(rooms / "sweethome3d");
  if (files.empty())
    return Error{ErrorCode::not_found,
                 "no homes in " + (rooms / "sweethome3d").string() + "; name the data folder with --data", ""};
  RoomCount homes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Result<Document> document = open_document(files[i]);
    if (!document) return Error{document.error().code, files[i] + ": " + document.error().text(), ""};
    for (const Scene& room : document->scenes)
      if (movable_pieces(room) >= kLeastPieces)
        furnish_again(room, std::filesystem::path(files[i]).stem().string(), options, homes, failures);
    if (options.progress) options.progress(static_cast<double>(i + 1) / static_cast<double>(files.size()), "homes");
  }
  table.rows.push_back(count_row("Sweet Home 3D", homes));

  const std::string houses = (rooms / "procthor_one_room" / "train.jsonl.gz").string();
  if (std::filesystem::exists(houses)) {
    OpenOptions open;
    open.asset_database = (rooms / "procthor_db" / "asset-database.json").string();
    const Result<Document> document = open_document(houses, open);
    if (!document) return Error{document.error().code, houses + ": " + document.error().text(), ""};
    RoomCount count;
    std::size_t used = 0;
    for (const Scene& room : document->scenes) {
      if (used == kProcthorRooms) break;
      if (movable_pieces(room) < kLeastPieces) continue;
      furnish_again(room, "ProcTHOR", options, count, failures);
      ++used;
      if (options.progress) options.progress(static_cast<double>(used) / kProcthorRooms, "houses");
    }
    table.rows.push_back(count_row("ProcTHOR", count));
  }
  return BenchGroup{{std::move(table), std::move(failures)}, {}};
}

}  // namespace inhabit::session
