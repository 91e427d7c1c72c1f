#pragma once
#include <string>
#include <string_view>

#include "core/progress.h"
#include "core/result.h"

/// What the command line says to people, and how it is interrupted. The library itself never prints.
namespace inhabit::app {

/// Exit codes of every verb.
enum Exit : int {
  kDone = 0,
  kInfeasible = 1,  ///< the result is there, but something overlaps, stands outside or breaks a constraint
  kError = 2        ///< wrong use, wrong input, a file that cannot be written
};

/// `inhabit: message` on standard error.
void complain(std::string_view message);
/// `inhabit: FILE: /json/pointer: message`; always kError.
int fail(std::string_view file, const core::Error& error);

void print(std::string_view text);

/// A line on standard error that is rewritten as work goes on; silent when standard error is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Empty when nothing is shown.
  core::Progress reporter();

 private:
  bool shown_ = false;
  int last_percent_ = -1;
  std::string last_what_;
};

/// While it lives, the first Ctrl-C asks for a stop and the second one ends the program.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  const core::Cancel* cancel() const;
};

}  // namespace inhabit::app
