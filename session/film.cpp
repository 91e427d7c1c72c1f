#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include "core/parallel.h"
#include "io/file.h"
#include "session/crowd_picture_parts.h"
#include "session/film_encoder.h"

namespace inhabit::session {
namespace {

constexpr double kMostFrames = 1e6;

bool ends_in(std::string_view text, std::string_view end) {
  if (text.size() < end.size()) return false;
  return std::ranges::equal(text.substr(text.size() - end.size()), end,
                            [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// The parts of a name with one number in it, as %d or %04d.
struct Numbered {
  std::string before, after;
  std::size_t digits = 1;

  std::string path(std::size_t number) const {
    const std::string text = std::to_string(number);
    return before + std::string(digits - std::min(digits, text.size()), '0') + text + after;
  }
};

std::optional<Numbered> numbered(const std::string& path) {
  const std::size_t percent = path.find('%');
  if (percent == std::string::npos || path.find('%', percent + 1) != std::string::npos) return std::nullopt;
  const std::size_t end = path.find_first_not_of("0123456789", percent + 1);
  if (end == std::string::npos || path[end] != 'd' || end - percent > 3) return std::nullopt;
  const std::string digits = path.substr(percent + 1, end - percent - 1);
  const std::size_t wide = digits.empty() ? 1 : std::stoul(digits);
  if (wide == 0 || wide > 20 || path.find('/', percent) != std::string::npos) return std::nullopt;
  return Numbered{path.substr(0, percent), path.substr(end + 1), wide};
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return path.ends_with("/") || std::filesystem::is_directory(path, error);
}

Numbered frames_of(const std::string& path) {
  if (is_folder(path)) return {path + (path.ends_with("/") ? "" : "/") + "frame-", ".png", 6};
  return numbered(path).value_or(Numbered{path, "", 1});
}

/// Draws the pictures of a film, a few at a time side by side, and hands them on in order.
struct Camera {
  const render::Walks& walks;
  const FilmJob& job;
  render::CrowdPictureOptions options;
  render::CrowdPage page;
  render::Pixels ground;

  double time(std::size_t frame) const { return walks.begin + static_cast<double>(frame) * job.speed / job.rate; }
  Result<render::Pixels> picture(std::size_t frame) const {
    return render::rasterize(render::draw_walkers(walks, page, time(frame), options), job.width, &ground);
  }
};

Result<Camera> set_up(const render::Walks& walks, const scene::Trajectories& part, const FilmJob& job) {
  Camera camera{walks, job, picture_options(part, job.picture), {}, {}};
  render::CrowdPictureOptions& options = camera.options;
  options.fixed_width = true;
  options.width = 1000, options.height = 562.5;
  camera.page = render::crowd_page(walks, options);
  // An even number of rows, as film formats want it.
  render::Drawing& page = camera.page.ground;
  const double rows = job.width * page.size.y / page.size.x;
  page.size.y = 2 * std::ceil(rows / 2 - 1e-9) * page.size.x / job.width;
  Result<render::Pixels> ground = render::rasterize(page, job.width);
  if (!ground) return ground.error();
  camera.ground = std::move(*ground);
  return camera;
}

using Sink = std::function<Status(std::size_t frame, const render::Pixels& pixels)>;

Status shoot(const Camera& camera, std::size_t frames, const Sink& sink) {
  const FilmJob& job = camera.job;
  const unsigned here = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t batch = std::min<std::size_t>(job.threads > 0 ? static_cast<std::size_t>(job.threads) : here, 32);
  for (std::size_t first = 0; first < frames; first += batch) {
    if (job.cancel && job.cancel->requested()) return Error{ErrorCode::cancelled, "interrupted; there is no film", ""};
    const std::size_t count = std::min(batch, frames - first);
    std::vector<Result<render::Pixels>> pictures(count, render::Pixels{});
    parallel_for(count, job.threads, [&](std::size_t k) { pictures[k] = camera.picture(first + k); });
    for (std::size_t k = 0; k < count; ++k) {
      if (!pictures[k]) return pictures[k].error();
      if (const Status done = sink(first + k, *pictures[k]); !done) return done;
    }
    if (job.progress)
      job.progress(static_cast<double>(first + count) / static_cast<double>(frames),
                   "picture " + std::to_string(first + count) + " of " + std::to_string(frames));
  }
  return Done{};
}

Status shoot_pictures(const Camera& camera, std::size_t frames, const std::string& path) {
  std::error_code error;
  if (path.ends_with("/")) std::filesystem::create_directory(path, error);
  const Numbered names = frames_of(path);
  return shoot(camera, frames, [&](std::size_t frame, const render::Pixels& pixels) -> Status {
    const Result<std::string> png = render::encode_png(pixels);
    if (!png) return png.error();
    return io::write_file_atomically(names.path(frame), *png);
  });
}

}  // namespace

std::optional<FilmKind> film_kind(const std::string& path) {
  if (is_folder(path)) return FilmKind::frames;
  if (ends_in(path, ".mp4")) return FilmKind::mp4;
  if (ends_in(path, ".webm")) return FilmKind::webm;
  if (ends_in(path, ".png") && numbered(path)) return FilmKind::frames;
  return std::nullopt;
}

Status can_film(const std::string& path) {
  const std::optional<FilmKind> kind = film_kind(path);
  if (!kind) return Error{ErrorCode::unsupported, "a film is written as .mp4, .webm, frame-%04d.png or a folder", ""};
  if (*kind != FilmKind::frames && find_ffmpeg().empty())
    return Error{ErrorCode::not_found,
                 "films need the program ffmpeg, which is not on the PATH; -o FOLDER/ writes numbered pictures", path};
  std::error_code error;
  if (path.ends_with("/") && !std::filesystem::exists(path, error)) {
    const std::string parent = path.substr(0, path.find_last_not_of('/') + 1);
    return io::can_write(parent);
  }
  return io::can_write(*kind == FilmKind::frames ? frames_of(path).path(0) : path);
}

Result<std::size_t> film(const scene::Trajectories& trajectories, const std::string& path, const FilmJob& wanted) {
  FilmJob job = wanted;
  job.width += job.width % 2;  // film formats want even sides
  const Status possible = can_film(path);
  if (!possible) return possible.error();
  const Result<scene::Trajectories> part = part_of(trajectories, job.picture);
  if (!part) return part.error();
  const render::Walks walks = render::walks_of(*part);
  const double count = std::floor((walks.end - walks.begin) / job.speed * job.rate + 1e-9) + 1;
  if (!(count <= kMostFrames))
    return invalid("--speed", "there would be more than a million pictures; --from and --until choose a part");
  const auto frames = static_cast<std::size_t>(count);
  const Result<Camera> camera = set_up(walks, *part, job);
  if (!camera) return camera.error();
  const FilmKind kind = *film_kind(path);
  if (kind == FilmKind::frames) {
    const Status done = shoot_pictures(*camera, frames, path);
    return done ? Result<std::size_t>(frames) : done.error();
  }
  const render::Pixels& size = camera->ground;
  auto encoder = FilmEncoder::open(path, kind == FilmKind::mp4 ? "mp4" : "webm", size.width, size.height, job.rate);
  if (!encoder) return encoder.error();
  Status done =
      shoot(*camera, frames, [&](std::size_t, const render::Pixels& pixels) { return (*encoder)->add(pixels.bytes); });
  if (done) done = (*encoder)->finish();
  return done ? Result<std::size_t>(frames) : done.error();
}

}  // namespace inhabit::session
