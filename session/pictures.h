#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layout/check.h"
#include "layout/furnish.h"
#include "session/bench.h"
#include "session/document.h"
#include "session/jobs.h"

/// Pictures as bytes, in the format that a file name's extension says: svg, png or pdf.
namespace inhabit::session {

struct PictureOptions {
  int pixels = 1600;  ///< long side of a PNG
  bool labels = true;
  bool clearances = false;
  bool views = false;
  bool door_zones = false;
  bool problems = false;  ///< mark what `check` finds
};

/// The plan of the document's scene; of several rooms, a sheet of their plans.
Result<std::string> plan_picture(const Document& document, std::string_view file_name,
                                 const PictureOptions& options = {});

/// A contact sheet: every suggestion of every room, best first, named and ranked.
Result<std::string> sheet_picture(const Furnished& furnished, std::string_view file_name,
                                  const PictureOptions& options = {});

/// Energy per iteration of every start, feasible parts and relocations marked.
Result<std::string> trace_picture(const std::vector<layout::TraceRow>& trace, std::string_view title,
                                  std::string_view file_name);

/// A bench's rooms side by side.
Result<std::string> sheet_picture(const BenchSheet& sheet, std::string_view file_name);

/// Cost by term over the iterations of the start that ended cheapest.
Result<std::string> trace_picture(const std::vector<annealing::TraceRow>& trace, std::string_view title,
                                  std::string_view file_name);

/// A bench's curve.
Result<std::string> curve_picture(const BenchCurve& curve, std::string_view file_name);

/// Empty when the extension is one of a picture; else an error that says which there are.
Status check_picture_name(std::string_view file_name);

}  // namespace inhabit::session
