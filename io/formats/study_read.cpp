#include <charconv>
#include <set>

#include "io/formats/object_reader.h"
#include "io/formats/study.h"
#include "io/formats/study_members.h"

namespace inhabit::io {
namespace {

using namespace scene;

class StudyReader : public ObjectReader<StudyReader> {
 public:
  bool read(JsonValue root, StudyPlan& plan) {
    if (!expect(root, Json::object)) return false;
    if (!root.find("participants").none() || !root.find("counts").none())
      return fail(root, "these are a study's answers; inhabit study analyse reads them");
    if (!root.find("space").none()) return fail(root, "this is a scene; a study's plan names scenes");
    if (!check_header(root, kStudyName, kStudyVersion) || !read_object(root, plan, {"format", "version"})) return false;
    return check(root.find("scenes"), plan);
  }

  bool read(JsonValue root, StudyData& data) {
    if (!expect(root, Json::object)) return false;
    if (!root.find("scenes").none()) return fail(root, "this is a study's plan, not its answers");
    if (!check_header(root, kAnswersName, kStudyVersion)) return false;
    if (!read_object(root, data, {"format", "version", "title"})) return false;
    const JsonValue participants = root.find("participants"), counts = root.find("counts");
    if (participants.none() == counts.none()) return fail(root, "needs exactly one of: participants, counts");
    return participants.none() ? check_counts(counts, data) : check_participants(participants, data);
  }

 private:
  friend class ObjectReader<StudyReader>;
  using ObjectReader::read;

  /// A list of files, or one.
  bool read(JsonValue v, std::vector<std::string>& out, const Spec& spec) {
    if (v.is(Json::text)) return read(v, out.emplace_back(), Spec{.help = spec.help, .required = true});
    if (!v.is(Json::array)) return fail(v, "is neither a file nor a list of files");
    if (v.size() == 0) return fail(v, "has no picture");
    for (const JsonValue item : v)
      if (!read(item, out.emplace_back(), Spec{.help = spec.help, .required = true})) return false;
    return true;
  }
  bool read(JsonValue v, std::vector<StudyPlate>& out, const Spec& spec) {
    if (!expect(v, Json::object)) return false;
    if (v.size() == 0) return fail(v, "has nothing to compare with");
    for (const JsonValue member : v) {
      out.push_back({std::string(member.key()), {}});
      if (out.back().name.empty()) return fail(member, "has no name");
      if (!read(member, out.back().pictures, spec)) return false;
    }
    return true;
  }

  bool check(JsonValue list, const StudyPlan& plan) {
    if (plan.scenes.empty()) return fail(list, "has no scene");
    std::set<std::string_view> seen;
    std::size_t i = 0;
    for (const JsonValue at : list)
      if (!seen.insert(plan.scenes[i++].name).second) return fail(at.find("name"), "is there already");
    return true;
  }

  bool check_participants(JsonValue list, const StudyData& data) {
    std::set<std::string_view> seen;
    std::size_t i = 0;
    for (const JsonValue at : list)
      if (!seen.insert(data.participants[i++].id).second) return fail(at.find("id"), "is there already");
    return true;
  }

  bool check_counts(JsonValue list, const StudyData& data) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    std::size_t i = 0;
    for (const JsonValue at : list) {
      const StudyCount& c = data.counts[i++];
      if (c.human > c.of) return fail(at.find("human"), "is more than the " + std::to_string(c.of) + " times shown");
      if (!seen.emplace(c.scene, c.synthesis).second)
        return fail(at, quoted(c.scene) + " with " + quoted(c.synthesis) + " is there already");
    }
    return true;
  }
};

template <class T>
Result<T> read_json(std::string_view text) {
  const Result<JsonDocument> document = JsonDocument::parse(text);
  if (!document) return document.error();
  T value;
  StudyReader reader;
  if (!reader.read(document->root(), value)) return *reader.error;
  return value;
}

/// Fields of one line (RFC 4180, without line breaks in quotation marks); nothing when a quotation mark is left open or
/// something follows a closed one.
std::optional<std::vector<std::string>> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  std::size_t i = 0;
  while (true) {
    if (i < line.size() && line[i] == '"') {
      for (++i;; ++i) {
        if (i >= line.size()) return std::nullopt;
        if (line[i] == '"' && (i + 1 >= line.size() || line[i + 1] != '"')) break;
        if (line[i] == '"') ++i;
        fields.back() += line[i];
      }
      if (++i < line.size() && line[i] != ',') return std::nullopt;
    } else {
      while (i < line.size() && line[i] != ',') fields.back() += line[i++];
    }
    if (i >= line.size()) return fields;
    ++i, fields.emplace_back();
  }
}

