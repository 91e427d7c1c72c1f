#include "render/labels.h"

namespace inhabit::render {
namespace {

constexpr double kScales[] = {1, 0.86, 0.74};
constexpr double kReach = 130;  // points from a box to its label
constexpr double kGap = 1.5;    // between labels

Box grown(Box b, double by) { return b.half_depth += by, b.half_width += by, b; }

bool holds(const Box& outer, const Box& inner, double margin = 0) {
  const Box shrunk = grown(outer, 1e-9 - margin);
  for (const Vec2 p : inner.corners())
    if (!shrunk.contains(p)) return false;
  return true;
}

bool on_page(const Bounds& page, const Box& b) {
  for (const Vec2 p : b.corners())
    if (p.x < page.min.x || p.y < page.min.y || p.x > page.max.x || p.y > page.max.y) return false;
  return true;
}

bool meet(const Box& a, const Box& b) { return separation(a, b).depth > 0; }

/// Reading direction: never upside down; upward text reads from the page's right side.
Vec2 readable(Vec2 d) {
  if (std::abs(d.x) < 1e-6) return {0, -1};
  return d.x < 0 ? -d : d;
}

/// What is near one request, so that a candidate is not compared with the whole plan.
struct Near {
  std::vector<const Obstacle*> obstacles;
  const LabelRequest* request = nullptr;
};

Near neighbourhood(const LabelRequest& request, const LabelField& field) {
  Near near{{}, &request};
  double size = 0;
  for (const Vec2 s : request.shapes) size = std::max(size, length(s));
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    if (static_cast<int>(i) == request.obstacle) continue;
    const Obstacle& o = field.obstacles[i];
    const double reach = o.box.radius() + request.box.radius() + kReach + size;
    const Vec2 d = o.box.center - request.box.center;
    if (dot(d, d) <= reach * reach) near.obstacles.push_back(&o);
  }
  return near;
}

/// True when the label lies on ground that also carries what it names.
bool lies_on(const Obstacle& o, const Box& label, const Box& named) {
  return o.ground && holds(o.box, label) && o.box.contains(named.center);
}

/// True when the named box is drawn over the obstacle.
bool hidden(const Obstacle& o, const Near& near, const LabelField& field) {
  return &o - field.obstacles.data() < near.request->obstacle;
}

struct Taken {
  std::vector<Box> labels, leaders;
};

bool free_spot(const Box& label, const Near& near, const LabelField& field, const Taken& taken, bool inside = false) {
  if (!on_page(field.page, label)) return false;
  const Box wide = grown(label, kGap);
  for (const Box& b : taken.labels)
    if (meet(wide, b)) return false;
  for (const Box& b : taken.leaders)
    if (meet(label, b)) return false;
  for (const Obstacle* o : near.obstacles)
    if (!(inside && hidden(*o, near, field)) && meet(label, o->box) && !lies_on(*o, label, near.request->box))
      return false;
  return true;
}

/// True when the text keeps within an ellipse; its corners are emptier than its box.
bool within_ellipse(const Box& label, const Box& round) {
  for (const Vec2 p : label.corners()) {
    const Vec2 q = rotate_back(p - round.center, round.front);
    const double x = q.x / round.half_depth, y = q.y / round.half_width;
    if (x * x + y * y > 1.08) return false;
  }
  return true;
}

/// One text inside the box, in the middle of what is left behind the inset or as near to it as may be.
std::optional<LabelSpot> fit(const Near& near, const LabelField& field, const Taken& taken, LabelSpot spot,
                             double inset) {
  constexpr double kShifts[] = {0, -0.5, 0.5, -1, 1};
  const LabelRequest& r = *near.request;
  const Vec2 middle = r.box.center - (inset / 2) * r.box.front;
  const double play_f = r.box.half_depth - inset / 2 - spot.box.extent(r.box.front) - 2;
  const double play_l = r.box.half_width - spot.box.extent(r.box.left()) - 2;
  if (play_f < 0 || play_l < 0) return {};
  for (const double f : kShifts) {
    for (const double l : kShifts) {
      spot.box.center = middle + (f * play_f) * r.box.front + (l * play_l) * r.box.left();
      if (r.round && !within_ellipse(spot.box, r.box)) continue;
      if (free_spot(spot.box, near, field, taken, true)) return spot;
    }
  }
  return {};
}

LabelSpot inside(const Near& near, const LabelField& field, const Taken& taken) {
  const LabelRequest& r = *near.request;
  const Vec2 lengthwise = r.box.half_depth >= r.box.half_width ? r.box.front : r.box.left();
  // Large before small, off the front's mark before on it, upright before turned, one line before two.
  const Vec2 directions[] = {{1, 0}, readable(lengthwise), readable(perp(lengthwise))};
  const std::vector<double> insets = r.front_inset > 0 ? std::vector{r.front_inset, 0.0} : std::vector{0.0};
  for (const double scale : kScales) {
    for (const double inset : insets) {
      for (const Vec2 d : directions) {
        for (std::size_t shape = 0; shape < r.shapes.size(); ++shape) {
          const Vec2 half = 0.5 * scale * r.shapes[shape];
          const LabelSpot spot{true, true, shape, scale, {r.box.center, d, half.x, half.y}, {}, {}};
          if (const auto found = fit(near, field, taken, spot, inset)) return *found;
        }
      }
    }
  }
  return {};
}

/// From the label's edge to just inside the box.
void lead(LabelSpot& spot, const Box& box, bool round) {
  const Vec2 to_label = rotate_back(spot.box.center - box.center, box.front);
  const double inset = std::min({3.0, 0.5 * box.half_depth, 0.5 * box.half_width});
  Vec2 local{std::clamp(to_label.x, inset - box.half_depth, box.half_depth - inset),
             std::clamp(to_label.y, inset - box.half_width, box.half_width - inset)};
  if (round && box.half_depth > 0 && box.half_width > 0) {
    const double reach = length({to_label.x / box.half_depth, to_label.y / box.half_width});
    local = 0.85 / std::max(reach, 0.85) * to_label;
  }
  spot.leader_to = box.center + rotate(local, box.front);
  const Vec2 back = rotate_back(spot.leader_to - spot.box.center, spot.box.front);
  const Vec2 edge{std::clamp(back.x, -spot.box.half_depth, spot.box.half_depth),
                  std::clamp(back.y, -spot.box.half_width, spot.box.half_width)};
  spot.leader_from = spot.box.center + rotate(edge, spot.box.front);
}

/// How bad a label beside its box is; nothing when its leader would cross a label or another leader.
std::optional<double> cost(const LabelSpot& spot, const Near& near, const Taken& taken) {
  const Box leader = leader_box(spot.leader_from, spot.leader_to);
  for (const Box& b : taken.labels)
    if (meet(leader, b)) return {};
  for (const Box& b : taken.leaders)
    if (meet(leader, b)) return {};
  double sum = length(spot.leader_to - spot.leader_from) + 25 * (1 - spot.scale) + 4 * static_cast<double>(spot.shape);
  for (const Obstacle* o : near.obstacles)
    if (!(o->ground && o->box.contains(spot.leader_to)) && meet(leader, o->box)) sum += 45;
  // Slanted leaders look untidy.
  const Vec2 d = unit(spot.leader_to - spot.leader_from);
  return sum + 8 * std::min(std::abs(d.x), std::abs(d.y));
}

LabelSpot beside(const Near& near, const LabelField& field, const Taken& taken) {
  constexpr double kGaps[] = {7, 13, 21, 32, 46, 64, 88, 115};
  constexpr int kDirections = 24;
  const LabelRequest& r = *near.request;
  LabelSpot best;
  double best_cost = 1e300;
  for (const double scale : {1.0, 0.86}) {
    for (std::size_t shape = 0; shape < r.shapes.size(); ++shape) {
      const Vec2 half = 0.5 * scale * r.shapes[shape];
      for (const double gap : kGaps) {
        if (gap > best_cost) break;
        for (int k = 0; k < kDirections; ++k) {
          const Vec2 d = direction(2 * kPi * k / kDirections);
          LabelSpot spot{true, false, shape, scale, {r.box.center, {1, 0}, half.x, half.y}, {}, {}};
          // The centre slides along a rectangle `gap` away from the box.
          const double x = r.box.extent({1, 0}) + half.x + gap, y = r.box.extent({0, 1}) + half.y + gap;
          const double t = std::min(x / std::max(std::abs(d.x), 1e-9), y / std::max(std::abs(d.y), 1e-9));
          spot.box.center += t * d;
          if (!free_spot(spot.box, near, field, taken) || meet(spot.box, r.box)) continue;
          lead(spot, r.box, r.round);
          const auto c = cost(spot, near, taken);
          if (c && *c < best_cost) best = spot, best_cost = *c;
        }
      }
    }
  }
  return best;
}

}  // namespace

Box leader_box(Vec2 from, Vec2 to) { return {0.5 * (from + to), unit(to - from), 0.5 * length(to - from), 0.4}; }

std::vector<LabelSpot> place_labels(std::span<const LabelRequest> requests, const LabelField& field) {
  std::vector<LabelSpot> spots(requests.size());
  Taken taken{field.taken, {}};
  // Labels inside their boxes first: the others then find room around them.
  for (const bool within : {true, false}) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      if (spots[i].placed || !(within ? requests[i].inside : requests[i].beside)) continue;
      const Near near = neighbourhood(requests[i], field);
      spots[i] = within ? inside(near, field, taken) : beside(near, field, taken);
      if (!spots[i].placed) continue;
      taken.labels.push_back(spots[i].box);
      if (!spots[i].inside) taken.leaders.push_back(leader_box(spots[i].leader_from, spots[i].leader_to));
    }
  }
  return spots;
}

}  // namespace inhabit::render
