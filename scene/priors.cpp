#include "scene/priors.h"

#include "scene/kind.h"

namespace inhabit::scene {

std::string prior_kind(const Object& object) {
  std::string kind = words_of(object.kind, ' ');
  if (!kind.empty()) return kind;
  const std::string_view known = kind_of(object.name);
  return known.empty() ? words_of(object.name, ' ') : std::string(known);
}

}  // namespace inhabit::scene
