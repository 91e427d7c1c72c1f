#include "app/terminal.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace inhabit::app {
namespace {

// A signal handler can reach nothing but statics; the flag inside is a lock-free atomic.
core::Cancel interrupt;

void on_interrupt(int) {
  interrupt.request();
  std::signal(SIGINT, SIG_DFL);
}

/// Control characters of an input must not reach the terminal, and a message is one line.
std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : text) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return out;
}

}  // namespace

void complain(std::string_view message) {
  const std::string line = "inhabit: " + one_line(message) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

int fail(std::string_view file, const core::Error& error) {
  const std::string text = error.text();
  // An error that names its file already, as those of writing do, is not given a second one.
  if (file.empty() || text.starts_with(file))
    complain(text);
  else
    complain(std::string(file) + ": " + text);
  return kError;
}

void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (shown_ && last_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

core::Progress ProgressLine::reporter() {
  if (!shown_) return {};
  return [this](double done, std::string_view what) {
    const int percent = static_cast<int>(100 * done);
    if (percent == last_percent_ && what == last_what_) return;
    last_percent_ = percent;
    last_what_ = what;
    std::fprintf(stderr, "\r\033[K%3d %%  %.60s", percent, one_line(what).c_str());
    std::fflush(stderr);
  };
}

Interruptible::Interruptible() { std::signal(SIGINT, on_interrupt); }
Interruptible::~Interruptible() { std::signal(SIGINT, SIG_DFL); }
const core::Cancel* Interruptible::cancel() const { return &interrupt; }

}  // namespace inhabit::app
