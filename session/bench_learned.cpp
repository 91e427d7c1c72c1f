#include <algorithm>
#include <filesystem>
#include <set>

#include "layout/check.h"
#include "session/bench.h"
#include "session/learn_job.h"
#include "session/real_rooms.h"

namespace inhabit::session {
namespace {

constexpr int kUsualSeeds = 5;
constexpr std::size_t kPictured = 5;

/// One method, or the people who designed the rooms, over all rooms and seeds.
struct Tried {
  std::string name;
  RoomFeatures features;
  RoomQuality quality;
  int errors = 0;
};

Result<std::vector<Document>> open_homes(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".xml" || entry.path().extension() == ".sh3d")
      files.push_back(entry.path().string());
  std::ranges::sort(files);
  if (files.size() < 2)
    return Error{ErrorCode::not_found,
                 "fewer than two homes in " + folder.string() + "; name the data folder with --data", ""};
  std::vector<Document> homes;
  for (const std::string& file : files) {
    Result<Document> home = open_document(file);
    if (!home) return Error{home.error().code, file + ": " + home.error().text(), ""};
    home->name = std::filesystem::path(file).stem().string();
    homes.push_back(std::move(*home));
  }
  return homes;
}

std::vector<double> pooled(const Features& features) {
  std::vector<double> all;
  for (const auto& [key, values] : features) all.insert(all.end(), values.begin(), values.end());
  std::ranges::sort(all);
  return all;
}

/// The distribution function of all values together, at 60 shares.
BenchCurve curve_of(const std::string& id, const std::string& title, const std::string& label,
                    const std::vector<Tried>& tried, Features RoomFeatures::*feature) {
  BenchCurve curve{id, title, label, "share of the things", false, false, {}};
  for (const Tried& t : tried) {
    const std::vector<double> values = pooled(t.features.*feature);
    if (values.empty()) continue;
    BenchCurve::Line line{t.name, {}, {}};
    for (int k = 0; k <= 60; ++k) {
      const auto at = std::min(values.size() - 1, static_cast<std::size_t>(k * values.size() / 60));
      line.x.push_back(values[at]), line.y.push_back(k / 60.0);
    }
    curve.lines.push_back(std::move(line));
  }
  return curve;
}

double share_below(const Features& features, double limit) {
  const std::vector<double> values = pooled(features);
  const auto below = std::ranges::count_if(values, [&](double v) { return v < limit; });
  return values.empty() ? 0 : 100 * static_cast<double>(below) / static_cast<double>(values.size());
}

Table quality_table(const std::vector<Tried>& tried, int seeds) {
  Table table{"learned-check", "Real rooms furnished again: what check says", {}, {}, {}};
  table.columns = {{"by"},
                   {"rooms", 0},
                   {"feasible %", 1},
                   {"doors free %", 1},
                   {"all within reach %", 1},
                   {"walkable %", 1},
                   {"faces blocked %", 1},
                   {"errors", 0}};
  for (const Tried& t : tried) {
    const double n = std::max(1, t.quality.rooms);
    table.rows.push_back(
        {t.name, static_cast<double>(t.quality.rooms), 100 * t.quality.feasible / n, 100 * t.quality.doors_free / n,
         100 * t.quality.all_reachable / n, 100 * t.quality.walkable_share / n,
         100.0 * t.quality.faces_blocked / std::max(1, t.quality.faces), static_cast<double>(t.errors)});
  }
  table.notes.push_back("priors from the other homes; one random start, " + std::to_string(seeds) +
                        " seeds a room; faces blocked: of those whose kinds the other homes keep free");
  return table;
}

Table distance_table(const std::vector<Tried>& tried, const RoomFeatures& half, const RoomFeatures& other_half) {
  Table table{"learned-distributions", "How far from what the designers did", {}, {}, {}};
  table.columns = {{"by"},
                   {"wall m", 3},
                   {"wall degrees", 1},
                   {"pair m", 3},
                   {"pair facing degrees", 1},
                   {"at the wall (10 cm) %", 1},
                   {"back to it (10 degrees) %", 1}};
  const RoomFeatures& human = tried.front().features;
  const auto row = [&](const std::string& name, const RoomFeatures& a, const RoomFeatures& b) {
    table.rows.push_back({name, difference(a.wall_distance, b.wall_distance), difference(a.wall_angle, b.wall_angle),
                          difference(a.pair_distance, b.pair_distance), difference(a.pair_facing, b.pair_facing),
                          share_below(b.wall_distance, 0.1), share_below(b.wall_angle, 10)});
  };
  row("human, every other room", half, other_half);
  for (std::size_t i = 1; i < tried.size(); ++i) row(tried[i].name, human, tried[i].features);
  table.rows.push_back({"human", Cell(), Cell(), Cell(), Cell(), share_below(human.wall_distance, 0.1),
                        share_below(human.wall_angle, 10)});
  table.notes.push_back(
      "mean area between the distribution functions of a kind or pair (Wasserstein), by numbers of things; the first "
      "row "
      "is what two halves of the designers' own rooms differ by");
  return table;
}

/// A second start would hide what a method does on its own.
layout::Options one_start(layout::Options options) {
  options.starts = 1;
  return options;
}

class Trial {
 public:
  Trial(const BenchOptions& options, std::vector<HeldOut> homes)
      : options_(options), homes_(std::move(homes)), methods_(real_methods(one_start(options.layout))) {
    tried_.push_back({"human", {}, {}, 0});
    for (const RealMethod& method : methods_) tried_.push_back({method.name, {}, {}, 0});
    sheet_.columns = static_cast<int>(tried_.size());
    seeds_ = options.seeds_given ? options.seeds : kUsualSeeds;
  }

