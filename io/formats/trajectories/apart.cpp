#include "io/formats/trajectories/apart.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string>

namespace inhabit::io {
namespace {

using core::Result;
using core::Status;

constexpr std::uint32_t kLargest = 32u << 20;

bool write_all(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(file, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written, count -= static_cast<std::size_t>(written);
  }
  return true;
}
bool read_all(int file, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::read(file, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got, count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Whatever happens in the copy stays there: no message, no core file, no handler of the original, no end of time.
void prepare_copy(unsigned seconds) {
  for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU})
    ::signal(number, SIG_DFL);
  const rlimit none{0, 0}, time{seconds, seconds};
  ::setrlimit(RLIMIT_CORE, &none);
  ::setrlimit(RLIMIT_CPU, &time);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

/// What the copy does; an exception must not leave it and go on as a second original.
[[noreturn]] void run_copy(const std::function<void(Sender&)>& work, int file, unsigned seconds) noexcept {
  prepare_copy(seconds);
  Sender sender(file);
  work(sender);
  // Without destructors: what is open belongs to the original.
  ::_exit(0);
}

/// Passes messages on until there are no more or `receive` refuses one.
Status receive_all(int file, const std::function<Status(char, std::string_view)>& receive) {
  std::string payload;
  for (;;) {
    char head[5];
    std::uint32_t size = 0;
    if (!read_all(file, head, sizeof head)) return core::Done{};
    std::memcpy(&size, head + 1, sizeof size);
    if (size > kLargest) return core::Done{};  // from a copy whose memory is no longer what it was
    payload.resize(size);
    if (!read_all(file, payload.data(), size)) return core::Done{};
    if (const Status received = receive(head[0], payload); !received) return received;
  }
}

}  // namespace

void Sender::send(char kind, std::string_view payload) {
  char head[5] = {kind};
  const auto size = static_cast<std::uint32_t>(payload.size());
  std::memcpy(head + 1, &size, sizeof size);
  if (payload.size() > kLargest || !write_all(file_, head, sizeof head) || !write_all(file_, payload.data(), size))
    ::_exit(1);
}

Result<bool> run_apart(const std::function<void(Sender&)>& work,
                       const std::function<Status(char kind, std::string_view payload)>& receive, unsigned seconds) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return core::Error{core::ErrorCode::io, std::string("no pipe: ") + std::strerror(errno), ""};
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::close(ends[0]);
    run_copy(work, ends[1], seconds);
  }
  ::close(ends[1]);
  if (copy < 0) {
    ::close(ends[0]);
    return core::Error{core::ErrorCode::io, std::string("no process: ") + std::strerror(errno), ""};
  }
  const Status received = receive_all(ends[0], receive);
  ::close(ends[0]);
  if (!received) ::kill(copy, SIGKILL);
  int state = 0;
  while (::waitpid(copy, &state, 0) < 0 && errno == EINTR) continue;
  if (!received) return received.error();
  return WIFEXITED(state) && WEXITSTATUS(state) == 0;
}

}  // namespace inhabit::io
