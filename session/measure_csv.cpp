#include "core/text.h"
#include "session/measure_job.h"

namespace inhabit::session {
namespace {

/// Rows of numbers; unknown ones are empty.
struct Csv {
  std::string text;
  explicit Csv(const char* header) : text(std::string(header) + "\n") {}
  void row(std::initializer_list<double> values) {
    bool first = true;
    for (const double value : values) {
      if (!first) text += ',';
      first = false;
      if (crowd::known(value)) text += shortest(value);
    }
    text += '\n';
  }
};

std::string areas_csv(const MeasureReport& r) {
  Csv csv("frame,seconds,people,classic_density,classic_speed,voronoi_density,voronoi_speed");
  for (std::size_t k = 0; k < r.classic.size(); ++k) {
    const crowd::AreaRow& c = r.classic[k];
    const crowd::AreaRow& v = r.voronoi[k];
    csv.row({static_cast<double>(c.frame), c.seconds, static_cast<double>(c.people), c.density, c.speed, v.density,
             v.speed});
  }
  return csv.text;
}

std::string people_csv(const MeasureReport& r) {
  Csv csv("person,seconds,length,shortest,detour,effort,effort_ratio");
  for (const crowd::PathRow& p : r.paths)
    csv.row({static_cast<double>(p.person), p.seconds, p.length, p.shortest, p.detour(), p.effort, p.effort_ratio()});
  return csv.text;
}

std::string frames_csv(const MeasureReport& r) {
  Csv csv("seconds,people,overlapping_pairs,deepest_overlap,forward,backward,lane_order");
  for (std::size_t k = 0; k < r.presence.rows.size(); ++k) {
    const crowd::Overlaps::Row none;
    const crowd::Overlaps::Row& o = k < r.overlaps.rows.size() ? r.overlaps.rows[k] : none;
    const crowd::LaneRow& lane = r.lanes[k];
    csv.row({r.presence.rows[k].seconds, static_cast<double>(r.presence.rows[k].people), static_cast<double>(o.pairs),
             o.worst, static_cast<double>(lane.forward), static_cast<double>(lane.backward), lane.order});
  }
  return csv.text;
}

std::string field_csv(const crowd::DensityField& field) {
  Csv csv("x,y,density,speed");
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns) + column;
      csv.row({field.origin.x + (column + 0.5) * field.cell, field.origin.y + (row + 0.5) * field.cell,
               field.density[at], field.speed[at]});
    }
  }
  return csv.text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> measure_csv(const MeasureReport& r) {
  Csv crossings("seconds,person,direction,x,y,speed");
  for (const crowd::Crossing& c : r.crossings)
    crossings.row(
        {c.seconds, static_cast<double>(c.person), static_cast<double>(c.direction), c.at.x, c.at.y, c.speed});
  Csv bins("density_from,density_to,points,density_median,speed_median,speed_lower,speed_upper");
  for (const crowd::DensityBin& b : r.bins)
    bins.row({b.low, b.high, static_cast<double>(b.count), b.density, b.median, b.lower, b.upper});
  Csv collisions("from_seconds,to_seconds,pairs");
  for (std::size_t k = 0; k < r.times_to_collision.histogram.size(); ++k) {
    const double step = r.times_to_collision.step, low = static_cast<double>(k) * step;
    collisions.row({low, low + step, static_cast<double>(r.times_to_collision.histogram[k])});
  }
  std::vector<std::pair<std::string, std::string>> files = {
      {"area.csv", areas_csv(r)},        {"fundamental-diagram.csv", bins.text},
      {"crossings.csv", crossings.text}, {"frames.csv", frames_csv(r)},
      {"people.csv", people_csv(r)},     {"time-to-collision.csv", collisions.text}};
  if (!r.field.density.empty()) files.emplace_back("density-field.csv", field_csv(r.field));
  return files;
}

}  // namespace inhabit::session
