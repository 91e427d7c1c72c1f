#include "io/formats/trajectories/petrack.h"

#include "core/text.h"
#include "io/formats/trajectories/areas.h"
#include "io/formats/trajectories/header.h"

namespace inhabit::io {

bool is_petrack(std::string_view bytes) {
  LineReader lines(bytes);
  const Comments comments = read_comments(lines);
  if (!comments.any) return false;
  const std::string_view line = trimmed_line(lines.line());
  return line.empty() || line.front() == '#' || numeric_columns(line) > 0;
}

Result<RawTrajectories> read_petrack(std::string_view bytes) {
  RawTrajectories raw;
  LineReader lines(bytes), ahead(bytes);
  const Comments comments = read_comments(ahead);
  take_comments(comments, raw);
  Columns columns{.person = 0, .frame = 1, .x = 2, .y = 3};
  // Nearly every file starts with the person; one that says the opposite is believed.
  if (comments.columns.size() >= 4 && column_of(comments.columns, {"frame", "fr"}) == 0)
    std::swap(columns.person, columns.frame);
  if (const Status read = read_rows(lines, columns, raw); !read) return read.error();
  return raw;
}

Result<PetrackWriter> PetrackWriter::create(const std::filesystem::path& path, const TrajectoryHeader& header) {
  Result<AppendFile> file = AppendFile::create(path);
  if (!file) return file.error();
  // The frame rate first and the columns last: readers take the first number and the last unit that they find.
  std::string& out = file->buffer;
  out += "# framerate: " + shortest(header.frame_rate) + " fps\n";
  if (!header.title.empty()) out += "# title: " + one_line(header.title) + "\n";
  if (!header.producer_notes.empty()) out += "# made by: " + one_line(header.producer_notes) + "\n";
  if (!header.walkable.empty()) out += "# walkable area: " + walkable_text(header.walkable) + "\n";
  out += "# id frame x/m y/m z/m\n";
  PetrackWriter writer(std::move(*file));
  if (const Status flushed = writer.flush(); !flushed) return flushed.error();
  return writer;
}

Status PetrackWriter::add(std::int32_t frame, std::span<const Spot> people) {
  std::string& out = file_.buffer;
  for (const Spot& spot : people) {
    append_whole(out, spot.person);
    out += ' ';
    append_whole(out, frame);
    out += ' ';
    append_rounded(out, spot.x, 4);
    out += ' ';
    append_rounded(out, spot.y, 4);
    out += " 0\n";
  }
  return Done{};
}

}  // namespace inhabit::io
