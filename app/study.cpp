#include <filesystem>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/study_job.h"
#include "session/study_page.h"

namespace inhabit::app {
namespace {

struct Make {
  std::string plan, out, name = "room", title, task;
  std::vector<std::string> human, syntheses;
  session::StudyPageOptions page;
  bool no_labels = false, quiet = false;
};

struct Analyse {
  std::vector<std::string> files;
  std::string csv;
  bool paper = false, json = false, quiet = false;
};

constexpr const char* kFooter =
    "make writes one HTML page that shows people pairs of pictures and keeps their answers; analyse counts the "
    "answers.\n"
    "Examples:\n"
    "  inhabit study make --human designed.json --synthesis furnished.json -o study.html\n"
    "  inhabit study make study.json -o study.html\n"
    "  inhabit study analyse answers-*.json\n"
    "inhabit study make --help and inhabit study analyse --help say more; docs/study.md has it all.";

constexpr const char* kMakeFooter =
    "A picture is a file (.png, .jpg, .gif, .webp, .svg) or a scene, which is drawn. --synthesis may be NAME=FILE; "
    "else\n"
    "they are called A1, A2, … Several rooms, or several views of each, stand in PLAN:\n"
    "  {\"scenes\": [{\"name\": \"bedroom\", \"human\": \"designed.json\",\n"
    "               \"syntheses\": {\"A1\": \"furnished.json\", \"A2\": \"other.json\"}}]}\n"
    "The page needs no network: open it from the disk. #seed=12ab behind its address repeats an order.\n"
    "Examples:\n"
    "  inhabit study make --human designed.json --synthesis b1.json b2.json -o study.html\n"
    "  inhabit study make --human plan.png --synthesis annealed=plan-1.png projected=plan-2.png -o study.html\n"
    "  inhabit study make study.json --grey 2 -o study.html";

constexpr const char* kAnalyseFooter =
    "ANSWERS are the files that the page saves, one or more participants each, or counts: CSV with the columns scene,\n"
    "synthesis, human and of, or JSON {\"counts\": [{\"scene\": …, \"synthesis\": …, \"human\": 31, \"of\": 50}]}.\n"
    "Examples:\n"
    "  inhabit study analyse answers-*.json\n"
    "  inhabit study analyse answers/*.json --json\n"
    "  inhabit study analyse docs/yu11-counts.csv --paper --csv table.csv";

/// The plan of one room, from the command line.
core::Result<scene::StudyPlan> plan_of(const Make& m) {
  if (m.human.empty() || m.syntheses.empty())
    return core::invalid("", "needs PLAN, or --human and --synthesis with a picture or a scene each");
  scene::StudyScene room{m.name, m.human, {}};
  for (const std::string& text : m.syntheses) {
    const std::size_t equals = text.find('=');
    std::error_code error;
    const bool named = equals != std::string::npos && equals > 0 && !std::filesystem::exists(text, error);
    scene::StudyPlate plate{named ? text.substr(0, equals) : "A" + std::to_string(room.syntheses.size() + 1), {}};
    plate.pictures = {named ? text.substr(equals + 1) : text};
    room.syntheses.push_back(std::move(plate));
  }
  return scene::StudyPlan{"", "", {std::move(room)}};
}

int make(Make& m) {
  if (!m.plan.empty() && (!m.human.empty() || !m.syntheses.empty()))
    return complain("PLAN names the pictures already; --human and --synthesis stand without it"), kError;
  if (!can_save(m.out)) return kError;
  core::Result<scene::StudyPlan> plan = m.plan.empty() ? plan_of(m) : session::open_study_plan(m.plan);
  if (!plan) return m.plan.empty() ? (complain(plan.error().text()), kError) : fail(m.plan, plan.error());
  if (!m.title.empty()) plan->title = m.title;
  if (!m.task.empty()) plan->task = m.task;
  m.page.folder = std::filesystem::path(m.plan).parent_path().string();
  m.page.labels = !m.no_labels;
  const core::Result<std::string> page = session::study_page(*plan, m.page);
  if (!page) return m.plan.empty() ? (complain(page.error().text()), kError) : fail(m.plan, page.error());
  if (!save(m.out, page)) return kError;
  std::size_t pairs = 0;
  for (const scene::StudyScene& room : plan->scenes) pairs += room.syntheses.size();
  if (!m.quiet)
    print(m.out + ": " + std::to_string(pairs) + (pairs == 1 ? " pair, shown" : " pairs, each shown") +
          " twice; open it in a browser\n");
  return kDone;
}

int analyse(Analyse& a) {
  if (!can_save(a.csv)) return kError;
  std::vector<session::StudyFile> files;
  for (const std::string& name : a.files) {
    core::Result<scene::StudyData> data = session::open_study_data(name);
    if (!data) return fail(name, data.error());
    files.push_back({name, std::move(*data)});
  }
  const core::Result<session::StudyReport> report = session::study_analyse(files, a.paper);
  if (!report) return complain(report.error().text()), kError;
  if (!a.csv.empty() && !save(a.csv, session::study_csv(*report))) return kError;
  if (a.json)
    print(session::study_json(*report));
  else if (!a.quiet)
    print(session::study_text(*report));
  return kDone;
}

void add_make(CLI::App& verb, Make& m) {
  verb.add_option("PLAN", m.plan, "Which pictures to compare, in JSON; its paths begin where it lies");
  verb.add_option("--human", m.human, "What a person designed: a picture or a scene; several are views of it")
      ->type_name("FILE")
      ->expected(1);
  verb.add_option("--synthesis", m.syntheses, "What is compared with it; one or more, may be repeated")
      ->type_name("[NAME=]FILE")
      ->expected(1, -1);
  verb.add_option("--name", m.name, "Of the room, with --human")->capture_default_str();
  verb.add_option("-o,--output", m.out, "The page")->type_name("FILE")->required();
  verb.add_option("--title", m.title, "Of the page; else the plan's");
  verb.add_option("--task", m.task,
                  "What people are asked; else the plan's, or which one they would prefer to live in");
  verb.add_option("--grey", m.page.grey, "Seconds of grey between two pairs")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  verb.add_flag("--no-labels", m.no_labels, "Scenes: no names in the furniture");
  verb.add_flag("-q,--quiet", m.quiet, "Say nothing");
  verb.footer(kMakeFooter);
}

void add_analyse(CLI::App& verb, Analyse& a) {
  verb.add_option("ANSWERS", a.files, "Answers or counts")->required()->expected(1, -1);
  verb.add_flag("--paper", a.paper,
                "Chi-square as Yu et al. 2011 printed it: one of the two cells, with Yates' correction");
  verb.add_option("--csv", a.csv, "Write the pairs' rows into this file")->type_name("FILE");
  verb.add_flag("--json", a.json, "One JSON object on standard output and nothing else there");
  verb.add_flag("-q,--quiet", a.quiet, "No tables");
  verb.footer(kAnalyseFooter);
}

}  // namespace

std::function<int()> set_up_study(CLI::App& verb) {
  const auto m = std::make_shared<Make>();
  const auto a = std::make_shared<Analyse>();
  CLI::App* maker = verb.add_subcommand("make", "Write the page that shows the pairs");
  CLI::App* analyser = verb.add_subcommand("analyse", "Say what the answers mean");
  for (CLI::App* part : {maker, analyser}) part->allow_extras()->set_help_flag("-h,--help", "Print this");
  add_make(*maker, *m);
  add_analyse(*analyser, *a);
  verb.footer(kFooter);
  return [m, a, maker, analyser] {
    if (maker->parsed()) return make(*m);
    if (analyser->parsed()) return analyse(*a);
    return complain("study needs make or analyse (inhabit study --help says more)"), static_cast<int>(kError);
  };
}

}  // namespace inhabit::app
