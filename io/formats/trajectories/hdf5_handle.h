#pragma once
#include <hdf5.h>

#include <mutex>
#include <optional>
#include <string>
#include <utility>

/// The C library behind RAII. It keeps its state in globals and Debian's is built without locks: whoever calls it holds
/// an Hdf5Session.
namespace inhabit::io {

/// The only user of the library while it lives; the library's own error messages are silent.
class Hdf5Session {
 public:
  Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

/// An identifier that is closed at the end. Below 0: the call that made it failed.
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { close(); }
  /// False when the library could not.
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// The attribute as text or as a number, when it is there and is one value of that kind.
std::optional<std::string> hdf5_text(hid_t object, const char* name);
std::optional<double> hdf5_number(hid_t object, const char* name);
/// Texts are of variable length and UTF-8: so h5py returns them as str.
bool set_hdf5_text(hid_t object, const char* name, const std::string& value);
bool set_hdf5_number(hid_t object, const char* name, double value);
bool set_hdf5_whole(hid_t object, const char* name, std::int64_t value);

}  // namespace inhabit::io
