#pragma once
#include "io/formats/value_reader.h"

/// Objects of a JSON document by the tables of their members (scene_members.h, priors_members.h).
namespace inhabit::io {

/// Reads whatever has a table; `Self` derives from it and reads, by overloads of `read`, what is its own. A member that
/// the table does not know is an error, with the nearest name it could have been; `x-…` members are kept as extras.
template <class Self>
class ObjectReader : public ValueReader {
 protected:
  using ValueReader::read;
  Self& self() { return static_cast<Self&>(*this); }

  /// "format" and "version", where they are given.
  bool check_header(JsonValue root, std::string_view name, int version) {
    if (const JsonValue v = root.find("format"); !v.none() && v.text() != name)
      return fail(v, "is not \"" + std::string(name) + "\"");
    const JsonValue v = root.find("version");
    if (v.none() || v.text() == std::to_string(version)) return true;
    return fail(v, v.is(Json::number) && v.number() > version
                       ? "written by a newer inhabit; this one reads version " + std::to_string(version)
                       : "is not " + std::to_string(version));
  }

  template <class T>
  bool check_unknown(JsonValue v, std::vector<std::string_view> known) {
    for_each_member<T>([&](std::string_view name, auto, const Spec&) { known.push_back(name); });
    constexpr bool kExtras = requires(T t) { t.extras; };
    for (const JsonValue member : v) {
      if ((kExtras && member.key().starts_with("x-")) || std::ranges::find(known, member.key()) != known.end())
        continue;
      return fail(member, "unknown key" + did_you_mean(member.key(), known));
    }
    return true;
  }

  template <class T>
  bool read_object(JsonValue v, T& out, const std::vector<std::string_view>& also = {}) {
    if (!expect(v, Json::object)) return false;
    std::size_t known = 0;
    for_each_member<T>([&](std::string_view name, auto, const Spec&) { known += v.find(name).none() ? 0 : 1; });
    if (known < v.size() && !check_unknown<T>(v, also)) return false;
    bool good = true;
    for_each_member<T>([&](std::string_view name, auto pointer, const Spec& spec) {
      if (!good) return;
      const JsonValue member = v.find(name);
      if (member.none()) {
        if (spec.required) good = fail(v, "\"" + std::string(name) + "\" is missing");
      } else {
        good = self().read(member, out.*pointer, spec);
      }
    });
    if constexpr (HasTable<T>) good = good && check_company<T>(v);
    if constexpr (requires { out.extras; }) {
      if (good && known < v.size()) {
        for (const JsonValue member : v) {
          if (member.key().starts_with("x-")) out.extras.emplace_back(member.key(), flat_json(member));
        }
      }
    }
    return good;
  }

  /// What may, must and must not stand together in an object.
  template <class T>
  bool check_company(JsonValue v) {
    const auto given = [&](std::string_view name) { return !v.find(name).none(); };
    if constexpr (requires { Table<T>::needs_one_of; }) {
      if (std::ranges::none_of(Table<T>::needs_one_of, given))
        return fail(v, "needs one of: " + joined(Table<T>::needs_one_of));
    }
    if constexpr (requires { Table<T>::exactly_one_of; }) {
      if (std::ranges::count_if(Table<T>::exactly_one_of, given) != 1)
        return fail(v, "needs exactly one of: " + joined(Table<T>::exactly_one_of));
    }
    if constexpr (requires { Table<T>::only_with; }) {
      for (const OnlyWith& rule : Table<T>::only_with) {
        if (given(rule.name) && !given(rule.with))
          return fail(v.find(rule.name), "means nothing without \"" + std::string(rule.with) + "\"");
      }
    }
    return true;
  }
  template <class T>
  bool read(JsonValue v, std::optional<T>& out, const Spec& spec) {
    return self().read(v, out.emplace(), spec);
  }
  // The condition stands behind the parameters: before them, clang takes this for the enumerations' read() and hides
  // that.
  template <class T>
  bool read(JsonValue v, T& out, const Spec&) requires HasTable<T> {
    return read_object(v, out);
  }
  template <class T>
  requires HasTable<T>
  bool read(JsonValue v, std::vector<T>& out, const Spec& spec) {
    if (!expect(v, Json::array)) return false;
    out.reserve(v.size());
    for (const JsonValue item : v) {
      if (!self().read(item, out.emplace_back(), spec)) return false;
    }
    return true;
  }
};

}  // namespace inhabit::io
