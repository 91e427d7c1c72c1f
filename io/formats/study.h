#pragma once
#include <string>
#include <string_view>

#include "core/result.h"
#include "scene/study.h"

/// The files of a study (docs/study.md): its plan, the answers that its page collects, and counts.
namespace inhabit::io {

/// The plan: JSON. Errors also: no scene, a scene or a synthesis twice, a plate without a picture.
core::Result<scene::StudyPlan> read_study_plan(std::string_view text);

/// Answers or counts as JSON, counts also as CSV with a head that names scene, synthesis, human and of. Errors also:
/// the same participant or the same pair of names twice, more chosen than shown. Places of CSV are lines.
core::Result<scene::StudyData> read_study_data(std::string_view text);

/// Reading it gives the same data.
std::string write_study_data(const scene::StudyData& data);

/// The text as one field of CSV, in quotation marks where it needs them (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace inhabit::io
