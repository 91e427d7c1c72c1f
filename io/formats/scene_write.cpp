#include "io/formats/scene_curve.h"
#include "io/formats/scene_json.h"
#include "io/formats/scene_members.h"
#include "io/json_text.h"

namespace inhabit::io {
namespace {

/// Appends a scene as compact JSON.
class SceneWriter {
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
  void comma() {
    if (out_.back() != '{' && out_.back() != '[') out_ += ',';
  }
  void key(std::string_view name) { comma(), append_quoted(out_, name), out_ += ':'; }

  template <class T>
  void object(const T& value) {
    out_ += '{', members(value), out_ += '}';
  }
  template <class T>
  void members(const T& value) {
    const T absent = default_like(value);
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      if (!spec.required && value.*pointer == absent.*pointer) return;
      key(name);
      write(value.*pointer, spec);
    });
    if constexpr (requires { value.extras; }) {
      for (const auto& [name, text] : value.extras) {
        key(name);
        // An extra that a program set to something else than JSON is kept as a text.
        JsonDocument::parse(text).ok() ? out_ += text : (append_quoted(out_, text), out_);
      }
    }
  }

  void write(double value, const Spec& spec) { append_number(out_, spec.unit == "rad" ? file_degrees(value) : value); }
  void write(bool value, const Spec&) { out_ += value ? "true" : "false"; }
  void write(int value, const Spec& spec) {
    if (spec.choices.empty()) {
      append_number(out_, value);
    } else {
      append_quoted(out_, split_choices(spec.choices).at(static_cast<std::size_t>(value)));
    }
  }
  void write(std::uint64_t value, const Spec&) { out_ += std::to_string(value); }
  void write(const std::string& value, const Spec&) { append_quoted(out_, value); }
  template <class E>
  requires std::is_enum_v<E>
  void write(E value, const Spec& spec) { write(static_cast<int>(value), spec); }
  template <class T>
  void write(const std::optional<T>& value, const Spec& spec) {
    write(*value, spec);
  }
  void write(Vec2 v, const Spec& spec) { list(std::array{v.x, v.y}, spec); }
  void write(const Vec3& v, const Spec& spec) { list(std::array{v.x, v.y, v.z}, spec); }
  void write(Ref ref, const Spec&) { append_quoted(out_, scene_.id_of(ref)); }
  void write(const std::array<Ref, 2>& refs, const Spec& spec) { list(refs, spec); }
  template <class T>
  void write(const std::vector<T>& items, const Spec& spec) {
    list(items, spec);
  }
  void write(const Members& m, const Spec& spec) {
    if (m.all_of.none()) {
      list(m.list, spec);
    } else {
      write(m.all_of, spec);
    }
  }
  template <class T>
  requires HasTable<T>
  void write(const T& value, const Spec&) { object(value); }
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

  template <class List>
  void list(const List& items, const Spec& spec) {
    out_ += '[';
    for (const auto& item : items) comma(), write(item, spec);
    out_ += ']';
  }

  const Scene& scene_;
  std::string out_;
};

}  // namespace

std::string write_scene(const Scene& scene) { return pretty_json(SceneWriter(scene).text()); }

}  // namespace inhabit::io
