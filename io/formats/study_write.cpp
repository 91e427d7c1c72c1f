#include "io/formats/object_writer.h"
#include "io/formats/study.h"
#include "io/formats/study_members.h"

namespace inhabit::io {
namespace {

class StudyWriter : public ObjectWriter<StudyWriter> {
 public:
  std::string text(const scene::StudyData& data) {
    out_ = "{";
    key("format"), append_quoted(out_, kAnswersName);
    key("version"), append_number(out_, kStudyVersion);
    members(data);
    if (data.participants.empty() && data.counts.empty()) key("participants"), out_ += "[]";
    out_ += '}';
    return std::move(out_);
  }

 private:
  friend class ObjectWriter<StudyWriter>;
};

}  // namespace

std::string write_study_data(const scene::StudyData& data) { return pretty_json(StudyWriter().text(data)); }

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + "\"";
}

}  // namespace inhabit::io
