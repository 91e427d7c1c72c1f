#include <filesystem>
#include <memory>

#include "app/options.h"
#include "app/terminal.h"
#include "app/verbs.h"
#include "session/learn_job.h"
#include "session/pictures.h"

namespace inhabit::app {
namespace {

struct Learn {
  std::vector<std::string> exemplars, pairs;
  session::OpenOptions reading;
  session::LearnJob job;
  std::string out, keep, explain;
  bool no_proposals = false, json = false, quiet = false;
};

constexpr const char* kFooter =
    "EXEMPLAR is a furnished scene of any format, or the name of a built-in one; every room of a home or of a house is "
    "an\nexample. exemplar/bedroom names the five rooms exemplar/bedroom-1 to -5 (inhabit scenes lists them).\n"
    "PRIORS is JSON to read and edit: docs/priors.md. Lengths are metres, angles degrees.\n"
    "Examples:\n"
    "  inhabit learn exemplar/bedroom -o bedroom.priors.json --pair tv,armchair --explain bedroom.png\n"
    "  inhabit learn flat.sh3d house.sh3d -o home.priors.json --explain pictures/\n"
    "  inhabit learn train.jsonl.gz --assets asset-database.json -o procthor.priors.json\n"
    "  inhabit learn rooms/*.json -o p.json --keep mine.priors.json --no-proposals --json";

/// "A,B" as two kinds.
core::Status read_pairs(Learn& l) {
  for (const std::string& text : l.pairs) {
    const std::size_t comma = text.find(',');
    const bool two = comma != std::string::npos && comma > 0 && comma + 1 < text.size() &&
                     text.find(',', comma + 1) == std::string::npos;
    if (!two) return core::invalid("--pair", text + " is not two kinds like tv,sofa");
    l.job.options.pairs.emplace_back(text.substr(0, comma), text.substr(comma + 1));
  }
  return core::Done{};
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return path.ends_with('/') || std::filesystem::is_directory(path, error);
}

bool explain(const Learn& l, const core::Result<exemplar::Learned>& learned) {
  if (l.explain.empty()) return true;
  if (!is_folder(l.explain)) {
    const std::string title = "Learned from " + std::to_string(learned->priors.rooms.size()) + " rooms: " + l.out;
    return save(l.explain, session::explain_picture(*learned, title, l.explain));
  }
  std::error_code error;
  std::filesystem::create_directories(l.explain, error);
  const auto files = session::explain_pictures(*learned);
  if (!files) return fail(l.explain, files.error()), false;
  for (const auto& [name, bytes] : *files)
    if (!save((std::filesystem::path(l.explain) / name).string(), bytes)) return false;
  return true;
}

int run(Learn& l) {
  if (const core::Status pairs = read_pairs(l); !pairs) return complain(pairs.error().text()), kError;
  l.job.options.propose = !l.no_proposals;
  if (!can_save(l.out) || (!is_folder(l.explain) && !can_save(l.explain))) return kError;
  if (!l.explain.empty() && !is_folder(l.explain))
    if (const core::Status name = session::check_picture_name(l.explain); !name) return fail(l.explain, name.error());
  if (!l.keep.empty()) {
    const core::Result<scene::Priors> keep = session::open_priors(l.keep);
    if (!keep) return fail(l.keep, keep.error());
    l.job.keep = *keep;
  }
  std::vector<session::Document> documents;
  for (const std::string& name : l.exemplars) {
    const SceneArgument argument{name, {}, l.reading};
    std::optional<session::Document> document = open(argument, l.quiet || l.json);
    if (!document) return kError;
    documents.push_back(std::move(*document));
  }
  const core::Result<exemplar::Learned> learned = session::learn_job(documents, l.job);
  if (!learned) return complain(learned.error().text()), kError;
  if (!l.out.empty() && !save(l.out, session::write_priors_text(learned->priors))) return kError;
  if (!explain(l, learned)) return kError;
  if (l.json)
    print(session::learn_json(*learned, l.out.empty()));
  else if (!l.quiet)
    print(session::learn_text(*learned));
  return kDone;
}

}  // namespace

std::function<int()> set_up_learn(CLI::App& verb) {
  const auto l = std::make_shared<Learn>();
  verb.add_option("EXEMPLAR", l->exemplars, "Furnished rooms: files or names of built-in scenes")
      ->required()
      ->expected(1, -1);
  verb.add_option("-o,--output", l->out, "Priors file; without it only what was learned is printed")->type_name("FILE");
  verb.add_option("--pair", l->pairs, "Two kinds that belong together, first and second; may be repeated")
      ->type_name("A,B")
      ->expected(1)
      ->take_all();
  verb.add_flag("--no-proposals", l->no_proposals, "Only the pairs named, none proposed from the examples");
  verb.add_option("--keep", l->keep, "Priors file: what it says \"by_hand\" stands in place of what is learned")
      ->type_name("FILE");
  verb.add_option("--explain", l->explain,
                  "Draw what was learned: one page (.png, .svg, .pdf), or into a folder one picture a kind and a pair")
      ->type_name("FILE|DIR");
  verb.add_option("--assets", l->reading.asset_database,
                  "ProcTHOR houses: their asset-database.json, which has the sizes")
      ->type_name("FILE");
  verb.add_option("--line", l->reading.line, "ProcTHOR houses, one per line: only this one, from 1; 0 = all")
      ->check(not_negative, "")
      ->capture_default_str();
  verb.add_flag("--json", l->json,
                "One JSON object on standard output and nothing else there; with the priors unless -o is given");
  verb.add_flag("-q,--quiet", l->quiet, "No table, no warnings");
  verb.footer(kFooter);
  return [l] { return run(*l); };
}

}  // namespace inhabit::app
