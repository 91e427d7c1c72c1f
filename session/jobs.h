#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "annealing/arrange.h"
#include "layout/check.h"
#include "layout/furnish.h"
#include "session/document.h"

/// What the command line, Python and the server ask for. Jobs take documents and give data, text or bytes; nothing here
/// reads a terminal, prints or ends the program.
namespace inhabit::session {

enum class Method {
  pbd,     ///< position-based projection (TVCG)
  anneal,  ///< simulated annealing towards learned priors (Yu et al. 2011)
  both     ///< annealed, then settled by projection
};

struct FurnishJob {
  Method method = Method::pbd;
  std::optional<Priors> priors;  ///< Requires: given unless the method is pbd
  annealing::Options anneal;     ///< seed, starts, threads, progress and cancel are those of `layout`
  layout::Options layout;
  int variants = 1;          ///< distinct suggestions for each room, best first
  bool house_rules = false;  ///< constraints by kind for rooms that state none
};

/// One arrangement of one room.
struct Suggestion {
  Scene scene;
  layout::CheckReport report;
  layout::Layout layout;  ///< the placement that the scene has, and how it was found
};

struct FurnishedRoom {
  std::string name;
  std::vector<Suggestion> suggestions;  ///< best first; empty when `error` says why
  std::vector<layout::TraceRow> trace;
  std::vector<annealing::TraceRow> anneal_trace;
  std::vector<std::string> notes;  ///< what people should know: weak priors, objects that found no wall
  std::optional<Error> error;
  double seconds = 0;
};

struct Furnished {
  std::vector<FurnishedRoom> rooms;
  bool cancelled = false;
  /// Every room has a suggestion that overlaps nothing and stays inside.
  bool feasible() const;
  /// Feasible, and every constraint is kept to 5 cm and 5 degrees; scenes with `house_rules` may miss some. Checked
  /// says the same of what document() gives.
  bool as_asked() const;
  /// The document with the k-th suggestion of every room (the last one where there are fewer).
  Document document(const Document& original, std::size_t k = 0) const;
};

/// Furnishes every room. A document of one scene that cannot be furnished is an error; a room among several keeps its
/// error and stays as it was.
Result<Furnished> furnish_job(const Document& document, const FurnishJob& job);
/// What came of it, for people: each room's time and check table, and every violated constraint.
std::string furnish_text(const Furnished& furnished);
/// One object; with the scenes themselves when asked.
std::string furnish_json(const Furnished& furnished, bool with_scenes);
/// start,iteration,energy,overlap,feasible,relocated
std::string trace_csv(const std::vector<layout::TraceRow>& trace);
/// start,iteration,temperature,cost and a column for each cost term, weighted
std::string trace_csv(const std::vector<annealing::TraceRow>& trace);
/// A weight of the annealing's cost by its term's name ("pair angle", also "pair-angle"). Errors name the nearest.
Status set_weight(annealing::Weights& weights, std::string_view name, double value);

struct CheckedRoom {
  std::string name;
  layout::CheckReport report;
  bool house_rules = false;  ///< the scene's
};

struct Checked {
  std::vector<CheckedRoom> rooms;
  bool feasible() const;
  /// Feasible, and every constraint is kept to 5 cm and 5 degrees; scenes with `house_rules` may miss some.
  bool as_asked() const;
};
/// The table of one check for people, and whether what it misses counts.
std::string check_text(const layout::CheckReport& report, bool house_rules);
Checked check_job(const Document& document, const layout::CheckOptions& options);
std::string check_text(const Checked& checked);
/// For one scene exactly the object of scene.md; for several `{"rooms": [{"name": …, …}]}`.
std::string check_json(const Checked& checked);

}  // namespace inhabit::session
