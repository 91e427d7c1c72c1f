#pragma once
#include <atomic>
#include <functional>
#include <string_view>

namespace inhabit::core {

/// Asked to stop from another thread or a signal handler; long work looks at it between steps.
class Cancel {
 public:
  void request() { requested_.store(true, std::memory_order_relaxed); }
  bool requested() const { return requested_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> requested_{false};
};

/// Told how far long work has come: `done` in [0, 1]. May be called from any thread, one call at a time.
using Progress = std::function<void(double done, std::string_view what)>;

}  // namespace inhabit::core
