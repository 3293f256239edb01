#pragma once

#include <string>

/// Built-in functions of texts, for whoever has read their operands.
namespace parser {

std::size_t length_of(const std::string& text);  ///< strlen
double first_of(const std::string& text);        ///< asc
/// strcmp: how the first characters that are not the same differ.
double order_of(const std::string& a, const std::string& b);
/// substr. False: it reaches outside of the text.
bool keep_part(std::string& text, double first, double count);
/// chr. False: there is no such character.
bool text_of_code(double code, std::string& out);
/// strupr or strlwr, of the letters of ASCII.
void change_case(std::string& text, bool upper);
/// str(): C's %*.*f, where width < 0 pads with zeros and precision < 0 means 6 decimals; very long numbers use %g.
/// Behind what stands in `to`.
void add_number_text(std::string& to, double value, double width_wanted, double precision_wanted);
inline std::string number_text(double value, double width_wanted, double precision_wanted)
{
    std::string text;
    add_number_text(text, value, width_wanted, precision_wanted);
    return text;
}
/// vstr of a value of `known` components; missing ones are 0.
std::string tuple_text(double count, const double* value, int known, const std::string& separator, double width,
                       double precision);

}  // namespace parser
