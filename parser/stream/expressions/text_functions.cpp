#include "parser/stream/expressions/text_functions.h"

#include "parser/stream/expressions/fixed_text.h"
#include "parser/stream/expressions/operand.h"
#include "parser/stream/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace parser {

std::size_t length_of(const std::string& text) { return is_ascii(text) ? text.size() : units_of(text).size(); }

double first_of(const std::string& text)
{
    if (text.empty()) return 0.0;
    return is_ascii(text.substr(0, 1)) ? text[0] : units_of(text)[0];
}

namespace {

template <class Text>
double difference(const Text& a, const Text& b)
{
    for (std::size_t i = 0; i < a.size() || i < b.size(); ++i) {
        const int p = i < a.size() ? a[i] : 0;
        const int q = i < b.size() ? b[i] : 0;
        if (p != q) return p - q;
    }
    return 0.0;
}

}  // namespace

double order_of(const std::string& a, const std::string& b)
{
    return is_ascii(a) && is_ascii(b) ? difference(a, b) : difference(units_of(a), units_of(b));
}

bool keep_part(std::string& text, double first_wanted, double count_wanted)
{
    const int first = to_int32(first_wanted), count = to_int32(count_wanted);
    if (first < 1 || count < 0 || static_cast<long>(first) + count - 1 > static_cast<long>(length_of(text)))
        return false;
    const auto begin = static_cast<std::size_t>(first - 1), length = static_cast<std::size_t>(count);
    text = is_ascii(text) ? text.substr(begin, length) : from_units(units_of(text).substr(begin, length));
    return true;
}

bool text_of_code(double code, std::string& out)
{
    if (!(code >= 0.0 && code < 65536.0)) return false;
    const auto unit = static_cast<char16_t>(static_cast<unsigned>(code));
    out = unit == 0 ? std::string() : from_units(std::u16string_view(&unit, 1));
    return true;
}

void change_case(std::string& text, bool upper)
{
    for (char& c : text) {
        if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    }
}

namespace {

/// C's %.*f with leading blanks or zeros, by the quicker ways for numbers of ordinary size.
bool add_plain_number(std::string& to, double value, int width, int precision)
{
    constexpr double kLargest = 1e15;
    constexpr int kMostDecimals = 40, kMostWidth = 60;
    if (!(std::abs(value) < kLargest) || precision > kMostDecimals || std::abs(width) > kMostWidth) return false;
    char digits[80];
    const char* end = digits + kFixedText;
    const char* begin = fixed_text(digits + kFixedText, value, precision);
    if (!begin) {
        begin = digits;
        end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, precision).ptr;
    }
    const auto length = static_cast<std::size_t>(end - begin), wanted = static_cast<std::size_t>(std::abs(width));
    if (length >= wanted) {
        to.append(begin, end);
        return true;
    }
    const bool minus = width < 0 && *begin == '-';
    if (minus) to += *begin++;
    to.append(wanted - length, width < 0 ? '0' : ' ').append(begin, end);
    return true;
}

}  // namespace

void add_number_text(std::string& to, double value, double width_wanted, double precision_wanted)
{
    constexpr int kLongest = 255, kMost = 2 * kLongest;
    const int width = std::clamp(to_int32(width_wanted), -kMost, kMost);
    const int precision = precision_wanted < 0 ? 6 : std::clamp(to_int32(precision_wanted), 0, kMost);
    if (add_plain_number(to, value, width, precision)) return;
    char text[kLongest];
    int length = std::snprintf(text, sizeof text, width < 0 ? "%0*.*f" : "%*.*f", std::abs(width), precision, value);
    if (length >= kLongest)
        length = std::snprintf(text, sizeof text, width < 0 ? "%0*.*g" : "%*.*g", std::abs(width), precision, value);
    if (length >= kLongest) to += "<invalid>";
    else to.append(text, static_cast<std::size_t>(length));
}

std::string tuple_text(double count_wanted, const double* value, int known, const std::string& separator, double width,
                       double precision)
{
    const int count = std::clamp(to_int32(count_wanted), 2, 5);
    std::string text;
    for (int i = 0; i < count; ++i) {
        if (i > 0) text += separator;
        add_number_text(text, i < known ? value[i] : 0.0, width, precision);
    }
    return text;
}

}  // namespace parser
