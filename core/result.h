#pragma once
#include <cassert>
#include <string>
#include <utility>
#include <variant>

/// Precondition of ours; on in Debug and RelWithDebInfo.
#define INHABIT_ASSERT(condition) assert(condition)

namespace inhabit::core {

enum class ErrorCode { invalid_input, not_found, unsupported, io, cancelled };

/// What is wrong with an input, and where: a JSON pointer, `line 3, column 7`, an entry of an archive.
struct Error {
  ErrorCode code = ErrorCode::invalid_input;
  std::string message;
  std::string where;

  /// One line for people: `where: message`.
  std::string text() const { return where.empty() ? message : where + ": " + message; }
};

inline Error invalid(std::string where, std::string message) {
  return {ErrorCode::invalid_input, std::move(message), std::move(where)};
}

/// A value or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& operator*() & { return std::get<0>(state_); }
  const T& operator*() const& { return std::get<0>(state_); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

struct Done {};
/// Success, or the reason why not.
using Status = Result<Done>;

}  // namespace inhabit::core
