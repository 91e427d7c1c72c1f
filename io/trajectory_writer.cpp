#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/text.h"
#include "io/file.h"
#include "io/trajectory_writers.h"

namespace inhabit::io {
namespace {

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> next{0};
  for (;;) {
    std::filesystem::path temporary = path;
    temporary += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(next++);
    std::error_code ignored;
    if (!std::filesystem::exists(temporary, ignored)) return temporary;
  }
}

/// To the disk and not only to the cache, so that the name never stands for less than the file.
void sync(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

struct TrajectoryWriter::State {
  std::filesystem::path path, temporary;
  std::unique_ptr<AnyTrajectoryWriter> any;
  std::size_t kept = 0;  ///< rows since the last flush

  /// Removes the temporary file and what a database may have beside it.
  void discard() {
    any.reset();
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    std::filesystem::remove(temporary.string() + "-journal", ignored);
  }
};

TrajectoryWriter::TrajectoryWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
TrajectoryWriter::TrajectoryWriter(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter::~TrajectoryWriter() {
  if (state_) state_->discard();
}

Error no_such_trajectory_format() {
  std::string known;
  for (const TrajectoryFormat& f : trajectory_formats())
    if (f.create != nullptr)
      known += (known.empty() ? "." : ", .") + std::string(f.extensions.substr(0, f.extensions.find(' ')));
  return {ErrorCode::unsupported, "trajectories are written to files with one of these extensions: " + known, ""};
}

Result<TrajectoryWriter> TrajectoryWriter::open(const std::filesystem::path& path, const TrajectoryHeader& header) {
  const TrajectoryFormat* format = trajectory_format_to_write(path);
  if (format == nullptr) return no_such_trajectory_format();
  if (!(header.frame_rate > 0) || !std::isfinite(header.frame_rate))
    return invalid("", "a frame rate of " + shortest(header.frame_rate) + " cannot be written");
  if (const Status possible = can_write(path); !possible) return possible.error();
  auto state = std::make_unique<State>();
  state->path = path;
  state->temporary = temporary_beside(path);
  Result<std::unique_ptr<AnyTrajectoryWriter>> any = format->create(state->temporary, header);
  if (!any) {
    state->discard();
    Error error = any.error();
    error.where = path.string();
    return error;
  }
  state->any = std::move(*any);
  return TrajectoryWriter(std::move(state));
}

Status TrajectoryWriter::add(std::int32_t frame, std::span<const Spot> people) {
  for (const Spot& spot : people)
    if (!std::isfinite(spot.x) || !std::isfinite(spot.y))
      return invalid(
          "", "person " + std::to_string(spot.person) + " is at no finite place in frame " + std::to_string(frame));
  return std::visit(
      [&](auto& writer) -> Status {
        if (const Status added = writer.add(frame, people); !added) return added;
        state_->kept += people.size();
        if (state_->kept < kRowsKept) return Done{};
        state_->kept = 0;
        return writer.flush();
      },
      state_->any->writer);
}

Status TrajectoryWriter::finish() {
  const std::unique_ptr<State> state = std::move(state_);
  const Status closed = std::visit(
      [](auto& writer) -> Status {
        if (const Status flushed = writer.flush(); !flushed) return flushed;
        return writer.close();
      },
      state->any->writer);
  if (!closed) {
    state->discard();
    return closed;
  }
  sync(state->temporary);
  if (::rename(state->temporary.c_str(), state->path.c_str()) == 0) return Done{};
  return Error{ErrorCode::io,
               std::string("cannot be replaced: ") + std::strerror(errno) + "; all is in " + state->temporary.string(),
               state->path.string()};
}

Status write_trajectories(const scene::Trajectories& trajectories, const std::filesystem::path& path) {
  Result<TrajectoryWriter> writer =
      TrajectoryWriter::open(path, {trajectories.frame_rate, trajectories.walkable, trajectories.name, ""});
  if (!writer) return writer.error();
  std::vector<Spot> people;
  for (std::size_t k = 0; k < trajectories.fixes.size();) {
    const std::int32_t frame = trajectories.fixes[k].frame;
    people.clear();
    for (; k < trajectories.fixes.size() && trajectories.fixes[k].frame == frame; ++k)
      people.push_back({trajectories.fixes[k].person, trajectories.fixes[k].x, trajectories.fixes[k].y});
    if (const Status added = writer->add(frame, people); !added) return added;
  }
  return writer->finish();
}

}  // namespace inhabit::io
