#pragma once
#include <functional>
#include <string_view>

#include "core/core.h"

/// Work that may crash, done by a process of its own: libraries that trust their input.
namespace inhabit::io {

/// What the process sends to the one that waits for it: messages of a kind and up to 32 MiB.
class Sender {
 public:
  explicit Sender(int file) : file_(file) {}
  void send(char kind, std::string_view payload);

 private:
  int file_;
};

/// Runs `work` in a copy of this process, which may compute for `seconds`, and passes what it sends to `receive`, in
/// order. False when the work did not come to its end: it crashed or took too long. Errors: what `receive` returned,
/// which ends the work; no process could be started. Requires: `work` takes no locks and starts no threads.
core::Result<bool> run_apart(const std::function<void(Sender&)>& work,
                             const std::function<core::Status(char kind, std::string_view payload)>& receive,
                             unsigned seconds);

}  // namespace inhabit::io
