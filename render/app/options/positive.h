#pragma once

#include "render/app/options/settings.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace app {

/// The number at the beginning of an option's value, above 0 and at most `most`; what follows it in `rest`. Throws
/// OptionError.
inline double positive(const std::string& option, const std::string& value, double most, std::string& rest)
{
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || !(number > 0.0) || !(number <= most))
        throw OptionError(fmt::format("{} wants a number above 0 and at most {:g}, found '{}'", option, most, value));
    rest.assign(end, value.data() + value.size());
    return number;
}

/// The same where nothing may follow.
inline double whole_positive(const std::string& option, const std::string& value, double most = 1e9)
{
    std::string rest;
    const double number = positive(option, value, most, rest);
    if (!rest.empty()) throw OptionError(fmt::format("{} wants a number alone, found '{}'", option, value));
    return number;
}

}  // namespace app
