#include "io/formats/trajectories/sumo.h"

#include <map>
#include <pugixml.hpp>

#include "io/file.h"
#include "io/formats/trajectories/delimited.h"

namespace inhabit::io {
namespace {

/// The person that a name stands for: its number when every name is one, else the place in order of appearance.
class Names {
 public:
  std::int64_t number_of_name(std::string_view name) {
    const auto [place, fresh] = numbers_.emplace(name, numbers_.size() + 1);
    const std::optional<std::int64_t> whole = whole_of(name);
    if (fresh)
      all_whole_ = all_whole_ && whole && *whole >= 0 && *whole <= 0x7fffffff && name == std::to_string(*whole);
    return static_cast<std::int64_t>(place->second);
  }
  /// From places back to the numbers in the file; a remark when there are none.
  void finish(RawTrajectories& raw) const {
    if (!all_whole_) {
      if (!numbers_.empty())
        raw.remarks.push_back("people are numbered in order of appearance; the first is " + first_name());
      return;
    }
    std::vector<std::int32_t> whole(numbers_.size() + 1);
    for (const auto& [name, place] : numbers_) whole[place] = static_cast<std::int32_t>(*whole_of(name));
    for (scene::Fix& fix : raw.fixes) fix.person = whole[static_cast<std::size_t>(fix.person)];
  }

 private:
  std::string first_name() const {
    for (const auto& [name, place] : numbers_)
      if (place == 1) return name;
    return {};
  }
  std::map<std::string, std::size_t, std::less<>> numbers_;
  bool all_whole_ = true;
};

}  // namespace

bool is_sumo(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 4096);
  return head.find('<') != std::string_view::npos && head.find("<fcd-export") != std::string_view::npos;
}

Result<RawTrajectories> read_sumo(std::string_view bytes) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
  if (!parsed) return invalid(line_and_column(bytes, static_cast<std::size_t>(parsed.offset)), parsed.description());
  RawTrajectories raw;
  raw.unit = LengthUnit::metres;
  RawRows rows(raw);
  Names names;
  std::size_t vehicles = 0;
  for (const pugi::xml_node step : document.child("fcd-export").children("timestep")) {
    const auto where = [&] { return line_and_column(bytes, static_cast<std::size_t>(step.offset_debug())); };
    const std::optional<double> time = number_of(step.attribute("time").value());
    if (!time) return invalid(where(), "timestep: time is no number");
    for (const pugi::xml_node item : step.children()) {
      vehicles += std::string_view(item.name()) == "vehicle";
      if (std::string_view(item.name()) != "person") continue;
      const std::optional<double> x = number_of(item.attribute("x").value()),
                                  y = number_of(item.attribute("y").value());
      const std::string_view id = item.attribute("id").value();
      const auto place = [&] { return line_and_column(bytes, static_cast<std::size_t>(item.offset_debug())); };
      if (id.empty()) return invalid(place(), "person: id is missing");
      if (!x || !y) return invalid(place(), "person " + std::string(id) + ": x and y must be numbers");
      if (!rows.add_at(names.number_of_name(id), *time, *x, *y)) return invalid(place(), rows.problem);
    }
  }
  names.finish(raw);
  if (vehicles > 0) raw.remarks.push_back(std::to_string(vehicles) + " positions of vehicles are left out");
  return raw;
}

}  // namespace inhabit::io
