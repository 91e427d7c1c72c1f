#pragma once
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// Short words for writing a scene in C++: one call per object or constraint, in the order of the document.
namespace inhabit::session {
using namespace scene;

/// A rectangle with a corner at the origin; walls: 0 front (y = 0), 1 right, 2 back, 3 left.
Space rectangular_space(double width, double depth, double height = 2.6);

/// "chair-3".
std::string numbered(std::string_view kind, std::size_t number);

Ref add_object(Scene& scene, Object object);
Ref add_object(Scene& scene, std::string id, std::string kind, Vec3 size, Clearance clearance = {});
Ref add_group(Scene& scene, Group group);

inline Members list_of(std::vector<Ref> refs) { return {std::move(refs), {}}; }

void keep_distance(Scene& scene, Ref a, Ref b, double distance);
void keep_apart(Scene& scene, Ref a, Ref b, double min);
/// Every member at `distance` from the focal object, which this never moves when `fixed`.
void gather_round(Scene& scene, Ref focal, std::vector<Ref> members, double distance, bool fixed = false);
void centre_at(Scene& scene, std::vector<Ref> members, Vec2 point);
/// The members look at `to`.
void look_at(Scene& scene, std::vector<Ref> members, Ref to);
/// The members' heading is the heading of `to` plus `angle`.
void run_parallel(Scene& scene, std::vector<Ref> members, Ref to, double angle = 0);
/// The members' backs at `distance` from a wall.
void stand_at_wall(Scene& scene, std::vector<Ref> members, double distance, std::optional<int> wall = {});
/// The members turned by `angle` from the wall's inward normal: 0 = back to the wall.
void turn_from_wall(Scene& scene, std::vector<Ref> members, double angle = 0, std::optional<int> wall = {});
void stack(Scene& scene, Ref upper, Ref on);

/// Area of the footprints on the floor (what is stacked on something else does not count) over the area of the floor.
double floor_coverage(const Scene& scene);

}  // namespace inhabit::session
