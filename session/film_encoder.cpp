#include "session/film_encoder.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "core/text.h"

extern char** environ;

namespace inhabit::session {
namespace {

core::Error failed(const std::string& what, int error) {
  return {core::ErrorCode::io, what + ": " + std::strerror(error), ""};
}

std::vector<std::string> arguments(const std::string& program, const std::string& out, const std::string& format,
                                   int width, int height, double rate) {
  std::vector<std::string> a = {program, "-hide_banner", "-loglevel", "error", "-nostdin", "-y",
                                // What comes in: pixels without a header.
                                "-f", "rawvideo", "-pixel_format", "bgr0", "-video_size",
                                std::to_string(width) + "x" + std::to_string(height), "-framerate",
                                core::fixed(rate, 6), "-i", "pipe:0", "-an", "-pix_fmt", "yuv420p",
                                // Said and done alike, or players guess and colours shift.
                                "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709",
                                "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"};
  const std::vector<std::string> coding =
      format == "webm"
          ? std::vector<std::string>{"-c:v",      "libvpx-vp9", "-crf",      "30", "-b:v",    "0",
                                     "-deadline", "realtime",   "-cpu-used", "6",  "-row-mt", "1"}
          : std::vector<std::string>{"-c:v", "libx264", "-crf", "18", "-preset", "fast", "-movflags", "+faststart"};
  a.insert(a.end(), coding.begin(), coding.end());
  a.insert(a.end(), {"-f", format, "file:" + out});
  return a;
}

}  // namespace

std::string find_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string file = rest.substr(0, end) + "/ffmpeg";
    std::error_code error;
    if (end > 0 && std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
    rest.erase(0, std::min(end + 1, rest.size()));
  }
  return "";
}

core::Result<std::unique_ptr<FilmEncoder>> FilmEncoder::open(const std::string& path, const std::string& format,
                                                             int width, int height, double rate) {
  const std::string program = find_ffmpeg();
  if (program.empty())
    return core::Error{core::ErrorCode::not_found,
                       "films need the program ffmpeg, which is not on the PATH; a folder gets numbered pictures", ""};
  std::unique_ptr<FilmEncoder> film(new FilmEncoder);
  film->path_ = path;
  film->messages_ = std::tmpfile();
  // A socket instead of a pipe: writing to an ffmpeg that has ended is then an error and no signal.
  int ends[2];
  if (!film->messages_ || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return failed("ffmpeg cannot be started", errno);
  film->pipe_ = ends[0];
  film->temporary_ = path + ".part-" + std::to_string(::getpid());
  std::vector<std::string> words = arguments(program, film->temporary_, format, width, height, rate);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ::fileno(film->messages_), STDERR_FILENO);
  // In a process group of its own, Ctrl-C reaches us alone.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = ::posix_spawn(&film->process_, program.c_str(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[1]);
  if (error == 0) return film;
  film->process_ = -1;
  return failed("ffmpeg cannot be started", error);
}

FilmEncoder::~FilmEncoder() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  }
  if (pipe_ >= 0) ::close(pipe_);
  if (messages_) std::fclose(messages_);
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

core::Error FilmEncoder::complaint() const {
  std::string text(2000, 0);
  std::rewind(messages_);
  text.resize(std::fread(text.data(), 1, text.size(), messages_));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return {core::ErrorCode::io, "ffmpeg failed" + (text.empty() ? "" : ": " + text), path_};
}

core::Status FilmEncoder::add(std::span<const std::uint8_t> pixels) {
  while (!pixels.empty()) {
    const ssize_t sent = ::send(pipe_, pixels.data(), pixels.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) {
      // It has closed its input: it is about to end, and what it says is complete when it has.
      int status = 0;
      ::kill(process_, SIGTERM);
      while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
      process_ = -1;
      return complaint();
    }
    pixels = pixels.subspan(static_cast<std::size_t>(sent));
  }
  return core::Done{};
}

core::Status FilmEncoder::finish() {
  ::close(pipe_);
  pipe_ = -1;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return complaint();
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) return core::Error{core::ErrorCode::io, error.message(), path_};
  temporary_.clear();
  return core::Done{};
}

}  // namespace inhabit::session
