#include "annealing/arranger.h"

namespace inhabit::annealing {
namespace {

constexpr double kLeastShift = 1e-3, kLeastTurn = 2e-3;  // metres, radians: finer nobody sees

}  // namespace

Arranger::Arranger(const Furniture& furniture, const ArrangerOptions& options)
    : x_(furniture), options_(options), local_(furniture), costs_(grid_cost(x_)) {
  double sum = 0;
  std::size_t k = 0;
  for_each_type(Moves{}, [&]<class M>(std::type_identity<M>) {
    const bool wanted = !(options.paper_moves && std::is_same_v<M, ToPrior>);
    if (wanted && M::possible(furniture)) sum += M::kShare;
    share_[k++] = sum;
  });
}

void Arranger::scatter(Rng& rng, bool keep) {
  const Furniture& f = x_.furniture();
  const Bounds& room = f.room.extent();
  for (const bool carried : {false, true}) {
    for (const std::uint32_t i : f.walkers) {
      const Item& item = f.items[i];
      const Object& o = f.scene->objects[i];
      const bool on_carrier = item.carried && x_.carrier(i) != kNobody;
      if (on_carrier != carried || (keep && o.position)) continue;
      x_.touch(i);
      const double angle = item.turns && !(keep && o.angle) ? rng.uniform(-kPi, kPi) : x_.angle(i);
      if (item.hung && item.moves) {
        Slide::hang(x_, i, any_wall_spot(f, rng));
      } else if (on_carrier) {
        const Box& top = x_.body(x_.carrier(i)).box;
        const double u = rng.uniform(-1, 1), v = rng.uniform(-1, 1);
        const Vec2 local{u * std::max(0.0, top.half_depth - item.half_depth),
                         v * std::max(0.0, top.half_width - item.half_width)};
        x_.place(i, item.moves ? top.center + rotate(local, top.front) : x_.position(i), angle);
      } else {
        Vec2 p = x_.position(i);
        for (int k = 0; k < 32 && item.moves; ++k) {
          p = {rng.uniform(room.min.x, room.max.x), rng.uniform(room.min.y, room.max.y)};
          if (f.room.contains(p)) break;
        }
        x_.place(i, p, angle);
      }
      x_.settle();
    }
  }
  costs_ = grid_cost(x_);
}

Scale Arranger::scale(double temperature) const {
  const double share = options_.hot > 0 ? temperature / options_.hot : 0;
  return {std::max(kLeastShift, share * options_.position), std::max(kLeastTurn, share * options_.angle)};
}

double Arranger::propose(Rng& rng, double temperature) {
  const Scale s = scale(temperature);
  const double chosen = rng.uniform() * share_.back();
  Costs before{};
  bool made = false, done = false;
  std::size_t k = 0;
  for_each_type(Moves{}, [&]<class M>(std::type_identity<M>) {
    if (!done && chosen < share_[k]) {
      done = true;
      made = M::make(x_, s, rng, [&] { before = local_(x_); });
    }
    ++k;
  });
  if (!made) {
    change_ = {};
    return 0;
  }
  change_ = local_(x_);
  for (std::size_t t = 0; t < change_.size(); ++t) change_[t] -= before[t];
  return weighted(change_, x_.furniture().weights);
}

void Arranger::accept() {
  for (std::size_t t = 0; t < change_.size(); ++t) costs_[t] += change_[t];
  x_.settle();
}

void Arranger::restore(const Snapshot& s) {
  x_.restore(s);
  costs_ = grid_cost(x_);
}

}  // namespace inhabit::annealing
