#include "parser/stream/told_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace parser {
namespace {

constexpr std::size_t kMostValues = 20'000;
constexpr std::size_t kLongestText = 200;  // bytes

std::string vector_text(std::span<const double> components)
{
    return fmt::format("<{:.6g}>", fmt::join(components.begin(), components.end(), ", "));
}

std::string tuple_text(const Tuple& tuple)
{
    if (tuple.count == 1) return fmt::format("{:.6g}", tuple.at[0]);
    const std::span<const double> all(tuple.at);
    if (tuple.count < 5) return vector_text(all.first(static_cast<std::size_t>(tuple.count)));
    if (tuple.at[3] == 0 && tuple.at[4] == 0) return "rgb " + vector_text(all.first(3));
    return "rgbft " + vector_text(all);
}

}  // namespace

std::map<std::string, std::string> told_values(const Symbols& symbols, const Names& names)
{
    std::map<std::string, std::string> told;
    for (std::uint32_t name = 0; name < names.size() && told.size() < kMostValues; ++name) {
        const Value* const value = symbols.find(name);
        if (value == nullptr) continue;
        if (const auto* tuple = value->get_if<Tuple>()) told.emplace(names.word(name), tuple_text(*tuple));
        else if (const auto* text = value->get_if<std::string>(); text && text->size() <= kLongestText)
            told.emplace(names.word(name), fmt::format("\"{}\"", *text));
    }
    return told;
}

}  // namespace parser
