#pragma once
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/core.h"

/// JSON as the readers of this layer see it: read only, in document order, with every number's text kept and with the
/// place of a value in the document at hand when something is wrong with it.
namespace inhabit::io {
using namespace core;

struct JsonLimits {
  std::size_t bytes = std::size_t{256} << 20;
  int depth = 64;  ///< so that walking a document can never exhaust the stack
  std::size_t values = 40'000'000;
};

/// A parsed document: one flat array in document order, 32 bytes per value.
class JsonDocument {
 public:
  enum class Kind : std::uint8_t { null, boolean, number, text, array, object };
  class Value;

  /// Errors: malformed JSON (`where` holds line and column), a key given twice in one object (a JSON pointer), invalid
  /// UTF-8, a number that no double can hold, and everything beyond the limits.
  static Result<JsonDocument> parse(std::string_view text, const JsonLimits& limits = {});

  /// Valid as long as the document stays where it is.
  Value root() const;

 private:
  friend class JsonBuilder;
  struct Node {
    std::uint32_t end = 0;  ///< one past the last value inside this one; 0 while it is being read
    std::uint32_t key = 0, key_size = 0;
    std::uint32_t text = 0, size = 0;  ///< bytes of a text or of a number as written; number of children
    Kind kind = Kind::null;
    double number = 0;
  };
  std::string pointer(std::uint32_t target) const;
  Status check_keys() const;

  std::vector<Node> nodes_;
  std::string pool_;
};

class JsonDocument::Value {
 public:
  Value(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}

  Kind kind() const { return node().kind; }
  bool is(Kind kind) const { return node().kind == kind; }
  bool boolean() const { return node().number != 0; }
  double number() const { return node().number; }
  /// The characters of a text, or of a number as the file has them.
  std::string_view text() const { return piece(node().text, node().size); }
  /// The name under which this value stands in its object.
  std::string_view key() const { return piece(node().key, node().key_size); }
  /// Number of items or members.
  std::size_t size() const { return is(Kind::array) || is(Kind::object) ? node().size : 0; }
  /// The member called `name`; a value that is `none` when there is none or this is no object. Cost: members of the
  /// object.
  Value find(std::string_view name) const;
  bool none() const { return document_ == nullptr; }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Value;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Value;

    Iterator(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}
    Value operator*() const { return {document_, index_}; }
    Iterator& operator++() { return index_ = document_->nodes_[index_].end, *this; }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const JsonDocument* document_;
    std::uint32_t index_;
  };
  Iterator begin() const { return {document_, index_ + 1}; }
  Iterator end() const { return {document_, node().end}; }

  /// Where the value stands: a JSON pointer (RFC 6901).
  std::string pointer() const { return document_->pointer(index_); }
  Error error(std::string message) const { return invalid(pointer(), std::move(message)); }

 private:
  const Node& node() const { return document_->nodes_[index_]; }
  std::string_view piece(std::uint32_t at, std::uint32_t size) const {
    return std::string_view(document_->pool_).substr(at, size);
  }
  const JsonDocument* document_;
  std::uint32_t index_;
};

inline JsonDocument::Value JsonDocument::root() const { return {this, 0}; }
using Json = JsonDocument::Kind;
using JsonValue = JsonDocument::Value;

/// "a number", "a text", …: what a value is, for messages.
std::string_view name_of(Json kind);

}  // namespace inhabit::io
