#pragma once
#include "io/formats/scene_members.h"

/// A group's curve as a document has it: {"arc": {…}}, {"segment": {…}}, or {"segment": {}} for the medial axis.
namespace inhabit::io {

struct ArcInFile {
  Vec2 start, end, center;
  friend bool operator==(const ArcInFile&, const ArcInFile&) = default;
};
struct SegmentInFile {
  std::optional<Vec2> start, end;
  friend bool operator==(const SegmentInFile&, const SegmentInFile&) = default;
};
struct CurveInFile {
  std::optional<ArcInFile> arc;
  std::optional<SegmentInFile> segment;
};

template <>
struct Table<ArcInFile> {
  static constexpr std::tuple members{
      Member{"start", &ArcInFile::start, {"where it starts", "m", -kMetres, kMetres, true}},
      Member{"end", &ArcInFile::end, {"where it ends, counter-clockwise from the start", "m", -kMetres, kMetres, true}},
      Member{"center", &ArcInFile::center, {"centre of its circle", "m", -kMetres, kMetres, true}}};
};

template <>
struct Table<SegmentInFile> {
  static constexpr std::tuple members{
      Member{"start",
             &SegmentInFile::start,
             {"where it starts; the medial axis of the group when both ends are absent", "m", -kMetres, kMetres}},
      Member{"end", &SegmentInFile::end, {"where it ends", "m", -kMetres, kMetres}}};
};

template <>
struct Table<CurveInFile> {
  static constexpr std::tuple members{Member{"arc", &CurveInFile::arc, {"part of a circle"}},
                                      Member{"segment", &CurveInFile::segment, {"part of a straight line"}}};
};

/// What is wrong with the curve, or nothing and `out` is set.
inline std::optional<std::string> curve_from_file(const CurveInFile& file, Curve& out) {
  if (file.arc.has_value() == file.segment.has_value()) return "a curve is either an arc or a segment";
  if (file.arc) {
    if (file.arc->start == file.arc->center || file.arc->end == file.arc->center) return "the arc has no radius";
    out = {Curve::Kind::arc, file.arc->start, file.arc->end, file.arc->center, false};
    return std::nullopt;
  }
  const SegmentInFile& s = *file.segment;
  if (s.start.has_value() != s.end.has_value()) return "a segment has both a start and an end, or neither";
  out = {Curve::Kind::segment, s.start.value_or(Vec2{}), s.end.value_or(Vec2{}), {}, !s.start};
  return std::nullopt;
}

inline CurveInFile curve_to_file(const Curve& curve) {
  CurveInFile file;
  if (curve.kind == Curve::Kind::arc) {
    file.arc = {curve.start, curve.end, curve.center};
  } else {
    file.segment.emplace();
    if (!curve.medial_axis) file.segment->start = curve.start, file.segment->end = curve.end;
  }
  return file;
}

}  // namespace inhabit::io
