#pragma once

#include <string>

/// Text and numbers as the report writes them.
namespace slfb {

/// `text` with the characters that HTML gives a meaning to replaced by entities.
std::string escape_html(const std::string& text);

/// Subscripts of symbols set as such: "U_L" becomes U<sub>L</sub>; names of files and keys stay as they are.
std::string with_subscripts(const std::string& html);

/// A sentence: escape_html and with_subscripts.
std::string prose_html(const std::string& text);

/// Four significant digits, without an exponent where that is readable: "0.0424", "51750", "1.2·10<sup>-5</sup>". A
/// dash for what is not a number. The result is HTML.
std::string readable_number(double value);

/// Seconds as a reader takes them in: "42 s", "12 min", "3.4 h".
std::string readable_duration(double seconds);

}  // namespace slfb
