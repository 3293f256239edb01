#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace app::rpc {

using nlohmann::json;

/// Of the protocol.
enum class ErrorCode : int {
    ParseError = -32700,
    InvalidRequest = -32600,
    MethodNotFound = -32601,
    InvalidParams = -32602,
    InternalError = -32603,
    NotInitialized = -32002,
    RequestFailed = -32803,
};

/// A request that cannot be answered.
class Refusal : public std::runtime_error {
public:
    Refusal(ErrorCode why, const std::string& text) : std::runtime_error(text), code(why) {}
    ErrorCode code;
};

/// Text as JSON, of bounded depth and number of values: a short message may not ask for much memory. Throws Refusal.
json guarded_json(std::string_view text);

/// As text; bytes that are no UTF-8 become U+FFFD.
std::string text_of(const json& value);

/// A member that has to be there and be a string. Throws Refusal.
const std::string& string_member(const json& object, const char* name);
/// A member that has to be there and be an object.
const json& object_member(const json& object, const char* name);
/// A count, from 0 to what fits: protocols' numbers are no larger.
std::uint32_t count_member(const json& object, const char* name);
/// Null where any of the members on the way is none.
const json* find_member(const json& object, std::initializer_list<const char*> way);
/// A string of an object that is given as text; empty where it is none, or text is no JSON.
std::string string_of(std::string_view text, const char* name);

}  // namespace app::rpc
