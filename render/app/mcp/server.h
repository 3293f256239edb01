#pragma once

#include "render/app/rpc/framing.h"
#include "render/app/mcp/tools.h"

#include <deque>
#include <string>

namespace app::mcp {

/// One client. Requests are answered one after the other; while a tool works, the client may cancel it and ask whether
/// the server lives.
class Server {
public:
    Server(Walls walls, rpc::Input& input, int input_file, rpc::Output& output);

    /// Until the client is gone.
    void serve();

private:
    void take(const std::string& line);
    void refuse(ErrorCode code, const std::string& text) { send(rpc::error_reply(nullptr, code, text)); }
    json result_of(const rpc::Call& call);
    json initialize(const json& parameters);
    json call_tool(const json& parameters);
    bool still_wanted();
    bool listen_while_busy(const std::string& line);
    void send(const json& message) { output_.send(rpc::text_of(message)); }

    rpc::Input& input_;
    const int input_file_;
    rpc::Output& output_;
    Workshop shop_;
    bool initialized_ = false;
    bool ended_ = false;               ///< nothing more comes from the client
    json running_;                     ///< id of the request that is being answered; null: none
    bool cancelled_ = false;           ///< that one
    std::deque<std::string> waiting_;  ///< lines that came meanwhile
};

}  // namespace app::mcp
