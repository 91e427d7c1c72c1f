#include "session/crowd_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "session/crowd_picture_parts.h"

namespace inhabit::session {

Result<scene::Trajectories> part_of(const scene::Trajectories& trajectories, const CrowdPictureJob& job) {
  scene::Trajectories part = trajectories;
  std::erase_if(part.fixes, [&](const scene::Fix& fix) {
    const double t = fix.frame / trajectories.frame_rate;
    return (job.from && t < *job.from - 1e-9) || (job.until && t > *job.until + 1e-9);
  });
  if (!part.fixes.empty()) return part;
  if (trajectories.fixes.empty()) return invalid("", "nobody is in it");
  return invalid("--from", "nobody is there in this part; the file goes from " +
                               fixed(trajectories.fixes.front().frame / trajectories.frame_rate, 2) + " to " +
                               fixed(trajectories.fixes.back().frame / trajectories.frame_rate, 2) + " s");
}

render::CrowdPictureOptions picture_options(const scene::Trajectories& trajectories, const CrowdPictureJob& job) {
  render::CrowdPictureOptions options;
  options.scene = job.scene;
  options.title = trajectories.name;
  if (options.title.empty() && job.scene) options.title = job.scene->name;
  options.radius = job.radius;
  options.trail = job.trail;
  options.color = job.color == CrowdPictureJob::Color::time  ? render::PathColor::time
                  : job.color == CrowdPictureJob::Color::way ? render::PathColor::way
                                                             : render::PathColor::speed;
  return options;
}

Result<std::string> crowd_picture(const scene::Trajectories& trajectories, std::string_view file_name,
                                  const CrowdPictureJob& job) {
  const std::optional<render::Format> format = render::format_of(file_name);
  if (!format) return check_picture_name(file_name).error();
  const Result<scene::Trajectories> part = part_of(trajectories, job);
  if (!part) return part.error();
  const render::Walks walks = render::walks_of(*part);
  const render::CrowdPictureOptions options = picture_options(trajectories, job);
  const double at = job.at.value_or(render::fullest_moment(*part));
  if (at < walks.begin - 1e-9 || at > walks.end + 1e-9)
    return invalid("--at", fixed(at, 2) + " s is outside " + fixed(walks.begin, 2) + " … " + fixed(walks.end, 2) +
                               " s, when people walk");
  using What = CrowdPictureJob::What;
  const render::Drawing drawing = job.what == What::moment  ? render::draw_moment(walks, at, options)
                                  : job.what == What::paths ? render::draw_paths(walks, options)
                                  : job.what == What::along_x
                                      ? render::draw_space_time(walks, render::SpaceAxis::x, options)
                                      : render::draw_space_time(walks, render::SpaceAxis::y, options);
  return render::encode(drawing, *format, {job.pixels});
}

}  // namespace inhabit::session
