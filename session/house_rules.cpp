#include "session/house_rules.h"

#include <algorithm>
#include <array>

#include "scene/kind.h"
#include "session/scene_builder.h"

namespace inhabit::session {
namespace {

enum class Place { wall, anywhere };

struct HouseRule {
  std::string_view kind;
  Place place = Place::wall;
  Clearance clearance;
};

/// Depths in metres: a person passes at 0.5, opens a door or a drawer at 0.6.
constexpr std::array kRules = {
    HouseRule{"bed", Place::wall, {0.4, 0, 0, 0}},
    HouseRule{"bunk bed", Place::wall, {}},
    HouseRule{"bedside table", Place::wall, {}},
    HouseRule{"wardrobe", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"dresser", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"chest", Place::wall, {0.4, 0, 0, 0}},
    HouseRule{"bookcase", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"filing cabinet", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"cupboard", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"kitchen cabinet", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"counter", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"fridge", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"chest freezer", Place::wall, {0.4, 0, 0, 0}},
    HouseRule{"cooker", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"dishwasher", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"washing machine", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"sink", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"washbasin", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"toilet", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"bidet", Place::wall, {0.5, 0, 0, 0}},
    HouseRule{"bath", Place::wall, {}},
    HouseRule{"shower", Place::wall, {}},
    HouseRule{"tv stand", Place::wall, {0.8, 0, 0, 0}},
    HouseRule{"piano", Place::wall, {0.6, 0, 0, 0}},
    HouseRule{"dressing table", Place::wall, {}},
    HouseRule{"desk", Place::wall, {}},
    HouseRule{"sofa", Place::wall, {0.4, 0, 0, 0}},
    HouseRule{"aquarium", Place::wall, {}},
    HouseRule{"coat rack", Place::wall, {}},
    HouseRule{"floor lamp", Place::wall, {}},
    HouseRule{"plant", Place::wall, {}},
    HouseRule{"trash can", Place::wall, {}},
    HouseRule{"side table", Place::wall, {}},
};

std::string_view kind_name(const Object& object) {
  const std::string_view kind = kind_of(object.kind);
  return kind.empty() ? kind_of(object.name) : kind;
}

bool is_any_of(std::string_view kind, std::initializer_list<std::string_view> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// What a house rule may move: furniture that stands on the floor.
bool is_free_furniture(const Object& o) { return !o.fixed && o.mount == Mount::floor && o.on.none(); }

struct Household {
  std::vector<Ref> at_wall, chairs, office_chairs, tables, desks, viewers, beds, bedside, coffee_tables, sofas,
      televisions;
};

Household sort_out(const Scene& scene) {
  Household h;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const Ref ref{Ref::Kind::object, i};
    const std::string_view kind = kind_name(object);
    if (kind == "tv stand") h.televisions.push_back(ref);
    if (is_any_of(kind, {"dining table", "table", "kitchen island", "pool table"})) h.tables.push_back(ref);
    if (is_any_of(kind, {"desk", "dressing table", "piano"})) h.desks.push_back(ref);
    if (kind == "bed") h.beds.push_back(ref);
    if (kind == "sofa") h.sofas.push_back(ref);
    if (!is_free_furniture(object)) continue;
    if (is_any_of(kind, {"chair", "stool"})) h.chairs.push_back(ref);
    if (is_any_of(kind, {"office chair", "piano bench"})) h.office_chairs.push_back(ref);
    if (is_any_of(kind, {"sofa", "armchair"})) h.viewers.push_back(ref);
    if (kind == "bedside table") h.bedside.push_back(ref);
    if (kind == "coffee table") h.coffee_tables.push_back(ref);
    const bool wall = std::any_of(kRules.begin(), kRules.end(),
                                  [&](const HouseRule& r) { return r.kind == kind && r.place == Place::wall; });
    if (wall) h.at_wall.push_back(ref);
  }
  return h;
}

/// Each seat at one of the tables, dealt out in turn: near enough to reach it, looking at it.
void seat(Scene& scene, const std::vector<Ref>& seats, const std::vector<Ref>& tables) {
  for (std::size_t i = 0; i < seats.size() && !tables.empty(); ++i) {
    const Ref table = tables[i % tables.size()];
    const Vec3 t = scene.objects[table.index].size, c = scene.objects[seats[i].index].size;
    Distance near;
    near.between = {seats[i], table};
    near.max = std::hypot(t.x, t.y) / 2 + c.y / 2 + 0.1;
    scene.constraints.add(near);
    look_at(scene, {seats[i]}, table);
  }
}

void keep_within(Scene& scene, Ref a, Ref b, double gap) {
  const Vec3 p = scene.objects[a.index].size, q = scene.objects[b.index].size;
  Distance near;
  near.between = {a, b};
  near.max = (std::hypot(p.x, p.y) + std::hypot(q.x, q.y)) / 2 + gap;
  scene.constraints.add(near);
}

}  // namespace

Scene with_house_rules(Scene scene) {
  if (scene.constraints.size() > 0) return scene;
  for (Object& object : scene.objects) {
    if (object.clearance.any()) continue;
    for (const HouseRule& rule : kRules)
      if (rule.kind == kind_name(object)) object.clearance = rule.clearance;
  }
  const Household h = sort_out(scene);
  if (!h.at_wall.empty()) {
    stand_at_wall(scene, h.at_wall, 0.02);
    turn_from_wall(scene, h.at_wall);
  }
  seat(scene, h.office_chairs, h.desks.empty() ? h.tables : h.desks);
  seat(scene, h.chairs, h.tables.empty() ? h.desks : h.tables);
  if (!h.televisions.empty() && !h.viewers.empty()) look_at(scene, h.viewers, h.televisions.front());
  for (std::size_t i = 0; i < h.bedside.size() && !h.beds.empty(); ++i)
    keep_within(scene, h.bedside[i], h.beds[i % h.beds.size()], 0);
  for (std::size_t i = 0; i < h.coffee_tables.size() && !h.sofas.empty(); ++i)
    keep_within(scene, h.coffee_tables[i], h.sofas[i % h.sofas.size()], 0.4);
  return scene;
}

}  // namespace inhabit::session
