#include "crowd/arrivals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/distributions.h"

namespace inhabit::crowd {
namespace {

/// A person tries so many places at random before he looks over a lattice of at most kSide x kSide.
constexpr int kTries = 24, kSide = 24;

}  // namespace

Arrivals::Arrivals(const scene::Source& source, std::uint64_t seed, std::size_t number)
    : rate_(source.rate),
      from_(source.from),
      until_(source.until.value_or(std::numeric_limits<double>::infinity())),
      next_(source.from),
      poisson_(source.arrivals == scene::Source::Arrivals::poisson),
      most_(source.count ? static_cast<std::size_t>(std::max(0, *source.count))
                         : std::numeric_limits<std::size_t>::max()),
      rng_(draw(seed, Draw::arrivals, number)) {
  if (!(rate_ > 0)) next_ = std::numeric_limits<double>::infinity();
  if (rate_ > 0 && poisson_) next_ += exponential(rng_) / rate_;
}

void Arrivals::advance() {
  ++came_;
  next_ = poisson_ ? next_ + exponential(rng_) / rate_ : from_ + static_cast<double>(came_) / rate_;
}

std::size_t Arrivals::due(double time) {
  std::size_t count = 0;
  for (; !over() && next_ <= time; ++count) advance();
  return count;
}

Gate::Gate(const scene::Source& source, std::uint16_t route, const World& world, std::uint64_t seed, std::size_t number)
    : source_(source), route_(route), seed_(seed), arrivals_(source, seed, number), area_(source.area) {
  for (Vec2& p : area_) p = p - world.origin;
  box_ = bounds(area_);
}

std::optional<Vec2> Gate::free_place(const Person& person, std::uint32_t id, const World& world) const {
  const auto good = [&](Vec2 p) {
    const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
    return std::ranges::all_of(near_,
                               [&](const Disc& d) { return apart(d.x - x, d.y - y, d.radius + person.radius); }) &&
           contains(area_, p) && clear_of_walls(world.walls, x, y, person.radius);
  };
  Rng rng = draw(seed_, Draw::entry, id);
  for (int t = 0; t < kTries; ++t) {
    const double x = rng.uniform(box_.min.x, box_.max.x), y = rng.uniform(box_.min.y, box_.max.y);
    if (good({x, y})) return Vec2{x, y};
  }
  const Vec2 size = box_.size();
  const auto cells = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / (0.5 * person.radius)), 1.0, double(kSide)));
  };
  const int columns = cells(size.x), rows = cells(size.y);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 p = box_.min + Vec2{size.x * (column + 0.5) / columns, size.y * (row + 0.5) / rows};
      if (good(p)) return p;
    }
  return std::nullopt;
}

void Gate::let_in(double time, float widest, const World& world, std::uint32_t& next_id, Agents& agents) {
  waiting_ += arrivals_.due(time);
  if (waiting_ == 0 || area_.size() < 3) return;
  near_.clear();
  const float grown = 2 * widest;
  const auto low_x = static_cast<float>(box_.min.x) - grown, high_x = static_cast<float>(box_.max.x) + grown;
  const auto low_y = static_cast<float>(box_.min.y) - grown, high_y = static_cast<float>(box_.max.y) + grown;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const float x = agents.x[i], y = agents.y[i];
    if (x >= low_x && x <= high_x && y >= low_y && y <= high_y) near_.push_back({x, y, agents.radius[i]});
  }
  for (; waiting_ > 0; --waiting_) {
    const Person person = make_person(source_, seed_, next_id);
    const std::optional<Vec2> place = free_place(person, next_id, world);
    if (!place) return;
    const auto x = static_cast<float>(place->x), y = static_cast<float>(place->y);
    add_person(agents, person, next_id++, route_, x, y);
    near_.push_back({x, y, person.radius});
  }
}

}  // namespace inhabit::crowd
