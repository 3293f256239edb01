#pragma once

#include "render/app/rpc/guarded_json.h"

#include <string>
#include <string_view>

/// JSON-RPC 2.0: what protocols of editors and of agents have in common.
namespace app::rpc {

/// A request or a notification.
struct Call {
    json id;            ///< of a request: a number or a text
    bool wants_answer;  ///< a notification does not
    std::string method;
    json parameters;  ///< an object, empty where none was given
};

/// What a message asks for; without a method: an answer, which nobody waits for. Throws Refusal.
Call call_in(std::string_view message);

json result_reply(const json& id, json result);
json error_reply(const json& id, ErrorCode code, const std::string& text);

}  // namespace app::rpc
