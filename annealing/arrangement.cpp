#include "annealing/arrangement.h"

#include <algorithm>

namespace inhabit::annealing {
namespace {

constexpr double kCell = 0.8;  // metres, about a chair with the space before it

/// Where a pathway goes while nothing stands in its way: straight out of both doors.
ControlPoints straight(const Path& path) {
  const double reach = length(path.to - path.from) / 3;
  return {path.from + reach * path.from_inward, path.to + reach * path.to_inward};
}

/// Cells no smaller than a 255th of the room: Cells has no more.
double cell_of(const Bounds& extent) { return std::max({kCell, extent.size().x / 250, extent.size().y / 250}); }

}  // namespace

std::array<Box, kPathParts> path_boxes(const BezierCurve& c, double width) {
  std::array<Box, kPathParts> boxes;
  Vec2 from = c[0];
  for (std::uint32_t k = 0; k < kPathParts; ++k) {
    const double t = (k + 1.0) / kPathParts, s = 1 - t;
    const Vec2 to = s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
    boxes[k] = {0.5 * (from + to), unit(to - from), length(to - from) / 2, width / 2};
    from = to;
  }
  return boxes;
}

Arrangement::Arrangement(const Furniture& f)
    : f_(&f),
      bodies_(f.items.size()),
      spaces_(f.spaces.size()),
      angles_(f.items.size()),
      carrier_(f.items.size(), kNobody),
      carried_(f.items.size()),
      points_(f.paths.size()),
      body_cells_(f.room.extent(), cell_of(f.room.extent())),
      space_cells_(f.room.extent(), cell_of(f.room.extent())),
      body_range_(f.items.size()),
      space_range_(f.spaces.size()),
      moving_(f.items.size()),
      near_(f.items.size()),
      near_spaces_(f.spaces.size()) {
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    const Object& o = f.scene->objects[i];
    const Item& item = f.items[i];
    const double angle = o.angle.value_or(0);
    bodies_[i] = {{o.position ? o.position->xy() : f.room.center(), direction(angle), item.half_depth, item.half_width},
                  item.low,
                  item.low + item.height};
    angles_[i] = angle;
    body_range_[i] = body_cells_.range(geometry::bounds(bodies_[i].box));
    body_cells_.insert(i, body_range_[i]);
  }
  for (std::uint32_t s = 0; s < spaces_.size(); ++s) {
    const Space& space = f.spaces[s];
    spaces_[s] = {space.local, space.low, space.high};
    space_range_[s] = space_cells_.range(geometry::bounds(spaces_[s].box));
    space_cells_.insert(s, space_range_[s]);
  }
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    touch(i);
    place_spaces(i);
    settle();
    if (f.carrier[i] == kNobody) continue;
    touch(i);
    carry(i, f.carrier[i]);
    settle();
  }
  for (std::uint32_t p = 0; p < points_.size(); ++p) {
    touch_path(p);
    set_points(p, straight(f.paths[p]));
    settle();
  }
}

bool Arrangement::touches_space(std::uint32_t s) const {
  const Space& space = f_->spaces[s];
  if (space.owner != kNobody) return moving_.contains(space.owner);
  if (touched_path_ == kNobody) return false;
  const std::uint32_t first = f_->paths[touched_path_].first_space;
  return s >= first && s < first + kPathParts;
}

void Arrangement::collect(std::uint32_t item) {
  if (!moving_.insert(item)) return;
  touched_.push_back(item);
  undo_.push_back({bodies_[item], angles_[item], carrier_[item]});
  for (const std::uint32_t s : f_->spaces_of[item]) undo_spaces_.push_back(spaces_[s]);
  for (const std::uint32_t c : carried_[item]) collect(c);
}

void Arrangement::touch(std::uint32_t item) {
  const bool first = touched_.empty();
  collect(item);
  if (first) first_family_ = touched_.size();
}

void Arrangement::touch_path(std::uint32_t path) {
  touched_path_ = path;
  undo_points_ = points_[path];
}

void Arrangement::set(std::uint32_t item, Vec2 p, double angle, Vec2 front) {
  bodies_[item].box.center = p;
  bodies_[item].box.front = front;
  angles_[item] = angle;
  place_spaces(item);
}

void Arrangement::place_spaces(std::uint32_t item) {
  const Box& box = bodies_[item].box;
  for (const std::uint32_t s : f_->spaces_of[item]) {
    const Space& space = f_->spaces[s];
    spaces_[s].box.center = box.center + rotate(space.local.center, box.front);
    spaces_[s].box.front = rotate(space.local.front, box.front);
    spaces_[s].low = bodies_[item].low + space.low, spaces_[s].high = bodies_[item].low + space.high;
  }
}

