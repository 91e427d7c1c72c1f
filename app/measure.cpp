#include <filesystem>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/measure_job.h"

namespace inhabit::app {
namespace {

struct Measure {
  std::string trajectories, area, line, unit, plots, csv, format = "svg", reference;
  SceneArgument scene;
  session::MeasureOptions options;
  io::TrajectoryOptions reading;
  bool json = false, quiet = false;
};

constexpr const char* kFooter =
    "TRAJECTORIES is a file of any format that inhabit reads. Metres, seconds, people per square metre.\n"
    "Without --area and --line the line lies across the main flow in the middle of it, and the area is 2 m deep round "
    "it;\nthe answer says where. Without --scene the walls are those that the file has, if any.\n"
    "Examples:\n"
    "  inhabit measure walk.txt\n"
    "  inhabit measure uo-050-180-180.txt --unit cm --fps 16 --scene corridor.wkt --area 0,-1,1.8,1 --line 0,0,1.8,0\n"
    "  inhabit measure walk.h5 --from 10 --until 40 --json --plots plots --csv rows";

/// A folder that can be written into, made when its parent is there.
bool make_folder(const std::string& folder) {
  if (folder.empty()) return true;
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  return can_save(folder + "/file");
}

bool set_place(Measure& m) {
  if (!m.area.empty()) {
    core::Result<scene::Ring> area = session::parse_area(m.area);
    if (!area) return fail(m.trajectories, area.error()), false;
    m.options.area = std::move(*area);
  }
  if (!m.line.empty()) {
    const core::Result<crowd::MeasureLine> line = session::parse_line(m.line);
    if (!line) return fail(m.trajectories, line.error()), false;
    m.options.line = *line;
  }
  if (m.scene.name.empty()) return true;
  const std::optional<session::Document> document = open(m.scene, m.quiet || m.json);
  if (!document) return false;
  core::Result<std::vector<scene::Area>> walkable = session::walkable_of(*document);
  if (!walkable) return fail(m.scene.name, walkable.error()), false;
  m.options.walkable = std::move(*walkable);
  return true;
}

bool save_all(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files,
              const std::string& extension) {
  for (const auto& [name, bytes] : files)
    if (!save(folder + "/" + name + extension, bytes)) return false;
  return true;
}

int run(Measure& m) {
  if (m.unit == "m") m.reading.unit = io::LengthUnit::metres;
  if (m.unit == "cm") m.reading.unit = io::LengthUnit::centimetres;
  if (!set_place(m) || !make_folder(m.plots) || !make_folder(m.csv)) return kError;
  std::vector<crowd::FundamentalPoint> reference;
  if (!m.reference.empty()) {
    auto curve = session::read_curve(m.reference);
    if (!curve) return fail(m.reference, curve.error());
    reference = std::move(*curve);
  }
  const core::Result<scene::Trajectories> trajectories = session::open_trajectories(m.trajectories, m.reading);
  if (!trajectories) return fail(m.trajectories, trajectories.error());
  m.options.field = !m.plots.empty() || !m.csv.empty();
  const core::Result<session::MeasureReport> report = session::measure_job(*trajectories, m.options);
  if (!report) return fail(m.trajectories, report.error());
  if (m.json) {
    print(session::measure_json(*report));
  } else if (!m.quiet) {
    print(session::measure_text(*report));
    if (!reference.empty()) print("\n" + session::table_text(session::curve_table(report->points, reference)));
  }
  if (!m.csv.empty() && !save_all(m.csv, session::measure_csv(*report), "")) return kError;
  if (m.plots.empty()) return kDone;
  const auto plots = session::measure_plots(*trajectories, *report, m.format, reference);
  if (!plots) return fail(m.plots, plots.error());
  return save_all(m.plots, *plots, "." + m.format) ? kDone : kError;
}

}  // namespace

std::function<int()> set_up_measure(CLI::App& verb) {
  const auto m = std::make_shared<Measure>();
  verb.add_option("TRAJECTORIES", m->trajectories, "Where people were at which time")->required();
  verb.add_option("--scene", m->scene.name, "Walls: a scene, a plan or a built-in name")->type_name("SCENE");
  verb.add_option("--area", m->area, "Where density and speed are measured: \"x0,y0,x1,y1\" or \"POLYGON ((…))\"");
  verb.add_option("--line", m->line, "Where people are counted: \"x0,y0,x1,y1\"; along the flow is to its left");
  verb.add_option("--radius", m->options.radius, "Of everybody, for overlaps and collisions, metres")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  verb.add_option("--from", m->options.from, "Only from this second on");
  verb.add_option("--until", m->options.until, "Only up to this second");
  verb.add_option("--cut-off", m->options.cut_off, "Voronoi cells reach no farther than this, metres; 0: to the walls")
      ->check(CLI::Range(0.0, 1e6));
  verb.add_option("--window", m->options.window, "Speeds over so many frames either way; 0: about 5/16 s")
      ->check(CLI::Range(0, 100000));
  verb.add_option("--reference", m->reference, "A published curve, lines of density and speed, to stand beside ours")
      ->type_name("FILE");
  verb.add_option("--unit", m->unit, "Of a file that does not say: m or cm")->check(CLI::IsMember({"m", "cm"}));
  verb.add_option("--fps", m->reading.frame_rate, "Frames per second of a file that does not say")
      ->check(CLI::Range(1e-3, 1e4));
  verb.add_option("--plots", m->plots, "Write plots into this folder")->type_name("DIR");
  verb.add_option("--format", m->format, "Of the plots")
      ->check(CLI::IsMember({"svg", "png", "pdf"}))
      ->capture_default_str();
  verb.add_option("--csv", m->csv, "Write the rows behind the figures into this folder")->type_name("DIR");
  verb.add_option("--threads", m->options.threads, "Threads, 0 = all there are")->check(CLI::Range(0, 4096));
  verb.add_flag("--json", m->json, "One JSON object on standard output and nothing else there");
  verb.add_flag("-q,--quiet", m->quiet, "No table and no warnings");
  verb.footer(kFooter);
  return [m] { return run(*m); };
}

}  // namespace inhabit::app
