#pragma once

#include <string>
#include <string_view>

/// Texts of the scene language are sequences of 16-bit units (spec 1, 1.5). They are kept as UTF-8, a lone
/// surrogate in three bytes, so that plain ASCII costs nothing.
namespace parser {

bool is_ascii(std::string_view text);
std::u16string units_of(std::string_view text);     ///< the units of a text as it is kept
std::string from_units(std::u16string_view units);  ///< and back
/// Bytes that a file holds, read as UTF-8: what lies above the 16-bit units or is malformed becomes U+FFFD.
std::string from_utf8_bytes(std::string_view bytes);
/// Each byte is one unit.
std::string from_latin1(std::string_view bytes);
/// How a text leaves the program: units above 127 become blanks, before version 3.5 their low byte.
std::string printed(std::string text, int version);
/// What a backslash and this character stand for in a text; 0: nothing, or what needs more characters.
char escaped(char c);

}  // namespace parser
