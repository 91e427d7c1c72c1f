#pragma once
#include "io/json_document.h"

/// JSON written for people to read.
namespace inhabit::io {

/// Appends `text` in quotation marks. Bytes that are no UTF-8 become U+FFFD.
void append_quoted(std::string& out, std::string_view text);
/// `text` in quotation marks, cut after 80 bytes: for messages.
std::string quoted(std::string_view text);
/// Appends the shortest decimal that reads back as the same double, without an exponent from 1e-6 to 1e15; null when
/// not finite.
void append_number(std::string& out, double value);
/// The same as text.
std::string number_text(double value);

/// The value on one line, numbers as the source has them: `{"a": 1, "b": [1, 2]}`.
std::string flat_json(JsonValue value);
/// Two-space indentation; what fits into 110 columns stays on one line, and so do plain lists of numbers. Ends with a
/// newline.
std::string pretty_json(JsonValue value);
/// The same for text that is known to be JSON; text that is not comes back as it was.
std::string pretty_json(std::string_view text);

}  // namespace inhabit::io
