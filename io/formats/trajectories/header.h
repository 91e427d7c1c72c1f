#pragma once
#include <initializer_list>
#include <string_view>
#include <vector>

#include "io/formats/trajectories/delimited.h"

/// What stands above the rows of a table: comments and the names of the columns.
namespace inhabit::io {

/// What `#` lines before the first row say. Archives, PeTrack and inhabit agree on `framerate: 25 fps` and on the unit
/// behind a slash (`x/cm`) or in words (`in cm`); the title and the walkable area are inhabit's own.
struct Comments {
  std::optional<double> frame_rate;  ///< the first number behind the first "framerate"
  std::optional<LengthUnit> unit;
  std::string title;
  std::string_view walkable;              ///< well-known text
  std::vector<std::string_view> columns;  ///< the words of the last comment
  bool any = false;
};
/// Reads comments and empty lines and stops at the first other line, which `lines` then is at.
Comments read_comments(LineReader& lines);
/// Moves title, frame rate, unit and area into `raw`.
void take_comments(const Comments& comments, RawTrajectories& raw);

/// The separator of a line of names: the first of tab, semicolon, comma in it, else 0 for white space.
char separator_of(std::string_view line);
std::vector<std::string_view> column_names(std::string_view line, char separator);
/// The column with one of these names, in any case, the first name that there is; -1: none has.
int column_of(const std::vector<std::string_view>& names, std::initializer_list<std::string_view> wanted);
/// The column whose name holds this text as it is; -1: none does.
int column_with(const std::vector<std::string_view>& names, std::string_view part);

}  // namespace inhabit::io
