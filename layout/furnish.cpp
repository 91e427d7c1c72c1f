#include "layout/furnish.h"

#include <algorithm>
#include <mutex>

#include "core/parallel.h"
#include "geometry/extents.h"
#include "layout/relations.h"
#include "layout/solver.h"

namespace inhabit::layout {
namespace {

bool better(const Layout& a, const Layout& b) {
  if (a.feasible != b.feasible) return a.feasible;
  return a.energy < b.energy;
}

/// Some object differs by more than its own size, or by 45 degrees.
bool distinct(const Scene& scene, const Placement& a, const Placement& b) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Vec3 size = scene.objects[i].size;
    const Vec2 d = a.objects[i].position.xy() - b.objects[i].position.xy();
    if (length(d) > std::max(size.x, size.y)) return true;
    if (std::abs(wrap_angle(a.objects[i].angle - b.objects[i].angle)) > kPi / 4) return true;
  }
  return false;
}

/// The scene compiled; an error when something that is to be placed has no place in the room whatever its angle.
Result<Problem> compile_possible(const Scene& scene) {
  const geometry::Extents room(scene.space.outline);
  for (const Object& o : scene.objects) {
    const bool held = o.position && (o.fixed || o.lock == Lock::position || o.lock == Lock::both);
    if (!held && room.too_small_for(o.size.x, o.size.y))
      return core::invalid("", "\"" + o.id + "\" is larger than the room in every orientation");
  }
  return compile(scene);
}

/// Runs starts first … first + count - 1 in parallel and appends their results in order.
void run_starts(const Problem& problem, const Options& options, int first, int count, Outcome& out) {
  std::vector<std::optional<Layout>> layouts(static_cast<std::size_t>(count));
  std::vector<std::vector<TraceRow>> traces(static_cast<std::size_t>(count));
  std::mutex telling;
  int done = 0;
  core::parallel_for(static_cast<std::size_t>(count), options.threads, [&](std::size_t i) {
    if (options.cancel != nullptr && options.cancel->requested() && i > 0) return;
    Solver solver(problem, options, first + static_cast<int>(i));
    layouts[i] = solver.run(options.trace ? &traces[i] : nullptr);
    if (!options.progress) return;
    const std::lock_guard lock(telling);
    options.progress(static_cast<double>(++done) / count, layouts[i]->feasible ? "feasible" : "searching");
  });
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (layouts[i]) out.starts.push_back(std::move(*layouts[i]));
    out.trace.insert(out.trace.end(), traces[i].begin(), traces[i].end());
  }
  out.cancelled = options.cancel != nullptr && options.cancel->requested();
}

/// True when its base is to be where it is without a carrier's top: it hangs, floats, or stands inside its carrier (on
/// the seat of a chair, in a basin), with which it then does not collide.
bool keeps_height(const Scene& scene, const Relations& relations, std::uint32_t i) {
  const Object& o = scene.objects[i];
  if (!o.position) return false;
  if (o.on.none()) return o.mount != Mount::floor || o.position->z > 0;
  return o.on.kind == Ref::Kind::object && relations.collision_off(i, o.on.index);
}

/// True when every movable thing has a position: the scene only has to settle.
bool warm(const Problem& p, const Options& options) {
  return options.start == Start::given && !options.paper && std::ranges::all_of(p.has_start, [](bool b) { return b; });
}

}  // namespace

Result<Outcome> furnish(const Scene& scene, const Options& options) {
  const Result<Problem> problem = compile_possible(scene);
  if (!problem) return problem.error();
  Outcome out;
  const bool settles = warm(*problem, options);
  // Settling is the same from every start; only when it ends infeasible is it worth starting again.
  run_starts(*problem, options, 0, settles ? 1 : std::max(1, options.starts), out);
  if (settles && !out.starts.front().feasible && options.starts > 1 && !out.cancelled) {
    run_starts(*problem, options, 1, options.starts - 1, out);
  }
  out.best = *std::ranges::min_element(out.starts, better);
  return out;
}

Result<std::vector<Layout>> suggest(const Scene& scene, const Options& options, int count) {
  const Result<Problem> problem = compile_possible(scene);
  if (!problem) return problem.error();
  Options each = options;
  if (each.start == Start::given && warm(*problem, options)) each.start = Start::placed;
  std::vector<Layout> chosen;
  Outcome found;
  for (int first = 0; first < 8 * count && static_cast<int>(chosen.size()) < count; first += count) {
    run_starts(*problem, each, first, count, found);
    std::vector<Layout> ranked = found.starts;
    std::ranges::stable_sort(ranked, better);
    chosen.clear();
    for (const Layout& l : ranked) {
      const bool fresh =
          std::ranges::all_of(chosen, [&](const Layout& c) { return distinct(scene, l.placement, c.placement); });
      if (fresh && static_cast<int>(chosen.size()) < count) chosen.push_back(l);
    }
    const bool enough = static_cast<int>(chosen.size()) == count && chosen.back().feasible;
    if (found.cancelled || enough) break;
  }
  return chosen;
}

Scene with_placement(Scene scene, const Placement& placement) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].position = placement.objects[i].position;
    scene.objects[i].angle = placement.objects[i].angle;
  }
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    if (!scene.groups[g].rigid) continue;
    scene.groups[g].position = placement.groups[g].p;
    scene.groups[g].angle = placement.groups[g].angle;
  }
  return scene;
}

Scene without_positions(Scene scene) {
  std::vector<bool> shaped(scene.objects.size());
  const auto mark = [&](auto&& self, const Group& g) -> void {
    for (const Ref m : g.members) {
      if (m.kind == Ref::Kind::object) shaped[m.index] = true;
      if (m.kind == Ref::Kind::group) self(self, scene.groups[m.index]);
    }
  };
  for (const Group& g : scene.groups) {
    if (g.rigid) mark(mark, g);
  }
  const Relations relations(scene);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    Object& o = scene.objects[i];
    // What hangs from the ceiling is in nobody's way.
    if (o.fixed || shaped[i] || o.mount == Mount::ceiling) continue;
    if (keeps_height(scene, relations, i)) o.elevation = std::max(0.0, o.position->z);
    if (o.lock == Lock::none || o.lock == Lock::angle) o.position.reset();
    if (o.lock == Lock::none || o.lock == Lock::position) o.angle.reset();
  }
  for (Group& g : scene.groups) {
    if (g.rigid) g.position.reset(), g.angle.reset();
  }
  return scene;
}

}  // namespace inhabit::layout