void Arrangement::place(std::uint32_t item, Vec2 p, double angle) {
  const Box before = bodies_[item].box;
  const double turn = wrap_angle(angle - angles_[item]);
  const Vec2 front = angle == angles_[item] ? before.front : direction(angle);
  set(item, p, angle, front);
  const auto follow = [&](auto&& self, std::uint32_t of) -> void {
    for (const std::uint32_t c : carried_[of]) {
      const Box& box = bodies_[c].box;
      const Vec2 offset = rotate_back(box.center - before.center, before.front);
      const double heading = turn == 0 ? angles_[c] : wrap_angle(angles_[c] + turn);
      set(c, p + rotate(offset, front), heading, turn == 0 ? box.front : direction(heading));
      self(self, c);
    }
  };
  follow(follow, item);
}

void Arrangement::adopt(std::uint32_t item, std::uint32_t carrier) {
  if (carrier_[item] == carrier) return;
  if (carrier_[item] != kNobody) std::erase(carried_[carrier_[item]], item);
  carrier_[item] = carrier;
  if (carrier == kNobody) return;
  auto& list = carried_[carrier];
  list.insert(std::ranges::lower_bound(list, item), item);
}

void Arrangement::set_base(std::uint32_t item, double low) {
  const double up = low - bodies_[item].low;
  bodies_[item].low = low, bodies_[item].high = low + f_->items[item].height;
  place_spaces(item);
  for (const std::uint32_t c : carried_[item]) set_base(c, bodies_[c].low + up);
}

void Arrangement::carry(std::uint32_t item, std::uint32_t carrier) {
  adopt(item, carrier);
  if (f_->items[item].carried) set_base(item, bodies_[carrier].high);
}

void Arrangement::set_points(std::uint32_t path, const ControlPoints& points) {
  points_[path] = points;
  place_path(path);
}

/// "A series of rectangles along the curve" (Yu et al. 4.2), of equal steps in t.
void Arrangement::place_path(std::uint32_t path) {
  const Path& data = f_->paths[path];
  const auto boxes = path_boxes({data.from, points_[path][0], points_[path][1], data.to}, f_->path_width);
  for (std::uint32_t k = 0; k < kPathParts; ++k) spaces_[data.first_space + k].box = boxes[k];
}

void Arrangement::settle() {
  for (const std::uint32_t i : touched_) {
    const Cells::Range range = body_cells_.range(geometry::bounds(bodies_[i].box));
    if (range != body_range_[i]) {
      body_cells_.erase(i, body_range_[i]);
      body_cells_.insert(i, body_range_[i] = range);
    }
  }
  const auto settle_space = [&](std::uint32_t s) {
    const Cells::Range range = space_cells_.range(geometry::bounds(spaces_[s].box));
    if (range == space_range_[s]) return;
    space_cells_.erase(s, space_range_[s]);
    space_cells_.insert(s, space_range_[s] = range);
  };
  for (const std::uint32_t i : touched_)
    for (const std::uint32_t s : f_->spaces_of[i]) settle_space(s);
  if (touched_path_ != kNobody)
    for (std::uint32_t k = 0; k < kPathParts; ++k) settle_space(f_->paths[touched_path_].first_space + k);
  touched_.clear(), undo_.clear(), undo_spaces_.clear(), moving_.clear();
  touched_path_ = kNobody;
}

void Arrangement::undo() {
  std::size_t k = 0;
  for (std::size_t t = 0; t < touched_.size(); ++t) {
    const std::uint32_t i = touched_[t];
    adopt(i, undo_[t].carrier);
    bodies_[i] = undo_[t].body, angles_[i] = undo_[t].angle;
    for (const std::uint32_t s : f_->spaces_of[i]) spaces_[s] = undo_spaces_[k++];
  }
  if (touched_path_ != kNobody) set_points(touched_path_, undo_points_);
  touched_.clear(), undo_.clear(), undo_spaces_.clear(), moving_.clear();
  touched_path_ = kNobody;
}

Arrangement::Snapshot Arrangement::snapshot() const {
  Snapshot s;
  s.positions.reserve(bodies_.size());
  for (const Solid& body : bodies_) s.positions.push_back(body.box.center);
  s.angles = angles_;
  s.carriers = carrier_;
  s.points = points_;
  return s;
}

void Arrangement::restore(const Snapshot& s) {
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    touch(i);
    if (s.carriers[i] != carrier_[i]) {
      if (s.carriers[i] == kNobody) {
        adopt(i, kNobody);
      } else {
        carry(i, s.carriers[i]);
      }
    }
    set(i, s.positions[i], s.angles[i], direction(s.angles[i]));
    settle();
  }
  for (std::uint32_t p = 0; p < points_.size(); ++p) {
    touch_path(p);
    set_points(p, s.points[p]);
    settle();
  }
}

}  // namespace inhabit::annealing
