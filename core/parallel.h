#pragma once
#include <cstddef>
#include <functional>

namespace inhabit::core {

/// Runs body(i) for i in 0 … count-1 on at most `threads` threads (0: all there are). The calls must not depend on each
/// other; then the result is the same at any number of threads. An exception in a body ends the loop and is rethrown.
/// One loop runs at a time: within a body, and while another thread has a loop running, it is one thread's work.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace inhabit::core
