#include "io/formats/scene_rules.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "geometry/extents.h"
#include "geometry/overlay.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// What lengths along walls and areas of holes may be off by, since files round.
constexpr double kSlack = 1e-6;

std::string at(std::string_view list, std::size_t i, std::string_view member = "") {
  std::string where(list);
  where += '/', where += std::to_string(i);
  if (!member.empty()) where += '/', where += member;
  return where;
}

template <class Opening>
Status check_openings(const Space& space, bool turned, const std::vector<Opening>& openings, std::string_view list) {
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const Opening& o = openings[i];
    if (o.wall < 0 || static_cast<std::size_t>(o.wall) >= space.walls())
      return invalid(at(list, i, "wall"), "there is no wall " + std::to_string(o.wall) +
                                              ", the outline has walls 0 to " + std::to_string(space.walls() - 1));
    const auto k = static_cast<std::size_t>(turned ? turned_wall(o.wall, space.walls()) : o.wall);
    const double wall = length(space.wall_end(k) - space.wall_start(k));
    if (o.from + o.width > wall + kSlack)
      return invalid(at(list, i), "from " + number_text(o.from) + " m, " + number_text(o.width) +
                                      " m wide, it ends beyond wall " + std::to_string(o.wall) + ", which is " +
                                      number_text(std::round(wall * 1e4) / 1e4) + " m long");
  }
  return Done{};
}

/// The first element of a cycle in "each has at most one parent"; -1 when there is none. `parent[i]` is -1 for none.
int find_cycle(const std::vector<int>& parent) {
  std::vector<std::size_t> seen(parent.size(), 0);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    for (std::size_t k = i; seen[k] == 0;) {
      seen[k] = i + 1;
      if (parent[k] < 0) break;
      k = static_cast<std::size_t>(parent[k]);
      if (seen[k] == i + 1) return static_cast<int>(k);
    }
  }
  return -1;
}

template <class Named>
Status check_names(const std::vector<Named>& list, std::string_view where) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].id.empty() && !names.insert(list[i].id).second)
      return invalid(at(where, i, "id"), quoted(list[i].id) + " is the name of another one before it");
  }
  return Done{};
}

}  // namespace

Status check_space(const Space& space, bool turned) {
  for (std::size_t i = 0; i < space.holes.size(); ++i) {
    const Ring& hole = space.holes[i].outline;
    const double outside = area_outside(hole, space.outline);
    if (outside <= kSlack) continue;
    const bool apart = outside >= std::abs(signed_area(hole)) - kSlack;
    return invalid(at("/space/holes", i, "outline"),
                   apart ? "the hole lies outside the outline" : "the hole crosses the outline");
  }
  if (const Status doors = check_openings(space, turned, space.doors, "/space/doors"); !doors) return doors;
  return check_openings(space, turned, space.windows, "/space/windows");
}

Status check_objects(const Scene& scene) {
  const Extents room(scene.space.outline);
  std::vector<int> carrier(scene.objects.size(), -1);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& o = scene.objects[i];
    if (o.fixed && !o.position) return invalid(at("/objects", i), quoted(o.id) + " is fixed but has no position");
    if (!o.fixed && room.too_small_for(o.size.x, o.size.y))
      return invalid(at("/objects", i, "size"), quoted(o.id) + " is larger than the room in every orientation");
    if (!o.on.none()) carrier[i] = static_cast<int>(o.on.index);
  }
  if (const int i = find_cycle(carrier); i >= 0) {
    const auto k = static_cast<std::size_t>(i);
    return invalid(at("/objects", k, "on"), quoted(scene.objects[k].id) + " stands, through others, on itself");
  }
  return Done{};
}

Status check_groups(const Scene& scene) {
  std::vector<int> of_object(scene.objects.size(), -1), of_group(scene.groups.size(), -1);
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    for (std::size_t m = 0; m < scene.groups[g].members.size(); ++m) {
      const Ref ref = scene.groups[g].members[m];
      int& group = ref.kind == Ref::Kind::group ? of_group[ref.index] : of_object[ref.index];
      if (group >= 0)
        return invalid(at("/groups", g, "members") + "/" + std::to_string(m),
                       quoted(scene.id_of(ref)) + " is in group " +
                           quoted(scene.groups[static_cast<std::size_t>(group)].id) + " already");
      group = static_cast<int>(g);
    }
  }
  if (const int g = find_cycle(of_group); g >= 0) {
    const auto k = static_cast<std::size_t>(g);
    return invalid(at("/groups", k, "members"), "group " + quoted(scene.groups[k].id) + " contains itself");
  }
  return Done{};
}

Status check_crowd(const Crowd& crowd) {
  if (const Status s = check_names(crowd.populations, "/crowd/populations"); !s) return s;
  if (const Status s = check_names(crowd.sources, "/crowd/sources"); !s) return s;
  if (const Status s = check_names(crowd.goals, "/crowd/goals"); !s) return s;
  for (std::size_t i = 0; i < crowd.sources.size(); ++i) {
    const Source& source = crowd.sources[i];
    if (source.until && *source.until < source.from)
      return invalid(at("/crowd/sources", i, "until"),
                     number_text(*source.until) + " s is before from, " + number_text(source.from) + " s");
  }
  return Done{};
}

void turn_walls(Space& space) {
  const auto turn = [&](auto& opening) {
    if (opening.wall < 0 || static_cast<std::size_t>(opening.wall) >= space.walls()) return;
    opening.wall = turned_wall(opening.wall, space.walls());
    const auto k = static_cast<std::size_t>(opening.wall);
    const double rest = length(space.wall_end(k) - space.wall_start(k)) - opening.from - opening.width;
    opening.from = std::max(rest, 0.0);
  };
  for (Door& door : space.doors) {
    turn(door);
    door.hinge = door.hinge == Door::Hinge::start ? Door::Hinge::end : Door::Hinge::start;
  }
  for (Window& window : space.windows) turn(window);
}

}  // namespace inhabit::io
