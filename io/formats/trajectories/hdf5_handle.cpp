#include "io/formats/trajectories/hdf5_handle.h"

#include <cmath>
#include <cstring>

namespace inhabit::io {
namespace {

constexpr std::size_t kLongestText = std::size_t{16} << 20;

// One per program because the library is.
std::recursive_mutex& library() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// The attribute `name` if it holds one value of the class.
Hdf5Handle open_attribute(hid_t object, const char* name, H5T_class_t wanted, Hdf5Handle& type) {
  if (H5Aexists(object, name) <= 0) return {};
  Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute) return {};
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
  type = Hdf5Handle(H5Aget_type(attribute.get()), H5Tclose);
  if (!space || !type || H5Tget_class(type.get()) != wanted || H5Sget_simple_extent_npoints(space.get()) != 1)
    return {};
  return attribute;
}

bool set_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  if (!space) return false;
  const Hdf5Handle attribute(H5Acreate2(object, name, file_type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute && H5Awrite(attribute.get(), memory_type, value) >= 0;
}

}  // namespace

Hdf5Session::Hdf5Session() : lock_(library()) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

std::optional<std::string> hdf5_text(hid_t object, const char* name) {
  Hdf5Handle type;
  const Hdf5Handle attribute = open_attribute(object, name, H5T_STRING, type);
  if (!attribute) return std::nullopt;
  if (H5Tis_variable_str(type.get()) > 0) {
    char* text = nullptr;
    const Hdf5Handle memory(H5Tcopy(type.get()), H5Tclose);
    if (!memory || H5Aread(attribute.get(), memory.get(), &text) < 0 || text == nullptr) return std::nullopt;
    std::string out(text, strnlen(text, kLongestText));
    H5free_memory(text);
    return out;
  }
  const std::size_t size = H5Tget_size(type.get());
  if (size == 0 || size > kLongestText) return std::nullopt;
  std::string out(size, '\0');
  if (H5Aread(attribute.get(), type.get(), out.data()) < 0) return std::nullopt;
  out.resize(strnlen(out.data(), size));
  return out;
}

std::optional<double> hdf5_number(hid_t object, const char* name) {
  double value = 0;
  for (const H5T_class_t kind : {H5T_FLOAT, H5T_INTEGER}) {
    Hdf5Handle type;
    const Hdf5Handle attribute = open_attribute(object, name, kind, type);
    if (attribute && H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) >= 0 && std::isfinite(value)) return value;
  }
  return std::nullopt;
}

bool set_hdf5_text(hid_t object, const char* name, const std::string& value) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  if (!type || H5Tset_size(type.get(), H5T_VARIABLE) < 0 || H5Tset_cset(type.get(), H5T_CSET_UTF8) < 0) return false;
  const char* text = value.c_str();
  return set_attribute(object, name, type.get(), type.get(), &text);
}
bool set_hdf5_number(hid_t object, const char* name, double value) {
  return set_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}
bool set_hdf5_whole(hid_t object, const char* name, std::int64_t value) {
  return set_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

}  // namespace inhabit::io
