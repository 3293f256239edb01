#pragma once

#include "render/model/base/model.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace model {

/// For a message.
inline std::string shortened(std::string_view word)
{
    constexpr std::size_t kMost = 40;
    return std::string(word.substr(0, kMost)) + (word.size() > kMost ? "..." : "");
}

/// Words of a text between blanks, with the line that the last one stands on.
class TextWords {
public:
    explicit TextWords(std::string_view text, std::size_t line = 1)
        : at_(text.data()), end_(text.data() + text.size()), line_(line)
    {}

    /// Empty: there are no more.
    std::string_view next()
    {
        for (; at_ != end_ && blank(*at_); ++at_) line_ += *at_ == '\n';
        const char* const from = at_;
        while (at_ != end_ && !blank(*at_)) ++at_;
        return {from, static_cast<std::size_t>(at_ - from)};
    }
    void skip_line()
    {
        while (at_ != end_ && *at_ != '\n') ++at_;
    }
    template <class Number>
    Number number()
    {
        const std::string_view word = next();
        if (word.empty()) fail("a number is missing: it ends");
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        Number value{};
        const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (failed == std::errc::result_out_of_range && std::is_floating_point_v<Number> && !large(digits)) return 0;
        bool good = failed == std::errc() && end == digits.data() + digits.size();
        if constexpr (std::is_floating_point_v<Number>) good = good && std::isfinite(value);
        if (!good) fail("'" + shortened(word) + "' is no number that can stand here");
        return value;
    }
    [[noreturn]] void fail(const std::string& what) const { throw ModelError(what, line_); }
    std::size_t line() const { return line_; }

private:
    static bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    /// Of a number out of range: above it, not too near to 0.
    static bool large(std::string_view digits)
    {
        const std::size_t e = digits.find_first_of("eE");
        return e == std::string_view::npos || digits.substr(e + 1, 1) != "-";
    }

    const char *at_, *end_;
    std::size_t line_;
};

}  // namespace model
