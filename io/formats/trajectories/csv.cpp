#include "io/formats/trajectories/csv.h"

#include "io/formats/trajectories/header.h"

namespace inhabit::io {
namespace {

/// A coordinate's column: "x", "posX", "x/cm", "x [m]", "y_m".
int length_column(const std::vector<std::string_view>& names, char axis, std::optional<LengthUnit>& unit) {
  const std::string letter(1, axis);
  const std::string known[] = {letter, "pos" + letter, "pos_" + letter, "position_" + letter, letter + "_pos"};
  for (const std::string& name : known)
    for (std::size_t k = 0; k < names.size(); ++k) {
      std::string word = lower(names[k]);
      if (!word.starts_with(name)) continue;
      std::erase_if(word, [](char c) { return std::string_view(" []()/_").find(c) != std::string_view::npos; });
      std::string plain = name;
      std::erase(plain, '_');
      if (!word.starts_with(plain)) continue;
      word.erase(0, plain.size());
      if (!word.empty() && word != "m" && word != "cm") continue;
      if (!word.empty()) unit = word == "m" ? LengthUnit::metres : LengthUnit::centimetres;
      return static_cast<int>(k);
    }
  return -1;
}

struct Table {
  Columns columns;
  std::optional<LengthUnit> unit;
  Comments comments;
};

/// At the line that names the columns, after comments.
std::optional<Table> find_columns(LineReader& lines) {
  Table table;
  table.comments = read_comments(lines);
  const std::string_view line = lines.line();
  const char separator = separator_of(line);
  const std::vector<std::string_view> names = column_names(line, separator);
  Columns& c = table.columns;
  c.separator = separator;
  c.person = column_of(names, {"id", "pedid", "ped_id", "personid", "person_id", "person", "pid", "agent_id", "agentid",
                               "agent", "track_id", "trackid", "pedestrianid", "pedestrian_id", "pedestrian"});
  c.frame = column_of(names, {"frame", "frame_id", "frameid", "frame_number", "fr"});
  c.time = column_of(names,
                     {"t", "time", "t/s", "time/s", "t [s]", "time [s]", "time_s", "simtime", "seconds", "timestamp"});
  c.x = length_column(names, 'x', table.unit), c.y = length_column(names, 'y', table.unit);
  c.vx = column_of(names, {"v_x", "vx", "vel_x"}), c.vy = column_of(names, {"v_y", "vy", "vel_y"});
  if (c.vy < 0) c.vx = -1;
  if (c.person < 0 || c.x < 0 || c.y < 0 || (c.frame < 0 && c.time < 0)) return std::nullopt;
  return table;
}

}  // namespace

bool is_csv(std::string_view bytes) {
  LineReader lines(bytes);
  return find_columns(lines).has_value();
}

Result<RawTrajectories> read_csv(std::string_view bytes) {
  RawTrajectories raw;
  LineReader lines(bytes);
  const std::optional<Table> table = find_columns(lines);
  if (!table) return invalid("", "the first line must name the columns id, frame or t, x and y, as in id,frame,x,y");
  raw.unit = LengthUnit::metres;
  take_comments(table->comments, raw);
  if (table->unit) raw.unit = table->unit;
  if (const Status read = read_rows(lines, table->columns, raw); !read) return read.error();
  return raw;
}

Result<CsvWriter> CsvWriter::create(const std::filesystem::path& path, const TrajectoryHeader& header) {
  Result<AppendFile> file = AppendFile::create(path);
  if (!file) return file.error();
  file->buffer = "id,frame,x,y,t\n";
  CsvWriter writer(std::move(*file), header.frame_rate);
  if (const Status flushed = writer.flush(); !flushed) return flushed.error();
  return writer;
}

Status CsvWriter::add(std::int32_t frame, std::span<const Spot> people) {
  std::string& out = file_.buffer;
  std::string time;
  append_rounded(time, frame / frame_rate_, 6);
  for (const Spot& spot : people) {
    append_whole(out, spot.person);
    out += ',';
    append_whole(out, frame);
    out += ',';
    append_rounded(out, spot.x, 4);
    out += ',';
    append_rounded(out, spot.y, 4);
    out.append(",").append(time) += '\n';
  }
  return Done{};
}

}  // namespace inhabit::io
