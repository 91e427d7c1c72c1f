#pragma once
#include <optional>

#include "core/progress.h"
#include "scene/trajectories.h"
#include "session/pictures.h"

/// Pictures and films of people who walk.
namespace inhabit::session {

struct CrowdPictureJob {
  enum class What { moment, paths, along_x, along_y };
  What what = What::moment;
  const Scene* scene = nullptr;       ///< walls and furniture; else what the trajectories say
  std::optional<double> at;           ///< seconds; absent: the moment with most people
  std::optional<double> from, until;  ///< only this part, seconds
  std::optional<double> trail;        ///< seconds of path behind everybody; absent: 1, none behind mere dots
  double radius = 0.25;               ///< metres
  enum class Color { speed, time, way };
  Color color = Color::speed;  ///< time: of paths only; way: the direction of everybody's whole way in this part
  int pixels = 1600;           ///< long side of a PNG
};
/// A picture as bytes, in the format that the file name says. Errors: nobody is in the part, `at` is outside it.
Result<std::string> crowd_picture(const scene::Trajectories& trajectories, std::string_view file_name,
                                  const CrowdPictureJob& job);

struct FilmJob {
  CrowdPictureJob picture;  ///< `what` and `at` mean nothing
  double rate = 24;         ///< pictures per second
  double speed = 1;         ///< seconds walked in a second of film
  int width = 1280;         ///< pixels; odd ones become even
  int threads = 0;
  const Cancel* cancel = nullptr;
  Progress progress;
};
enum class FilmKind { mp4, webm, frames };
/// By name: .mp4, .webm, a pattern as in `frame-%04d.png`, or a folder: one that is there or a name that ends in /.
std::optional<FilmKind> film_kind(const std::string& path);
/// Whether a film of this name could be made: ffmpeg is there, the folder can be written into. For asking before long
/// work.
Status can_film(const std::string& path);
/// Writes a film, or pictures numbered from 0. A film that fails or is cancelled leaves what was there before; numbered
/// pictures that are done stay. A missing last folder is made. The number of pictures.
Result<std::size_t> film(const scene::Trajectories& trajectories, const std::string& path, const FilmJob& job);

}  // namespace inhabit::session
