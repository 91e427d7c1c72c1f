#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace inhabit::core {
namespace {

/// A step of a crowd is some twenty loops of ten to a thousand microseconds. Whoever waits for the next one looks for
/// it so many times before he sleeps (a few hundred microseconds): waking up takes longer than a short loop. oneTBB's
/// workers sleep at once: with them two threads walked 3,600 people no faster than one.
constexpr int kLooks = 4000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

/// The threads that help whoever has loops to run, one loop at a time.
class Helpers {
 public:
  ~Helpers() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      ++loop_;
    }
    called_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// False when somebody else's loop is running: then nothing has been done.
  bool run(std::size_t count, std::size_t helpers, const std::function<void(std::size_t)>& body) {
    if (busy_.exchange(true)) return false;
    while (threads_.size() < helpers) threads_.emplace_back([this, rank = threads_.size()] { help(rank); });
    body_ = &body, count_ = count, wanted_ = helpers;
    next_.store(0);
    open_.store(true);
    {
      const std::lock_guard lock(mutex_);  // nobody falls asleep between his last look and this call
      ++loop_;
    }
    if (sleeping_.load() > 0) called_.notify_all();
    work();
    open_.store(false);
    while (inside_.load() > 0) pause();
    const std::exception_ptr failure = std::exchange(failure_, nullptr);
    busy_.store(false);
    if (failure) std::rethrow_exception(failure);
    return true;
  }

 private:
  void work() {
    for (std::size_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) {
      try {
        (*body_)(i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_.store(count_);
      }
    }
  }

  void help(std::size_t rank) {
    for (std::uint64_t seen = 0;;) {
      for (int k = 0; k < looks_ && loop_.load() == seen; ++k) pause();
      if (loop_.load() == seen) {
        std::unique_lock lock(mutex_);
        ++sleeping_;
        called_.wait(lock, [&] { return loop_.load() != seen; });
        --sleeping_;
      }
      seen = loop_.load();
      if (ending_) return;
      // Whoever opened the loop waits for those inside: between the two lines nothing of it can go away.
      ++inside_;
      if (open_.load() && rank < wanted_) work();
      --inside_;
    }
  }

  std::mutex mutex_;  ///< of sleep and failure
  std::condition_variable called_;
  std::vector<std::thread> threads_;
  const int looks_ = std::thread::hardware_concurrency() > 1 ? kLooks : 0;
  std::atomic<std::uint64_t> loop_{0};  ///< number of the loop that is or was running
  std::atomic<bool> busy_{false};       ///< somebody has a loop
  std::atomic<bool> open_{false}, ending_{false};
  std::atomic<int> inside_{0}, sleeping_{0};
  std::atomic<std::size_t> next_{0};
  const std::function<void(std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0, wanted_ = 0;
  std::exception_ptr failure_;
};

Helpers& helpers() {
  static Helpers all;
  return all;
}

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  const std::size_t all = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  const std::size_t wanted = std::min(all, count);
  if (wanted > 1 && helpers().run(count, wanted - 1, body)) return;
  for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace inhabit::core
