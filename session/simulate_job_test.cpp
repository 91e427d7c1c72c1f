#include "session/simulate_job.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace inhabit;
using namespace inhabit::session;

namespace {

scene::Ring rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

scene::Scene hall() {
  scene::Scene scene;
  scene.name = "hall";
  scene.space.outline = rectangle(100, 0, 120, 8);
  scene::Goal out;
  out.id = "out", out.area = rectangle(119, 0, 120, 8);
  scene.crowd.goals = {out};
  scene::Population people;
  people.id = "people", people.area = rectangle(101, 1, 107, 7), people.spacing = 1, people.goal.legs = {{"out"}};
  scene.crowd.populations = {people};
  scene.crowd.seconds = 40;
  return scene;
}

SimulateJob power_law() {
  SimulateJob job;
  job.model.model = "power-law";
  return job;
}

std::string message(const Result<scene::CrowdModel>& result) { return result ? "" : result.error().text(); }

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("inhabit-simulate-" + name);
}

}  // namespace

TEST_CASE("a run hands over every k-th step with its people in order") {
  const scene::Scene scene = hall();
  SimulateJob job = power_law();
  job.every = 3;
  Result<crowd::Simulation> simulation = start_simulation(scene, job);
  REQUIRE(simulation.ok());
  std::int32_t next = 0;
  std::vector<std::size_t> sizes;
  const Result<Simulated> done = run_simulation(*simulation, 40, job, [&](std::int32_t frame, auto people) -> Status {
    CHECK(frame == next++);
    for (std::size_t k = 1; k < people.size(); ++k) REQUIRE(people[k - 1].person < people[k].person);
    for (const io::Spot& spot : people) REQUIRE(contains(scene.space.outline, {spot.x, spot.y}));
    sizes.push_back(people.size());
    return Done{};
  });
  REQUIRE(done.ok());
  CHECK(done->people == 36);
  CHECK(done->arrived == 36);
  CHECK(done->inside == 0);
  CHECK(done->frames == sizes.size());
  CHECK(done->frames == done->steps / 3 + 1);
  CHECK(sizes.front() == 36);
  CHECK(done->time < 40);  // it ends when everybody is gone
  CHECK(done->warnings().empty());
  const auto json = nlohmann::json::parse(simulate_json(*done));
  CHECK(json["arrived"] == 36);
  CHECK(json["populations"][0]["placed"] == 36);
  CHECK(has(simulate_text(*done), "36 people, 36 arrived"));
}

TEST_CASE("a run is as long as asked for and stops when it is told to or its frames are refused") {
  const scene::Scene scene = hall();
  SimulateJob job = power_law();
  core::Cancel cancel;
  job.cancel = &cancel;
  const auto run = [&](double seconds, const FrameSink& sink) {
    Result<crowd::Simulation> simulation = start_simulation(scene, job);
    REQUIRE(simulation.ok());
    return run_simulation(*simulation, seconds, job, sink);
  };
  CHECK(run(1, {})->steps == 48);
  CHECK(run(1, {})->frames == 25);
  CHECK(run(0, {})->steps == 0);
  const Result<Simulated> full = run(10, [](std::int32_t frame, auto) -> Status {
    return frame < 5 ? Status(Done{}) : Error{ErrorCode::io, "disk full", "x"};
  });
  REQUIRE_FALSE(full.ok());
  CHECK(full.error().message == "disk full");
  const Result<Simulated> stopped = run(10, [&](std::int32_t frame, auto) -> Status {
    if (frame == 7) cancel.request();
    return Done{};
  });
  REQUIRE(stopped.ok());
  CHECK(stopped->cancelled);
  CHECK(stopped->steps == 14);
  CHECK(stopped->frames == 8);
}

