#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/simulate_job.h"

namespace inhabit::app {
namespace {

struct Simulate {
  SceneArgument scene;
  session::SimulateJob job;
  std::string out;
  double seconds = 0, step = 0;
  std::uint64_t seed = 0;
  CLI::Option *seconds_given = nullptr, *step_given = nullptr, *seed_given = nullptr;
  bool json = false, quiet = false, parameters = false;
};

constexpr const char* kFooter =
    "SCENE needs a `crowd` (docs/scene.md). Outline, holes and the furniture that people bump into are obstacles;\n"
    "doors are closed unless the area of a goal or a source reaches through them. The summary says who could not be\n"
    "placed, was moved out of furniture or cannot reach a goal. Ctrl-C stops the run and keeps the frames so far.\n"
    "Examples:\n"
    "  inhabit simulate bottleneck-480 -o bottleneck.txt\n"
    "  inhabit simulate room.json -o walk.h5 --seconds 120 --seed 7\n"
    "  inhabit simulate sparse-passing -o orca.csv --model orca --set horizon=3\n"
    "  inhabit simulate dense-passing -o dense.sqlite --preset game --far avoidance --step 0.02 --every 5\n"
    "  inhabit simulate bottleneck-3600 --seconds 30 --json";

void add_run(CLI::App& verb, Simulate& s) {
  session::SimulateJob& job = s.job;
  s.seconds_given = verb.add_option("--seconds", s.seconds, "How long people walk, seconds; else SCENE says (60)")
                        ->check(CLI::Range(0.0, 1e7));
  s.step_given = verb.add_option("--step", s.step, "Time step, seconds, at most 1; else SCENE says (1/48)");
  verb.add_option("--every", job.every, "Steps from one written frame to the next")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  s.seed_given = verb.add_option("--seed", s.seed,
                                 "Seed of every random choice; the same seed gives the same bytes; else SCENE says")
                     ->check(not_negative, "");
  verb.add_option("--threads", job.threads, "Threads, 0 = all there are; never changes the result")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
}

int run(Simulate& s) {
  if (s.parameters) return print(session::model_parameter_lines()), kDone;
  if (s.scene.name.empty()) return complain("SCENE is required (inhabit simulate --help says more)"), kError;
  if (!can_save(s.out)) return kError;
  session::SimulateJob& job = s.job;
  if (s.seconds_given->count() > 0) job.seconds = s.seconds;
  if (s.step_given->count() > 0) job.step = s.step;
  if (s.seed_given->count() > 0) job.seed = s.seed;
  const std::optional<session::Document> document = open(s.scene, s.quiet);
  if (!document) return kError;
  if (document->scenes.size() != 1) {
    complain(s.scene.name + ": holds " + std::to_string(document->scenes.size()) + " rooms; choose one with --room");
    return kError;
  }
  const Interruptible interruptible;
  job.cancel = interruptible.cancel();
  const core::Result<session::Simulated> done = [&] {
    ProgressLine line(!s.quiet && !s.json);
    job.progress = line.reporter();
    return session::simulate_job(document->scenes.front(), job, s.out);
  }();
  job.progress = nullptr;
  if (!done) {
    const std::string& where = done.error().where;
    return fail(where.starts_with("--") || (!s.out.empty() && where.starts_with(s.out)) ? "" : s.scene.name,
                done.error());
  }
  if (!s.quiet)
    for (const std::string& warning : done->warnings()) complain(s.scene.name + ": warning: " + warning);
  if (s.json)
    print(session::simulate_json(*done));
  else if (!s.quiet)
    print(session::simulate_text(*done));
  return kDone;
}

}  // namespace

std::function<int()> set_up_simulate(CLI::App& verb) {
  const auto s = std::make_shared<Simulate>();
  add_scene(verb, s->scene);
  verb.get_option("SCENE")->required(false);
  verb.add_option("-o,--output", s->out,
                  "Trajectories, in the format of the extension: .txt (PeTrack), .csv, .h5, .sqlite; without it people "
                  "walk for the summary alone")
      ->type_name("FILE");
  session::ModelChoice& model = s->job.model;
  verb.add_option("--model", model.model, "pbd, power-law, social-force or orca; else SCENE says (pbd)");
  verb.add_option("--preset", model.preset, "pbd: game (the thesis) or pedestrian (calibrated); else SCENE says");
  verb.add_option("--far", model.far, "pbd: collisions to come: long-range, avoidance or off; else SCENE says");
  verb.add_option("--set", model.set, "A parameter of the model, NAME=VALUE; may be repeated")->expected(1)->take_all();
  verb.add_flag("--parameters", s->parameters, "List every model's parameters with units and defaults, and stop");
  verb.add_option("--planner", s->job.planner,
                  "How people find their way: straight, paths, field or automatic; else SCENE says (automatic)");
  add_run(verb, *s);
  verb.add_flag("--json", s->json, "One JSON object on standard output and nothing else there");
  verb.add_flag("-q,--quiet", s->quiet, "No progress, no warnings, no summary");
  verb.footer(kFooter);
  return [s] { return run(*s); };
}

}  // namespace inhabit::app
