#pragma once
#include "io/formats/scene_members.h"
#include "io/json_text.h"

/// Objects as compact JSON by the tables of their members.
namespace inhabit::io {

/// Writes whatever has a table, leaving out what equals a default; `Self` derives from it and writes, by overloads of
/// `write`, what is its own.
template <class Self>
class ObjectWriter {
 protected:
  Self& self() { return static_cast<Self&>(*this); }

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
      self().write(value.*pointer, spec);
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
    self().write(*value, spec);
  }
  template <class T>
  void write(const std::vector<T>& items, const Spec& spec) {
    list(items, spec);
  }
  template <class T>
  requires HasTable<T>
  void write(const T& value, const Spec&) { object(value); }
  template <class List>
  void list(const List& items, const Spec& spec) {
    out_ += '[';
    for (const auto& item : items) comma(), self().write(item, spec);
    out_ += ']';
  }

  std::string out_;
};

}  // namespace inhabit::io
