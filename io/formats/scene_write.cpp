#include "io/formats/object_writer.h"
#include "io/formats/scene_curve.h"
#include "io/formats/scene_json.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// Appends a scene as compact JSON.
class SceneWriter : public ObjectWriter<SceneWriter> {
 public:
  explicit SceneWriter(const Scene& scene) : scene_(scene) {}

  std::string text() {
    out_ = "{";
    key("format"), append_quoted(out_, kFormatName);
    key("version"), append_number(out_, kFormatVersion);
    members(scene_);
    out_ += '}';
    return std::move(out_);
  }

 private:
  friend class ObjectWriter<SceneWriter>;
  using ObjectWriter::write;

  void write(Vec2 v, const Spec& spec) { list(std::array{v.x, v.y}, spec); }
  void write(const Vec3& v, const Spec& spec) { list(std::array{v.x, v.y, v.z}, spec); }
  void write(Ref ref, const Spec&) { append_quoted(out_, scene_.id_of(ref)); }
  void write(const std::array<Ref, 2>& refs, const Spec& spec) { list(refs, spec); }
  void write(const Members& m, const Spec& spec) {
    if (m.all_of.none()) {
      list(m.list, spec);
    } else {
      write(m.all_of, spec);
    }
  }
  void write(const Curve& curve, const Spec&) { object(curve_to_file(curve)); }
  void write(const Span& span, const Spec& spec) {
    if (span.low == span.high) return write(span.low, spec);
    list(std::array{span.low, span.high}, spec);
  }
  void write(const Route& route, const Spec& spec) {
    if (route.legs.size() == 1 && route.legs[0].size() == 1) return write(route.legs[0][0], spec);
    out_ += '[';
    for (const auto& leg : route.legs) {
      comma();
      leg.size() == 1 ? write(leg[0], spec) : list(leg, spec);
    }
    out_ += ']';
  }
  void write(const CrowdModel& model, const Spec&) {
    std::visit(
        [&]<class T>(const T& m) {
          out_ += '{';
          key("type"), append_quoted(out_, T::kName);
          if constexpr (std::is_same_v<T, PbdModel>) {
            const auto& preset = PbdModel::kFields.front();
            key(preset.name), write(m.preset, Spec{.choices = preset.choices});
          }
          members(m);
          out_ += '}';
        },
        model);
  }
  void write(const Constraints& constraints, const Spec&) {
    out_ += '[';
    for (const auto& place : constraints.order) {
      const std::size_t kind = place.first, index = place.second;  // clang 14 captures no structured bindings
      std::size_t k = 0;
      for_each_type(ConstraintKinds{}, [&]<class T>(std::type_identity<T>) {
        if (k++ != kind) return;
        comma(), out_ += '{';
        key("type"), append_quoted(out_, T::kName);
        members(constraints.of<T>()[index]);
        out_ += '}';
      });
    }
    out_ += ']';
  }

  const Scene& scene_;
};

}  // namespace

std::string write_scene(const Scene& scene) { return pretty_json(SceneWriter(scene).text()); }

}  // namespace inhabit::io
