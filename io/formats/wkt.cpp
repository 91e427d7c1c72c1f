#include "io/formats/wkt.h"

#include <algorithm>
#include <charconv>

#include "core/text.h"
#include "io/file.h"
#include "io/plan_import.h"

namespace inhabit::io {
namespace {

constexpr int kDeepest = 32;
constexpr std::string_view kSpaces = " \t\r\n";

class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  std::vector<Area> areas;
  std::vector<std::string> dropped;
  std::optional<Error> error;

  bool read() {
    skip();
    if (rest().starts_with("SRID=") || rest().starts_with("srid=")) {
      const std::size_t end = text_.find(';', at_);
      if (end == std::string_view::npos) return fail("\";\" is missing after SRID");
      at_ = end + 1;
    }
    do {
      if (!geometry(0)) return false;
      accept(';');
      skip();
    } while (at_ < text_.size());
    return true;
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }
  bool fail(std::string message) {
    if (!error) error = invalid(line_and_column(text_, at_), std::move(message));
    return false;
  }
  void skip() {
    while (at_ < text_.size() && kSpaces.find(text_[at_]) != std::string_view::npos) ++at_;
  }
  bool accept(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool expect(char c) { return accept(c) || fail(std::string("\"") + c + "\" is missing"); }
  std::string word() {
    skip();
    std::string word;
    for (; at_ < text_.size() && ((text_[at_] | 0x20) >= 'a' && (text_[at_] | 0x20) <= 'z'); ++at_)
      word += static_cast<char>(text_[at_] & ~0x20);
    return word;
  }

  bool geometry(int depth) {
    if (depth > kDeepest) return fail("nested deeper than " + std::to_string(kDeepest) + " levels");
    skip();
    const std::size_t start = at_;
    std::string type = word();
    std::size_t mark = at_;
    std::string next = word();
    if (next == "Z" || next == "M" || next == "ZM") mark = at_, next = word();
    for (const std::string_view suffix : {"ZM", "Z", "M"}) {
      if (type.ends_with(suffix)) {
        type.resize(type.size() - suffix.size());
        break;
      }
    }
    at_ = mark;
    const bool empty = next == "EMPTY";
    if (empty) word();
    if (type == "POLYGON") return empty || polygon();
    if (type == "MULTIPOLYGON") return empty || list([&] { return polygon(); });
    if (type == "GEOMETRYCOLLECTION") return empty || list([&] { return geometry(depth + 1); });
    static constexpr std::string_view kOthers[] = {"POINT", "LINESTRING", "MULTIPOINT", "MULTILINESTRING",
                                                   "LINEARRING"};
    if (std::ranges::find(kOthers, type) != std::end(kOthers)) {
      if (dropped.size() < 100) dropped.push_back(type);
      return empty || skip_brackets();
    }
    at_ = start;
    static constexpr std::string_view kAll[] = {"POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"};
    return fail(type.empty() ? "a geometry belongs here, such as POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))"
                             : "unknown geometry" + did_you_mean(type, kAll));
  }
  template <class Item>
  bool list(Item item) {
    if (!expect('(')) return false;
    do {
      if (!item()) return false;
    } while (accept(','));
    return expect(')');
  }
  bool skip_brackets() {
    skip();
    if (at_ >= text_.size() || text_[at_] != '(') return fail("\"(\" is missing");
    std::size_t open = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '(') ++open;
      if (text_[at_] == ')' && --open == 0) return ++at_, true;
    }
    return fail("\")\" is missing");
  }
  bool polygon() {
    Area area;
    bool first = true;
    const bool good = list([&] {
      Ring ring;
      if (!list([&] { return corner(ring); })) return false;
      if (ring.size() < 4 || ring.front() != ring.back())
        return fail("a ring has four corners or more and ends where it starts");
      (first ? area.outline : area.holes.emplace_back()) = std::move(ring);
      first = false;
      return true;
    });
    if (good) areas.push_back(std::move(area));
    return good;
  }
  bool corner(Ring& ring) {
    std::array<double, 4> values{};
    std::size_t count = 0;
    for (; count < 4; ++count) {
      skip();
      if (count >= 2 && at_ < text_.size() && (text_[at_] == ',' || text_[at_] == ')')) break;
      if (!number(values[count])) return false;
    }
    ring.push_back({values[0], values[1]});
    return true;
  }
  bool number(double& out) {
    const std::string_view text = rest().starts_with('+') ? rest().substr(1) : rest();
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (problem != std::errc{} || !std::isfinite(out)) return fail("a number belongs here");
    at_ += static_cast<std::size_t>(end - rest().data());
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Result<std::vector<Scene>> read_wkt(std::string_view text) {
  WktReader reader(text);
  if (!reader.read()) return *reader.error;
  Result<std::vector<Scene>> scenes = scenes_of(std::move(reader.areas), "");
  if (!scenes || reader.dropped.empty()) return scenes;
  std::string names;
  for (const std::string& type : reader.dropped) names += (names.empty() ? "[" : ", ") + json_text(type);
  for (Scene& scene : *scenes) scene.extras.emplace_back("x-dropped", names + "]");
  return scenes;
}

Result<std::vector<Area>> read_wkt_areas(std::string_view text) {
  WktReader reader(text);
  if (!reader.read()) return *reader.error;
  std::vector<Area> areas;
  for (Area& area : reader.areas) {
    area = tidied(std::move(area));
    if (is_clean(area)) {
      areas.push_back(std::move(area));
      continue;
    }
    const std::vector<Ring> holes = std::exchange(area.holes, {});
    for (Area& part : difference({area}, holes, 0)) areas.push_back(std::move(part));
  }
  if (areas.empty()) return invalid("", "no area in it");
  return areas;
}

}  // namespace inhabit::io