TEST_CASE("a job writes a file that reads back and keeps it when it is stopped") {
  const scene::Scene scene = hall();
  SimulateJob job = power_law();
  job.seconds = 2;
  const std::filesystem::path path = temporary("run.csv");
  const Result<Simulated> done = simulate_job(scene, job, path.string());
  REQUIRE(done.ok());
  const Result<scene::Trajectories> read = io::read_trajectories(path);
  REQUIRE(read.ok());
  CHECK(read->fixes.size() == 36 * 49);
  CHECK(read->frame_rate == doctest::Approx(24));
  CHECK(read->fixes.front().x == doctest::Approx(101.5));
  // Stopped after 48 of 96 steps: 25 frames.
  core::Cancel cancel;
  job.cancel = &cancel;
  job.progress = [&](double part, std::string_view) {
    if (part >= 0.5) cancel.request();
  };
  REQUIRE(simulate_job(scene, job, path.string()).ok());
  CHECK(io::read_trajectories(path)->fixes.size() == 36 * 25);
  // What cannot be run leaves the file as it was.
  job.cancel = nullptr, job.step = 5;
  CHECK_FALSE(simulate_job(scene, job, path.string()).ok());
  CHECK(io::read_trajectories(path)->fixes.size() == 36 * 25);
  std::filesystem::remove(path);
  CHECK_FALSE(simulate_job(scene, power_law(), temporary("run.docx").string()).ok());
}

TEST_CASE("what became of people is said") {
  scene::Scene scene = hall();
  scene.crowd.populations[0].count = 50;
  scene::Population nobody = scene.crowd.populations[0], doubled = nobody;
  nobody.id = "nobody", nobody.count = 0;
  doubled.id = "doubled", doubled.count = 4;
  scene.crowd.populations.push_back(nobody);
  scene.crowd.populations.push_back(doubled);
  SimulateJob job = power_law();
  job.seconds = 0;
  const Result<Simulated> done = simulate_job(scene, job, "");
  REQUIRE(done.ok());
  const std::vector<std::string> warnings = done->warnings();
  REQUIRE(warnings.size() == 3);
  CHECK(has(warnings[0], "\"people\": 36 of 50 people placed"));
  CHECK(has(warnings[1], "\"nobody\": it has nobody in it"));
  CHECK(has(warnings[2], "\"doubled\": 4 people stood"));
}

TEST_CASE("models are chosen by name and their parameters set by name") {
  const scene::CrowdModel of_scene = scene::OrcaModel{7, 2, 10, 12};
  CHECK(*choose_model(of_scene, {}) == of_scene);
  CHECK(*choose_model(of_scene, {.model = "orca", .set = {"horizon=3"}}) ==
        scene::CrowdModel(scene::OrcaModel{3, 2, 10, 12}));
  CHECK(std::holds_alternative<scene::PowerLawModel>(*choose_model(of_scene, {.model = "power-law"})));
  const Result<scene::CrowdModel> pbd =
      choose_model(of_scene, {.model = "pbd", .preset = "game", .far = "avoidance", .set = {"iterations=12"}});
  REQUIRE(pbd.ok());
  scene::PbdModel expected = scene::PbdModel::of_preset(scene::PbdModel::Preset::game);
  expected.far = 2, expected.iterations = 12;
  CHECK(std::get<scene::PbdModel>(*pbd) == expected);
  CHECK(std::get<scene::PbdModel>(*choose_model(*pbd, {.set = {"far=long-range"}})).far == 1);
  for (const std::string_view name : model_names()) CHECK(has(model_parameter_lines(), std::string(name) + ":\n"));
}

TEST_CASE("wrong names and values of models are named with the nearest that is right") {
  const scene::CrowdModel orca = scene::OrcaModel{};
  CHECK(has(message(choose_model(orca, {.model = "orka"})), "did you mean \"orca\""));
  CHECK(has(message(choose_model(orca, {.preset = "game"})), "--preset"));
  CHECK(has(message(choose_model(orca, {.far = "off"})), "--far"));
  CHECK(has(message(choose_model(orca, {.model = "pbd", .far = "longrange"})), "did you mean \"long-range\""));
  CHECK(has(message(choose_model(orca, {.set = {"horizn=3"}})), "did you mean \"horizon\""));
  CHECK(has(message(choose_model(orca, {.set = {"horizon"}})), "NAME=VALUE"));
  CHECK(has(message(choose_model(orca, {.set = {"horizon=-1"}})), "outside [0.01, 1000] s"));
  CHECK(has(message(choose_model(orca, {.set = {"horizon=nan"}})), "outside"));
  CHECK(has(message(choose_model(orca, {.set = {"horizon=3s"}})), "no number"));
  CHECK(has(message(choose_model(orca, {.set = {"neighbours=2.5"}})), "no whole number"));
  CHECK_FALSE(planner_of("feild").ok());
  CHECK(*planner_of("field") == scene::Planner::field);
}