  Result<BenchGroup> run(const scene::Priors& all) {
    std::size_t rooms = 0, done = 0;
    for (const HeldOut& home : homes_) rooms += home.rooms.size();
    RoomFeatures half, other_half;
    for (const HeldOut& home : homes_)
      for (const Scene& room : home.rooms) {
        if (options_.cancel && options_.cancel->requested()) break;
        const RoomFeatures seen = room_features(room, all);
        tried_[0].features.add(seen), tried_[0].quality.add(room, home.priors);
        (done % 2 == 0 ? half : other_half).add(seen);
        furnish(home, room, all);
        ++done;
        if (options_.progress) options_.progress(static_cast<double>(done) / static_cast<double>(rooms), home.home);
      }
    BenchGroup group;
    group.tables = {quality_table(tried_, seeds_), distance_table(tried_, half, other_half)};
    group.curves = {
        curve_of("learned-wall-distance", "Distance of the back to the wall", "metres", tried_,
                 &RoomFeatures::wall_distance),
        curve_of("learned-wall-angle", "Heading from the wall's normal", "degrees", tried_, &RoomFeatures::wall_angle),
        curve_of("learned-pair-distance", "Distance within pairs", "metres", tried_, &RoomFeatures::pair_distance)};
    group.sheets.push_back(std::move(sheet_));
    return group;
  }

 private:
  void furnish(const HeldOut& home, const Scene& room, const scene::Priors& all) {
    const Scene stripped = layout::without_positions(room);
    const bool pictured = pictured_.insert(home.home).second && pictured_.size() <= kPictured;
    if (pictured) sheet_.cells.push_back({room, room.name + " as designed"});
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      Tried& tried = tried_[m + 1];
      for (int seed = 1; seed <= seeds_; ++seed) {
        const Result<Scene> furnished = methods_[m].furnish(stripped, home.priors, static_cast<std::uint64_t>(seed));
        if (!furnished) {
          ++tried.errors;
          continue;
        }
        tried.features.add(room_features(*furnished, all)), tried.quality.add(*furnished, home.priors);
        if (pictured && seed == 1) sheet_.cells.push_back({*furnished, methods_[m].name});
      }
    }
  }

  const BenchOptions& options_;
  std::vector<HeldOut> homes_;
  std::vector<RealMethod> methods_;
  std::vector<Tried> tried_;
  BenchSheet sheet_{"learned-rooms", "Real rooms: as designed, and furnished again", 0, {}};
  std::set<std::string> pictured_;  ///< homes of which a room is in the sheet
  int seeds_ = kUsualSeeds;
};

}  // namespace

Result<BenchGroup> bench_learned(const BenchOptions& options) {
  const Result<std::vector<Document>> homes = open_homes(std::filesystem::path(options.data) / "rooms" / "sweethome3d");
  if (!homes) return homes.error();
  Result<std::vector<HeldOut>> held = held_out_homes(*homes);
  if (!held) return held.error();
  // What pairs there are to look at is the same for every home.
  const Result<exemplar::Learned> all = learn_job(*homes, {});
  if (!all) return all.error();
  return Trial(options, std::move(*held)).run(all->priors);
}

}  // namespace inhabit::session
