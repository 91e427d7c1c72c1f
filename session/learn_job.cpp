#include "session/learn_job.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "io/file.h"
#include "io/formats/priors_json.h"
#include "render/priors_page.h"
#include "scene/kind.h"
#include "session/table.h"

namespace inhabit::session {
namespace {

using exemplar::Learned;

/// What a person wrote, in place of what was learned; without examples there is nothing to draw.
void keep_by_hand(Learned& learned, const scene::Priors& keep) {
  for (const scene::KindPrior& prior : keep.kinds) {
    if (!prior.by_hand) continue;
    auto& kinds = learned.priors.kinds;
    const auto at = std::ranges::lower_bound(kinds, prior.kind, {}, &scene::KindPrior::kind);
    const auto index = at - kinds.begin();
    if (at != kinds.end() && at->kind == prior.kind) {
      *at = prior, learned.kinds[static_cast<std::size_t>(index)] = {};
    } else {
      kinds.insert(at, prior), learned.kinds.insert(learned.kinds.begin() + index, scene::KindEvidence{});
    }
  }
  for (const scene::PairPrior& prior : keep.pairs) {
    if (!prior.by_hand) continue;
    auto& pairs = learned.priors.pairs;
    const auto same = [&](const scene::PairPrior& p) {
      return (p.first == prior.first && p.second == prior.second) ||
             (p.first == prior.second && p.second == prior.first);
    };
    for (auto it = pairs.begin(); (it = std::find_if(it, pairs.end(), same)) != pairs.end();) {
      learned.pairs.erase(learned.pairs.begin() + (it - pairs.begin()));
      it = pairs.erase(it);
    }
    const auto at = std::ranges::find_if(pairs, [&](const scene::PairPrior& p) {
      return std::tie(p.first, p.second) > std::tie(prior.first, prior.second);
    });
    learned.pairs.insert(learned.pairs.begin() + (at - pairs.begin()), scene::PairEvidence{});
    pairs.insert(at, prior);
  }
}

Table pair_table(const Learned& learned) {
  Table table{"pairs", "Pairs", {}, {}, {}};
  table.columns = {{"first"},   {"second"},        {"examples", 0}, {"rooms", 0}, {"to one", 1},
                   {"ways", 0}, {"distance m", 2}, {"spread %", 0}, {"how"}};
  for (const scene::PairPrior& p : learned.priors.pairs)
    table.rows.push_back({p.first, p.second, static_cast<double>(p.count), static_cast<double>(p.rooms), p.per_first,
                          static_cast<double>(p.modes.size()), p.modes.front().distance, 100 * p.spread,
                          std::string(p.by_hand ? "named" : "proposed") + (p.concentric ? ", concentric" : "")});
  return table;
}

Table kind_table_of(const Learned& learned) {
  Table table{"kinds", "Kinds", {}, {}, {}};
  table.columns = {{"kind"},      {"examples", 0},     {"rooms", 0},   {"ways", 0},
                   {"wall m", 2}, {"wall degrees", 0}, {"share %", 0}, {"stands on"}};
  for (const scene::KindPrior& k : learned.priors.kinds) {
    std::vector<Cell> row = {k.kind, static_cast<double>(k.count), static_cast<double>(k.rooms),
                             static_cast<double>(k.wall.size())};
    if (k.wall.empty()) {
      row.insert(row.end(), 3, Cell());
    } else {
      double all = 0;
      for (const scene::WallMode& m : k.wall) all += m.count;
      row.insert(row.end(), {k.wall[0].distance, degrees(k.wall[0].angle), 100 * k.wall[0].count / all});
    }
    static constexpr std::array<const char*, 3> kMounts = {"floor", "wall", "ceiling"};
    const bool carried = !k.support.empty() && !k.support[0].on.empty();
    row.push_back(k.support.empty() ? Cell()
                  : carried         ? Cell(k.support[0].on)
                                    : Cell(kMounts[static_cast<std::size_t>(k.support[0].mount)]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string file_word(std::string_view kind) {
  std::string word = scene::words_of(kind, '-');
  std::erase_if(word, [](char c) { return c == '/'; });
  return word;
}

}  // namespace

Result<Learned> learn_job(std::span<const Document> documents, const LearnJob& job) {
  std::vector<Scene> rooms;
  for (const Document& document : documents) {
    const std::string home = std::filesystem::path(document.name).stem().string();
    for (const Scene& scene : document.scenes) {
      rooms.push_back(scene);
      if (document.home) rooms.back().name = home + ": " + scene.name;
      if (rooms.back().name.empty()) rooms.back().name = home;
    }
  }
  Result<Learned> learned = exemplar::learn(rooms, job.options);
  if (learned) keep_by_hand(*learned, job.keep);
  return learned;
}

Result<scene::Priors> open_priors(const std::string& path) {
  const Result<std::string> bytes = io::read_file(path);
  if (!bytes) return bytes.error();
  return io::read_priors(*bytes);
}

std::string write_priors_text(const scene::Priors& priors) { return io::write_priors(priors); }

std::string learn_text(const Learned& learned) {
  const std::size_t rooms = learned.priors.rooms.size();
  std::string text = std::to_string(learned.things) + " things of " + std::to_string(learned.priors.kinds.size()) +
                     " kinds in " + std::to_string(rooms) + (rooms == 1 ? " room\n" : " rooms\n");
  text += table_text(kind_table_of(learned));
  if (!learned.priors.pairs.empty()) text += table_text(pair_table(learned));
  for (const std::string& note : learned.notes) text += "note: " + note + "\n";
  return text;
}

std::string learn_json(const Learned& learned, bool with_priors) {
  nlohmann::ordered_json json;
  json["rooms"] = learned.priors.rooms;
  json["things"] = learned.things;
  json["kinds"] = learned.priors.kinds.size();
  json["pairs"] = nlohmann::ordered_json::parse(table_json(pair_table(learned)))["rows"];
  json["notes"] = learned.notes;
  if (with_priors) json["priors"] = nlohmann::ordered_json::parse(io::write_priors(learned.priors));
  return json.dump() + "\n";
}

Result<std::string> explain_picture(const Learned& learned, std::string_view title, std::string_view file_name) {
  const std::optional<render::Format> format = render::format_of(file_name);
  if (!format) return Error{ErrorCode::unsupported, "a picture is written as .svg, .png or .pdf", ""};
  const render::Drawing page = render::draw_priors(learned.priors, learned.kinds, learned.pairs, title);
  // A pixel a point, so that small text can be read, as far as a picture goes.
  const double side = std::clamp(1.5 * std::max(page.size.x, page.size.y), 1600.0, 16384.0);
  return render::encode(page, *format, {static_cast<int>(side)});
}

Result<std::vector<std::pair<std::string, std::string>>> explain_pictures(const Learned& learned) {
  std::vector<std::pair<std::string, std::string>> files;
  const auto add = [&](std::string name, const render::Drawing& card) -> Status {
    Result<std::string> bytes = render::encode(card, render::Format::png, {1280});
    if (!bytes) return bytes.error();
    files.emplace_back(std::move(name), std::move(*bytes));
    return Done{};
  };
  for (std::size_t i = 0; i < learned.kinds.size(); ++i) {
    const scene::KindPrior& prior = learned.priors.kinds[i];
    if (const Status drawn =
            add("kind-" + file_word(prior.kind) + ".png", render::draw_kind_card(prior, learned.kinds[i]));
        !drawn)
      return drawn.error();
  }
  for (std::size_t i = 0; i < learned.pairs.size(); ++i) {
    const scene::PairPrior& prior = learned.priors.pairs[i];
    if (const Status drawn = add("pair-" + file_word(prior.first) + "-" + file_word(prior.second) + ".png",
                                 render::draw_pair_card(prior, learned.pairs[i]));
        !drawn)
      return drawn.error();
  }
  return files;
}

}  // namespace inhabit::session
