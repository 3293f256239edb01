#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

/// ASCII text as options use it: the same in every locale.
namespace app {

inline char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline char upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Equal but for case.
inline bool same_text(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower_case(x) == lower_case(y); });
}

inline bool starts_with_text(std::string_view text, std::string_view start)
{
    return text.size() >= start.size() && same_text(text.substr(0, start.size()), start);
}
inline bool ends_with_text(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && same_text(text.substr(text.size() - end.size()), end);
}

/// Without blanks at either end.
inline std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The pieces of a text between separators. Not by a string stream: the first stream of a run makes the standard
/// library's locales, which takes 0.4 ms in a virtual machine.
inline std::vector<std::string_view> pieces_of(std::string_view text, char separator)
{
    std::vector<std::string_view> pieces;
    for (;;) {
        const std::size_t end = text.find(separator);
        pieces.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return pieces;
        text.remove_prefix(end + 1);
    }
}

/// A word for the shell, whatever is in it.
inline std::string shell_word(const std::string& word)
{
    std::string out = "'";
    for (const char c : word) {
        if (c == '\'') out += "'\\''";
        else out += c;
    }
    return out + '\'';
}

}  // namespace app
