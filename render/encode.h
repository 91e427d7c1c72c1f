#pragma once
#include "render/drawing.h"

namespace inhabit::render {

/// The drawing as SVG with real text. Requires: a page with area.
std::string encode_svg(const Drawing& drawing);

}  // namespace inhabit::render
