#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/crowd_pictures.h"

namespace inhabit::app {
namespace {

using What = session::CrowdPictureJob::What;

struct Render {
  SceneArgument scene;
  std::string out;
  session::PictureOptions options;
  bool no_labels = false, quiet = false;
  session::TrajectoryOpenOptions reading;
  SceneArgument walls;
  session::FilmJob film;
  double at = 0, trail = 1, from = 0, until = 0;
  bool paths = false;
  std::string axis, color = "speed";
  CLI::Option *at_given = nullptr, *trail_given = nullptr, *from_given = nullptr, *until_given = nullptr;
  std::vector<CLI::Option*> for_plans, for_crowds, for_films;
};

constexpr const char* kFooter =
    "SCENE may be a file of trajectories of any format that inhabit reads: then people are drawn, as discs coloured "
    "by\n"
    "their speed with the last second of their paths. -o film.mp4 or film.webm makes a film, for which ffmpeg must be "
    "on\n"
    "the PATH; -o frames/ (a folder) or -o frame-%04d.png makes its pictures, numbered from 0.\n"
    "Examples:\n"
    "  inhabit render living-room -o room.svg\n"
    "  inhabit render room.json -o room.png --pixels 3000 --problems\n"
    "  inhabit render walk.txt -o busiest.png --scene bottleneck-480\n"
    "  inhabit render walk.txt -o paths.svg --paths --color time\n"
    "  inhabit render ring.h5 -o diagram.pdf --space-time x --from 10 --until 60\n"
    "  inhabit render passing.h5 -o lanes.png --color way --radius 0.5 --at 35\n"
    "  inhabit render walk.txt -o walk.mp4 --speed 2 --width 1920\n"
    "  inhabit render walk.txt -o frames/ --film-fps 10 --trail 3";

/// The first of the options that was given; empty when none was.
std::string first_given(const std::vector<CLI::Option*>& options) {
  for (const CLI::Option* option : options)
    if (option->count() > 0) return "--" + option->get_lnames().front();
  return "";
}

int misplaced(const Render& r, const std::string& option, const std::string& why) {
  return fail(r.scene.name, core::invalid("", option + " " + why));
}

session::CrowdPictureJob picture_job(const Render& r) {
  session::CrowdPictureJob job = r.film.picture;
  job.what = r.paths ? What::paths : r.axis.empty() ? What::moment : r.axis == "x" ? What::along_x : What::along_y;
  if (r.at_given->count() > 0) job.at = r.at;
  if (r.trail_given->count() > 0) job.trail = r.trail;
  if (r.from_given->count() > 0) job.from = r.from;
  if (r.until_given->count() > 0) job.until = r.until;
  using Color = session::CrowdPictureJob::Color;
  job.color = r.color == "time" ? Color::time : r.color == "way" ? Color::way : Color::speed;
  job.pixels = r.options.pixels;
  return job;
}

int render_film(Render& r, const scene::Trajectories& trajectories) {
  const Interruptible interruptible;
  r.film.cancel = interruptible.cancel();
  const core::Result<std::size_t> made = [&] {
    ProgressLine line(!r.quiet);
    r.film.progress = line.reporter();
    return session::film(trajectories, r.out, r.film);
  }();
  r.film.progress = nullptr;
  return made ? kDone : fail(made.error().where.starts_with("--") ? r.scene.name : r.out, made.error());
}

/// What cannot be together, said before the file is read.
std::string contradiction(const Render& r, bool film) {
  const bool lines = r.paths || !r.axis.empty();
  if (film && lines) return (r.paths ? "--paths" : "--space-time") + std::string(" is a picture, not a film");
  if (film && r.at_given->count() > 0) return "--at is for pictures; --from and --until choose a part of a film";
  if (r.paths && !r.axis.empty()) return "--paths and --space-time are two pictures";
  if (lines && r.at_given->count() > 0) return "--at is for a picture of one moment";
  if (!lines && r.color == "time") return "--color time is for --paths and --space-time";
  if (const std::string option = first_given(r.for_films); !film && !option.empty()) return option + " is for films";
  return "";
}

int render_crowd(Render& r) {
  if (const std::string option = first_given(r.for_plans); !option.empty())
    return misplaced(r, option, "is for scenes, and this file holds trajectories");
  if (!r.scene.rooms.empty() || !r.scene.options.asset_database.empty() || r.scene.options.line != 0)
    return misplaced(r, "--room, --assets and --line", "are for scenes, and this file holds trajectories");
  const bool film = session::film_kind(r.out).has_value();
  if (const std::string wrong = contradiction(r, film); !wrong.empty()) return complain(wrong), kError;
  core::Status possible = session::can_film(r.out);
  if (!film && session::check_picture_name(r.out)) possible = core::Done{};
  if (!possible && !film)
    return fail(r.out,
                {core::ErrorCode::unsupported,
                 "a picture is written as .svg, .png or .pdf, a film as .mp4, .webm, frame-%04d.png or a folder", ""});
  if (!possible) return fail(r.out, possible.error());
  if (!film && !can_save(r.out)) return kError;
  std::optional<session::Document> document;
  if (!r.walls.name.empty()) {
    document = open(r.walls, r.quiet);
    if (!document) return kError;
    if (document->scenes.size() != 1)
      return fail(r.walls.name,
                  core::invalid("", "holds " + std::to_string(document->scenes.size()) +
                                        " rooms; people walk in one (inhabit convert --room takes it out)"));
  }
  const core::Result<scene::Trajectories> trajectories = session::open_trajectories(r.scene.name, r.reading);
  if (!trajectories) return fail(r.scene.name, trajectories.error());
  if (!r.quiet)
    for (const std::string& remark : trajectories->remarks) complain(r.scene.name + ": " + remark);
  r.film.picture = picture_job(r);
  if (document) r.film.picture.scene = &document->scenes.front();
  if (film) return render_film(r, *trajectories);
  const core::Result<std::string> picture = session::crowd_picture(*trajectories, r.out, r.film.picture);
  if (!picture) return fail(r.scene.name, picture.error());
  return save(r.out, picture) ? kDone : kError;
}

int run(Render& r) {
  if (session::holds_trajectories(r.scene.name)) return render_crowd(r);
  if (const std::string option = first_given(r.for_crowds); !option.empty())
    return misplaced(r, option, "is for trajectories, and this is none");
  if (const core::Status good = session::check_picture_name(r.out); !good) return fail(r.out, good.error());
  r.options.labels = !r.no_labels;
  const std::optional<session::Document> document = open(r.scene, r.quiet);
  if (!document) return kError;
  return save(r.out, session::plan_picture(*document, r.out, r.options)) ? kDone : kError;
}

void add_people(CLI::App& verb, Render& r) {
  const auto option = [&](CLI::Option* added) { return r.for_crowds.push_back(added), added; };
  add_trajectory_options(verb, r.reading);
  for (const char* name : {"--unit", "--fps", "--homography"}) r.for_crowds.push_back(verb.get_option(name));
  option(
      verb.add_option("--scene", r.walls.name, "Trajectories: walls and furniture round them; else what the file says")
          ->type_name("SCENE"));
  r.at_given = option(verb.add_option("--at", r.at, "Trajectories: this second; else the one with most people"));
  option(verb.add_option("--radius", r.film.picture.radius, "Trajectories: of everybody, metres")
             ->check(CLI::Range(0.001, 100.0))
             ->capture_default_str());
  r.trail_given =
      option(verb.add_option("--trail", r.trail, "Trajectories: seconds of path behind everybody, 0 = none; else 1")
                 ->check(CLI::Range(0.0, 1e4)));
  option(verb.add_flag("--paths", r.paths, "Trajectories: all paths as thin lines"));
  option(verb.add_option("--space-time", r.axis, "Trajectories: position along this axis against time")
             ->type_name("AXIS")
             ->check(CLI::IsMember({"x", "y"})));
  option(verb.add_option("--color", r.color, "Trajectories: by speed, way (where each one goes) or, of lines, time")
             ->check(CLI::IsMember({"speed", "way", "time"}))
             ->capture_default_str());
  r.from_given = option(verb.add_option("--from", r.from, "Trajectories: only from this second on"));
  r.until_given = option(verb.add_option("--until", r.until, "Trajectories: only up to this second"));
  const auto of_film = [&](CLI::Option* added) { return r.for_films.push_back(added), option(added); };
  of_film(verb.add_option("--film-fps", r.film.rate, "Films: pictures per second")
              ->check(CLI::Range(0.1, 240.0))
              ->capture_default_str());
  of_film(verb.add_option("--speed", r.film.speed, "Films: seconds walked in a second of film")
              ->check(CLI::Range(0.001, 10000.0))
              ->capture_default_str());
  of_film(
      verb.add_option("--width", r.film.width, "Films: pixels")->check(CLI::Range(64, 7680))->capture_default_str());
  of_film(verb.add_option("--threads", r.film.threads, "Films: threads, 0 = all there are")
              ->check(CLI::Range(0, 4096))
              ->capture_default_str());
}

}  // namespace

std::function<int()> set_up_render(CLI::App& verb) {
  const auto r = std::make_shared<Render>();
  add_scene(verb, r->scene);
  verb.get_option("SCENE")->description("A scene, the name of a built-in one, or a file of trajectories");
  verb.add_option("-o,--output", r->out, "Picture: .svg, .png or .pdf; of trajectories also .mp4, .webm or a folder")
      ->type_name("FILE")
      ->required();
  verb.add_option("--pixels", r->options.pixels, "Long side of a PNG, pixels")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  r->for_plans = {
      verb.add_flag("--no-labels", r->no_labels, "Plans: no names"),
      verb.add_flag("--clearances", r->options.clearances, "Plans: draw the free depth wanted before faces"),
      verb.add_flag("--views", r->options.views, "Plans: draw view cones"),
      verb.add_flag("--door-zones", r->options.door_zones, "Plans: draw what the doors sweep"),
      verb.add_flag("--problems", r->options.problems,
                    "Plans: mark overlaps, what stands outside, blocked doors and clearances")};
  add_people(verb, *r);
  verb.add_flag("-q,--quiet", r->quiet, "No progress and no warnings");
  verb.footer(kFooter);
  return [r] { return run(*r); };
}

}  // namespace inhabit::app
