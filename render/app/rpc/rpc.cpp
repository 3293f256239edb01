#include "render/app/rpc/rpc.h"

#include <utility>

namespace app::rpc {

Call call_in(std::string_view text)
{
    json message = guarded_json(text);
    if (!message.is_object()) throw Refusal(ErrorCode::InvalidRequest, "a message has to be an object");
    Call call{nullptr, false, {}, json::object()};
    const auto method = message.find("method");
    if (method == message.end() || !method->is_string()) {
        if (message.contains("result") || message.contains("error")) return call;
        throw Refusal(ErrorCode::InvalidRequest, "a message has to have a method");
    }
    call.method = method->get<std::string>();
    if (const auto id = message.find("id"); id != message.end()) {
        if (!id->is_string() && !id->is_number_integer())
            throw Refusal(ErrorCode::InvalidRequest, "an id has to be a number or a text");
        call.id = *id;
        call.wants_answer = true;
    }
    if (const auto given = message.find("params"); given != message.end() && given->is_object())
        call.parameters = std::move(*given);
    return call;
}

json result_reply(const json& id, json result)
{
    json reply = {{"jsonrpc", "2.0"}, {"id", id}};
    reply["result"] = std::move(result);
    return reply;
}

json error_reply(const json& id, ErrorCode code, const std::string& text)
{
    return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", text}}}};
}

}  // namespace app::rpc
