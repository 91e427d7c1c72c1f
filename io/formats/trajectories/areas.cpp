#include "io/formats/trajectories/areas.h"

#include "core/text.h"
#include "io/formats/wkt.h"

namespace inhabit::io {
namespace {

void append_ring(std::string& out, const scene::Ring& ring) {
  out += '(';
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    const geometry::Vec2 p = ring[k % ring.size()];
    out.append(k == 0 ? "" : ", ").append(shortest(p.x)).append(" ").append(shortest(p.y));
  }
  out += ')';
}
void append_polygon(std::string& out, const scene::Area& area) {
  out += '(';
  append_ring(out, area.outline);
  for (const scene::Ring& hole : area.holes) append_ring(out += ", ", hole);
  out += ')';
}

}  // namespace

void take_walkable(std::string_view wkt, RawTrajectories& raw) {
  Result<std::vector<scene::Area>> areas = read_wkt_areas(wkt);
  if (!areas) {
    raw.remarks.push_back("the walkable area is not read: " + areas.error().text());
    return;
  }
  for (scene::Area& area : *areas) raw.walkable.push_back(std::move(area));
}

std::string walkable_text(std::span<const scene::Area> areas) {
  std::string out = areas.size() == 1 ? "POLYGON " : "MULTIPOLYGON (";
  for (std::size_t k = 0; k < areas.size(); ++k) append_polygon(out += k == 0 ? "" : ", ", areas[k]);
  return areas.size() == 1 ? out : out + ")";
}

}  // namespace inhabit::io
