#include "io/formats/trajectories/apart.h"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>
#include <stdexcept>
#include <string>

using namespace inhabit::io;
using inhabit::core::Done;
using inhabit::core::Status;

namespace {

Status ignore(char, std::string_view) { return Done{}; }

}  // namespace

TEST_CASE("messages of work that is done apart arrive in order") {
  std::string got;
  const auto done = run_apart(
      [](Sender& out) {
        out.send('a', "one");
        out.send('b', std::string(1 << 20, 'x'));
        out.send('c', "");
      },
      [&](char kind, std::string_view payload) -> Status {
        got += kind + std::to_string(payload.size());
        return Done{};
      },
      10);
  REQUIRE(done.ok());
  CHECK(*done);
  CHECK(got == "a3b1048576c0");
}

TEST_CASE("work that crashes or throws or never ends is not done") {
  CHECK_FALSE(*run_apart([](Sender&) { std::raise(SIGSEGV); }, ignore, 10));
  CHECK_FALSE(*run_apart([](Sender&) { throw std::runtime_error("no"); }, ignore, 10));
  std::atomic<int> rounds{0};
  CHECK_FALSE(*run_apart(
      [&](Sender&) {
        for (;;) ++rounds;
      },
      ignore, 1));
}

TEST_CASE("who receives may end the work") {
  const auto done = run_apart(
      [](Sender& out) {
        for (;;) out.send('a', "more");
      },
      [](char, std::string_view) -> Status { return inhabit::core::invalid("row 7", "enough"); }, 10);
  REQUIRE_FALSE(done.ok());
  CHECK(done.error().text() == "row 7: enough");
}
