#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/sweethome3d_plan.h"

/// Changes to Home.xml as text, so that everything else keeps its bytes.
namespace inhabit::io::sh3d {

/// `length` bytes at `offset` are replaced by `text`.
struct Edit {
  std::size_t offset = 0, length = 0;
  std::string text;
};

/// The text with all edits made. Requires: they do not overlap.
std::string edited(std::string_view xml, std::vector<Edit> edits);

/// Sets an attribute of the element whose name stands at `element` in the text: its value is replaced, or it is added
/// behind the name.
Edit set_attribute(std::string_view xml, std::size_t element, std::string_view name, std::string_view value);

/// Edits that remove references to content that the archive does not hold; `removed` counts them per attribute.
struct Stripped {
  std::vector<Edit> edits;
  std::size_t models = 0, icons = 0, images = 0;
};
Stripped strip_missing(std::string_view xml, const pugi::xml_document& document, const std::set<std::string>& entries);

/// A number as Sweet Home 3D keeps it: the shortest text of a float.
std::string float_text(double value);

/// Text for an attribute in single quotes: & < > ' and control characters escaped.
std::string escaped(std::string_view text);

}  // namespace inhabit::io::sh3d