constexpr std::array<std::string_view, 4> kColumns = {"scene", "synthesis", "human", "of"};

/// Where each of kColumns stands in the head of a table.
Result<std::array<std::size_t, 4>> columns_of(const std::vector<std::string>& head) {
  std::array<std::size_t, 4> columns{};
  for (std::size_t c = 0; c < kColumns.size(); ++c) {
    const auto found = std::ranges::find(head, kColumns[c]);
    if (found == head.end())
      return invalid("line 1", "no column \"" + std::string(kColumns[c]) +
                                   "\"; counts are a table of scene, synthesis, human and of");
    columns[c] = static_cast<std::size_t>(found - head.begin());
  }
  return columns;
}

std::optional<int> whole(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0 || value > kManyAnswers) return {};
  return value;
}

class CsvReader {
 public:
  Result<StudyData> read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (!is_utf8(text)) return invalid("", "is no text in UTF-8");
    if (text.find('\0') != std::string_view::npos) return invalid("", "holds a zero byte");
    std::size_t number = 0;
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      if (line.ends_with('\r')) line.remove_suffix(1);
      where_ = "line " + std::to_string(++number);
      const auto fields = fields_of(line);
      if (!fields) return invalid(where_, "a quotation mark is not closed, or something follows it");
      if (number == 1) {
        const auto columns = columns_of(*fields);
        if (!columns) return columns.error();
        columns_ = *columns, width_ = fields->size();
      } else if (!line.empty()) {
        if (const Status row = add(*fields); !row) return row.error();
      }
    }
    if (number == 0) return invalid("", "is empty");
    if (data_.counts.empty()) return invalid("", "has no counts below its head");
    return data_;
  }

 private:
  Status add(const std::vector<std::string>& fields) {
    if (fields.size() != width_)
      return invalid(where_, "has " + std::to_string(fields.size()) + " fields instead of " + std::to_string(width_));
    StudyCount c{fields[columns_[0]], fields[columns_[1]], 0, 0};
    if (c.scene.empty() || c.synthesis.empty()) return invalid(where_, "a name is empty");
    for (const std::size_t k : {2, 3}) {
      const std::optional<int> value = whole(fields[columns_[k]]);
      if (!value || (k == 3 && *value == 0))
        return invalid(where_, quoted(fields[columns_[k]]) + " is no count for \"" + std::string(kColumns[k]) + "\"");
      (k == 2 ? c.human : c.of) = *value;
    }
    if (c.human > c.of)
      return invalid(where_, "chosen " + std::to_string(c.human) + " times of " + std::to_string(c.of));
    if (!seen_.emplace(c.scene, c.synthesis).second)
      return invalid(where_, quoted(c.scene) + " with " + quoted(c.synthesis) + " is there already");
    data_.counts.push_back(std::move(c));
    return Done{};
  }

  StudyData data_;
  std::set<std::pair<std::string, std::string>> seen_;
  std::array<std::size_t, 4> columns_{};
  std::size_t width_ = 0;
  std::string where_;
};

}  // namespace

Result<StudyPlan> read_study_plan(std::string_view text) { return read_json<StudyPlan>(text); }

Result<StudyData> read_study_data(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
  return json ? read_json<StudyData>(text) : CsvReader().read(text);
}

}  // namespace inhabit::io
