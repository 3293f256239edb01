#include "render/app/rpc/guarded_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace app::rpc {
namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMostValues = 1'000'000;

void check_size(std::string_view text)
{
    int depth = 0;
    std::size_t values = 1;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (quoted) {
            if (c == '\\') ++at;
            else if (c == '"') quoted = false;
            continue;
        }
        if (c == '"') quoted = true;
        else if (c == '{' || c == '[') ++depth, ++values;
        else if (c == '}' || c == ']') --depth;
        else if (c == ',' || c == ':') ++values;
        if (depth > kDeepest) throw Refusal(ErrorCode::ParseError, "the message is nested too deeply");
        if (values > kMostValues) throw Refusal(ErrorCode::ParseError, "the message has too many values");
    }
}

[[noreturn]] void lacks(const char* name, const char* what)
{
    throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' has to be {}", name, what));
}

}  // namespace

json guarded_json(std::string_view text)
{
    check_size(text);
    json value = json::parse(text, nullptr, false);
    if (value.is_discarded()) throw Refusal(ErrorCode::ParseError, "the message is no JSON");
    return value;
}

std::string text_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

const json* find_member(const json& object, std::initializer_list<const char*> way)
{
    const json* at = &object;
    for (const char* name : way) {
        if (!at->is_object()) return nullptr;
        const auto found = at->find(name);
        if (found == at->end()) return nullptr;
        at = &*found;
    }
    return at;
}

const std::string& string_member(const json& object, const char* name)
{
    const json* const found = find_member(object, {name});
    if (found == nullptr || !found->is_string()) lacks(name, "a text");
    return found->get_ref<const std::string&>();
}

const json& object_member(const json& object, const char* name)
{
    const json* const found = find_member(object, {name});
    if (found == nullptr || !found->is_object()) lacks(name, "an object");
    return *found;
}

std::uint32_t count_member(const json& object, const char* name)
{
    const json* const found = find_member(object, {name});
    if (found == nullptr || !found->is_number()) lacks(name, "a number");
    const double value = found->get<double>();
    constexpr double kMost = 2147483647;
    return value >= 0 ? static_cast<std::uint32_t>(std::min(value, kMost)) : 0;
}

std::string string_of(std::string_view text, const char* name)
{
    const json object = json::parse(text, nullptr, false);
    const json* const found = find_member(object, {name});
    return found && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace app::rpc
