#include "render/app/options/nearest.h"

#include "parser/base/nearest.h"
#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"

#include <fmt/format.h>

namespace app {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names, std::string_view before)
{
    const std::string nearest = parser::nearest_of(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}{}'?", before, nearest);
}

std::string nearest_keyword(std::string_view word)
{
    std::vector<std::string> names;
    for (const Option& option : option_table()) names.emplace_back(option.keyword);
    return did_you_mean(word, names);
}

std::string nearest_own_option(std::string_view word)
{
    std::vector<std::string> names;
    for (const OwnOption& option : own_options()) names.emplace_back(option.name);
    return did_you_mean(word.substr(2, word.find('=') - 2), names, "--");
}

}  // namespace app
