#include <CLI/CLI.hpp>
#include <array>
#include <exception>
#include <string>

#include "app/terminal.h"
#include "app/verbs.h"
#include "core/text.h"

namespace inhabit::app {
namespace {

struct Verb {
  std::string_view name, sentence;
  SetUp set_up;
};

constexpr std::array kVerbs = {
    Verb{"furnish", "Arrange the objects of a scene or of a home's rooms", set_up_furnish},
    Verb{"check", "Say what is wrong with a layout", set_up_check},
    Verb{"learn", "Find out from furnished rooms how things stand", set_up_learn},
    Verb{"simulate", "Let people walk through a scene", set_up_simulate},
    Verb{"scenes", "List the built-in scenes, or print one", set_up_scenes},
    Verb{"render", "Draw a plan, or people who walk, as a picture or a film", set_up_render},
    Verb{"convert", "Read one format and write another, by extension", set_up_convert},
    Verb{"measure", "Say where and how people walked: density, speed, flow, collisions", set_up_measure},
    Verb{"study", "Ask people which of two pictures they prefer, and count", set_up_study},
    Verb{"bench", "Measure what the papers published, here", set_up_bench},
};

constexpr const char* kFooter =
    "Lengths are metres, angles degrees counter-clockwise, times seconds unless a unit is given.\n"
    "SCENE is a file of any format that inhabit reads, or the name of a built-in scene (inhabit scenes).\n"
    "Exit codes: 0 done, 1 something overlaps, stands outside or breaks a constraint, 2 an error (one line on standard "
    "error).\n"
    "Example: inhabit furnish living-room -o room.json --svg room.svg\n"
    "inhabit VERB --help says more.";

/// "inhabit study make".
std::string full_name(const CLI::App& about) {
  const CLI::App* parent = about.get_parent();
  return parent == nullptr ? about.get_name() : full_name(*parent) + " " + about.get_name();
}

int usage(const std::string& message, const CLI::App& about) {
  std::string line = message;
  for (char& c : line)
    if (c == '\n') c = ' ';
  complain(line + " (" + full_name(about) + " --help says more)");
  return kError;
}

/// The verb, or the part of it that was asked for: make of study.
const CLI::App& innermost(const CLI::App& verb) {
  const std::vector<CLI::App*> parts = verb.get_subcommands();
  return parts.empty() ? verb : innermost(*parts.front());
}

/// The first argument that nothing expects, with the nearest option when it looks like one.
int unexpected(const std::string& argument, const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string option = argument.substr(0, argument.find('='));
  if (argument.starts_with("-")) return usage("unknown option " + option + core::did_you_mean(option, views), verb);
  std::vector<std::string> parts;
  for (const CLI::App* part : verb.get_subcommands([](const CLI::App*) { return true; }))
    parts.push_back(part->get_name());
  const std::vector<std::string_view> part_views(parts.begin(), parts.end());
  return usage("unexpected argument " + argument + core::did_you_mean(argument, part_views), verb);
}

int unknown_verb(const std::string& name, const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const Verb& verb : kVerbs) names.push_back(verb.name);
  return usage("unknown verb " + name + core::did_you_mean(name, names), app);
}

int run(int argc, char** argv) {
  CLI::App app("inhabit furnishes a space, fills it with people, and tells whether it works.", "inhabit");
  app.footer(kFooter);
  app.set_version_flag("--version", "inhabit 0.1.0");
  app.set_help_flag("-h,--help", "Print this");
  std::vector<std::pair<CLI::App*, std::function<int()>>> verbs;
  bool known = argc < 2 || argv[1][0] == '-';
  for (const Verb& verb : kVerbs) {
    CLI::App* sub = app.add_subcommand(std::string(verb.name), std::string(verb.sentence));
    sub->allow_extras();
    sub->set_help_flag("-h,--help", "Print this");
    verbs.emplace_back(sub, verb.set_up(*sub));
    known = known || verb.name == argv[1];
  }
  if (!known) return unknown_verb(argv[1], app);
  if (argc < 2) {
    print(app.help());
    return kError;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // help and version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    for (const auto& [sub, action] : verbs)
      if (sub->parsed()) {
        const CLI::App& part = innermost(*sub);
        for (const std::string& extra : part.remaining())
          if (extra.starts_with("-")) return unexpected(extra, part);
        return usage(error.what(), part);
      }
    return usage(error.what(), app);
  }
  for (const auto& [sub, action] : verbs) {
    if (!sub->parsed()) continue;
    const CLI::App& part = innermost(*sub);
    if (!part.remaining().empty()) return unexpected(part.remaining().front(), part);
    return action();
  }
  return unknown_verb(argv[1], app);
}

}  // namespace
}  // namespace inhabit::app

int main(int argc, char** argv) {
  try {
    return inhabit::app::run(argc, argv);
  } catch (const std::bad_alloc&) {
    inhabit::app::complain("not enough memory");
  } catch (const std::exception& error) {
    inhabit::app::complain(error.what());
  }
  return inhabit::app::kError;
}
