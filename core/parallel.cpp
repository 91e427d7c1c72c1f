#include "core/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <map>
#include <memory>
#include <mutex>

#ifdef INHABIT_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace inhabit::core {
namespace {

// The thread sanitizer cannot see into oneTBB's library, which is not instrumented, and would report its tasks handed
// from thread to thread as races. So this file is not instrumented either (CMakeLists.txt), and says what the loop
// promises: what came before it is before every call, and every call is before what follows it. It says nothing of two
// calls: a race between bodies is reported like any other. Suppressions by name could not tell the two apart, because a
// body's stack always ends in oneTBB. No race of ours is suppressed; unseen is only what libraries do inside
// themselves.
#ifdef INHABIT_THREAD_SANITIZER
struct Loop {
  Loop() { __tsan_release(&before); }
  ~Loop() { __tsan_acquire(&after); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;
  char before = 0, after = 0;
};
struct Call {
  explicit Call(Loop& of) : loop(of) { __tsan_acquire(&loop.before); }
  ~Call() { __tsan_release(&loop.after); }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  Loop& loop;
};
#else
struct Loop {};
struct Call {
  explicit Call(Loop&) {}
};
#endif

/// Making an arena costs more than a short loop (50 to 250 microseconds), so each width is made once and kept.
tbb::task_arena& arena_of(int threads) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<tbb::task_arena>> arenas;
  const std::lock_guard lock(mutex);
  std::unique_ptr<tbb::task_arena>& arena = arenas[threads];
  constexpr int kAll = tbb::task_arena::automatic;
  if (!arena) arena = std::make_unique<tbb::task_arena>(threads > 0 ? threads : kAll);
  return *arena;
}

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::task_arena& arena = arena_of(threads);
  Loop loop;
  const auto call = [&](std::size_t i) {
    const Call ordered(loop);
    body(i);
  };
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, call, tbb::simple_partitioner{}); });
}

}  // namespace inhabit::core
