#pragma once
#include <cstddef>

/// What this machine can do at best, measured: the two lines of a roofline.
namespace inhabit::session {

/// Single-precision additions and multiplications per second, in the widest vectors there are, none fused.
double peak_flops(int threads);
/// Bytes per second read and written by a = b + s * c over arrays of `bytes` in all.
double bandwidth(std::size_t bytes, int threads);

}  // namespace inhabit::session
