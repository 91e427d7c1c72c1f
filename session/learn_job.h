#pragma once
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exemplar/learn.h"
#include "session/document.h"

/// Furnished rooms of any format become a priors file (`inhabit learn`).
namespace inhabit::session {

struct LearnJob {
  exemplar::LearnOptions options;
  scene::Priors keep;  ///< what a person wrote (`by_hand`) in these stands in place of what is learned
};

/// Every room of every document is an exemplar. Rooms of homes are named "home: room". Errors: exemplar::learn's.
Result<exemplar::Learned> learn_job(std::span<const Document> documents, const LearnJob& job);

/// The priors in a file. Errors name the place.
Result<scene::Priors> open_priors(const std::string& path);
std::string write_priors_text(const scene::Priors& priors);

/// What was learned, for people: counts, pairs with their evidence, notes.
std::string learn_text(const exemplar::Learned& learned);
/// One object: what was learned from, the pairs with their evidence, the notes, and the priors when asked.
std::string learn_json(const exemplar::Learned& learned, bool with_priors);

/// Everything on one page, in the format of the file's name.
Result<std::string> explain_picture(const exemplar::Learned& learned, std::string_view title,
                                    std::string_view file_name);
/// One picture a kind and a pair, as PNG: "kind-bed.png", "pair-table-chair.png".
Result<std::vector<std::pair<std::string, std::string>>> explain_pictures(const exemplar::Learned& learned);

}  // namespace inhabit::session
