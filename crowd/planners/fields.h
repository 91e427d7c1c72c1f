#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "crowd/planners/fields_kernel.h"
#include "crowd/planners/place.h"
#include "crowd/planners/walkable.h"

/// One field of directions for each goal that many share: an agent looks its way up, whatever the walls between.
namespace inhabit::crowd {

/// All fields of a world, on one lattice.
class Fields {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  Fields() = default;
  /// `targets`: for each field the places of which the nearest on foot counts. `body`: metres, of the widest.
  Fields(const World& world, const std::vector<std::vector<const Place*>>& targets, double body, int threads);

  std::size_t count() const { return walkable_.lattice.size() == 0 ? 0 : distance_.size() / walkable_.lattice.size(); }
  const Walkable& walkable() const { return walkable_; }
  /// The eikonal distance of every cell, infinite where no way leads from. Near walls a metre counts up to three.
  std::span<const float> weighted_distance(std::size_t field) const {
    return std::span(distance_).subspan(field * walkable_.lattice.size(), walkable_.lattice.size());
  }

  /// For agents i with field[i] != kNone, wish = speed * the unit vector of the way; nothing where there is no way.
  /// Other agents are left alone. The arrays are parallel.
  void look_up(std::span<const std::uint32_t> field, std::span<const float> x, std::span<const float> y,
               std::span<const float> speed, std::span<float> wish_x, std::span<float> wish_y) const;
  /// The lattice and the directions, without agents.
  fields_kernel::Lookup lookup() const;
  /// The unit vector of the way from one point.
  Region::Way way(std::size_t field, float x, float y) const;
  /// Metres on foot along the field to its goal; infinite when no way leads there. Cost: a step for every half cell.
  double distance(std::size_t field, float x, float y) const;

 private:
  void solve(std::size_t field, const std::vector<const Place*>& places);

  Walkable walkable_;
  std::vector<float> distance_;           ///< [field][cell]
  std::vector<std::uint32_t> direction_;  ///< [field][cell]: x and y as signed 16-bit fractions, x in the low half
};

}  // namespace inhabit::crowd
