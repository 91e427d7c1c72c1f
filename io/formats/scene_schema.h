#pragma once
#include <string>

/// What a scene document may hold, written down from the tables that the reader uses. The texts are kept in docs/;
/// after a change of the tables run the tests once with INHABIT_UPDATE_DOCS=1.
namespace inhabit::io {

/// JSON Schema, draft 7. The reader is stricter: it also resolves names and looks at the geometry.
std::string scene_schema();

/// Markdown: every constraint with its members, units, ranges and defaults.
std::string constraints_page();

/// Markdown: every model of crowds with its parameters, units, ranges, and defaults or presets.
std::string crowd_models_page();

}  // namespace inhabit::io
