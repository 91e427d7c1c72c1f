#pragma once
#include <map>
#include <string>

#include "core/rng.h"
#include "session/scene_builder.h"

/// Short words for writing a furnished room in C++: one call a thing, with its place. Degrees here, radians in the
/// scene.
namespace inhabit::session {

/// A room that is being furnished. Ids are numbered by kind: "work-chair-3". With `loose` things stand a little off
/// their places, as people leave them: up to 2 cm along walls, up to 3 cm and 2 degrees elsewhere.
class RoomPlan {
 public:
  RoomPlan(std::string name, Ring outline, double height, std::uint64_t seed, bool loose = true);

  void door(std::string id, int wall, double from, double width = 0.9, Door::Hinge hinge = Door::Hinge::start);
  void window(int wall, double from, double width, double sill = 0.9, double window_height = 1.3);
  void pillar(Vec2 center, double side);

  /// Back to a wall, its middle `along` metres from the wall's first corner, `gap` from the wall.
  Ref wall(std::size_t wall, double along, std::string kind, Vec3 size, double gap = 0.02);
  /// On a wall, its base at `height`.
  Ref hang(std::size_t wall, double along, std::string kind, Vec3 size, double height);
  /// Anywhere on the floor.
  Ref stand(Vec2 p, double heading, std::string kind, Vec3 size);
  /// On the floor, seen from another thing: x to its right, y to its front; turned from its heading.
  Ref near(Ref other, Vec2 offset, double turn, std::string kind, Vec3 size);
  /// On another thing's top, likewise.
  Ref on(Ref carrier, Vec2 offset, double turn, std::string kind, Vec3 size);
  /// `count` of a kind evenly round a thing, looking at it.
  void round(Ref center, int count, double distance, std::string kind, Vec3 size, double first = 0);
  /// What asks to be seen: distance in metres, full opening in degrees.
  void view(Ref ref, double distance, double angle);

  double wall_length(std::size_t wall) const;
  Object& of(Ref ref) { return scene_.objects[ref.index]; }
  /// The room; `mirrored`: seen in a mirror, left and right changed, so that five plans are not one plan.
  Scene done(bool mirrored = false) const;

 private:
  Ref put(Vec3 position, double heading, std::string kind, Vec3 size);
  double off(double most) { return loose_ ? rng_.uniform(-most, most) : 0; }

  Scene scene_;
  std::map<std::string, std::size_t> numbers_;
  Rng rng_;
  bool loose_;
};

Ring rectangle(double width, double depth);
/// A scene seen in a mirror.
Scene mirrored(Scene scene);

}  // namespace inhabit::session
