#pragma once
#include <functional>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

/// One verb = one file with its options, and one line in the table in main.cpp.
namespace inhabit::app {

/// Adds the verb's options to its part of the command line and returns what runs it; that returns the exit code.
using SetUp = std::function<int()> (*)(CLI::App& verb);

std::function<int()> set_up_furnish(CLI::App& verb);
std::function<int()> set_up_check(CLI::App& verb);
std::function<int()> set_up_learn(CLI::App& verb);
std::function<int()> set_up_simulate(CLI::App& verb);
std::function<int()> set_up_scenes(CLI::App& verb);
std::function<int()> set_up_render(CLI::App& verb);
std::function<int()> set_up_convert(CLI::App& verb);
std::function<int()> set_up_measure(CLI::App& verb);
std::function<int()> set_up_study(CLI::App& verb);
std::function<int()> set_up_bench(CLI::App& verb);

}  // namespace inhabit::app
