#include "render/app/mcp/server.h"

#include "render/app/mcp/guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <poll.h>
#include <utility>

// The Model Context Protocol, revision 2025-06-18, over standard input and output: a message a line.
namespace app::mcp {
namespace {

constexpr std::array<std::string_view, 3> kRevisions = {"2025-06-18", "2025-03-26", "2024-11-05"};  // newest first
constexpr auto kNoSuchResource = static_cast<ErrorCode>(-32002);
constexpr std::size_t kMostWaiting = 10'000;  // lines that are kept while a tool works

json tool_list()
{
    json list = json::array();
    for (const Tool& tool : tools()) {
        json schema = json::parse(fmt::format(R"({{"type": "object", "properties": {{{}}}, "required": {}, )"
                                              R"("additionalProperties": false}})",
                                              tool.properties, tool.required));
        list.push_back({{"name", tool.name},
                        {"title", tool.title},
                        {"description", tool.meaning},
                        {"inputSchema", std::move(schema)},
                        {"annotations", {{"readOnlyHint", true}, {"openWorldHint", false}}}});
    }
    return {{"tools", std::move(list)}};
}

/// Lists are short: there is one page of each.
void refuse_cursor(const json& parameters)
{
    if (parameters.contains("cursor")) throw Refusal(ErrorCode::InvalidParams, "there is no such page");
}

void check_names(const Tool& tool, const json& arguments)
{
    const json known = json::parse(fmt::format("{{{}}}", tool.properties));
    for (const auto& [name, value] : arguments.items())
        if (!known.contains(name))
            throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' takes no '{}'", tool.name, name));
    for (const json& name : json::parse(tool.required))
        if (!arguments.contains(name.get<std::string>()))
            throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' wants '{}'", tool.name, name.get<std::string>()));
}

}  // namespace

Server::Server(Walls walls, rpc::Input& input, int input_file, rpc::Output& output)
    : input_(input), input_file_(input_file), output_(output),
      shop_(
          std::move(walls), [this] { return ended_ || waiting_.size() >= kMostWaiting ? -1 : input_file_; },
          [this] { return still_wanted(); })
{}

void Server::serve()
{
    std::string line;
    while (!output_.gone()) {
        if (!waiting_.empty()) {
            line = std::move(waiting_.front());
            waiting_.pop_front();
        } else {
            const rpc::Input::What what = input_.next_line(line);
            if (what == rpc::Input::What::End) return;
            if (what == rpc::Input::What::TooLong) {
                refuse(ErrorCode::InvalidRequest, "the message is too long");
                continue;
            }
        }
        if (line.find_first_not_of(" \t\r") != std::string::npos) take(line);
    }
}

void Server::take(const std::string& line)
{
    json reply;
    try {
        const rpc::Call call = rpc::call_in(line);
        if (!call.wants_answer) return;  // an answer, or a notification: initialized, cancelled of what is done
        running_ = call.id;
        cancelled_ = false;
        try {
            reply = rpc::result_reply(call.id, result_of(call));
        } catch (const Refusal& refusal) {
            reply = rpc::error_reply(call.id, refusal.code, refusal.what());
        } catch (const std::exception& error) {
            reply = rpc::error_reply(call.id, ErrorCode::InternalError, error.what());
        }
    } catch (const Refusal& refusal) {
        return refuse(refusal.code, refusal.what());
    }
    running_ = nullptr;
    if (!cancelled_) send(reply);  // of what is cancelled nobody waits for an answer
}

json Server::result_of(const rpc::Call& call)
{
    const std::string& method = call.method;
    if (method == "ping") return json::object();
    if (method == "initialize") return initialize(call.parameters);
    if (!initialized_) throw Refusal(ErrorCode::InvalidRequest, "'initialize' has to come first");
    if (method == "tools/list") {
        refuse_cursor(call.parameters);
        return tool_list();
    }
    if (method == "tools/call") return call_tool(call.parameters);
    if (method == "resources/list") {
        refuse_cursor(call.parameters);
        return resource_list();
    }
    if (method == "resources/templates/list") return {{"resourceTemplates", json::array()}};
    if (method == "resources/read") {
        const std::string& uri = rpc::string_member(call.parameters, "uri");
        json contents = resource_contents(uri);
        if (contents.is_null()) throw Refusal(kNoSuchResource, fmt::format("there is no resource '{}'", uri));
        return contents;
    }
    throw Refusal(ErrorCode::MethodNotFound, fmt::format("there is no method '{}'", method));
}

json Server::initialize(const json& parameters)
{
    if (initialized_) throw Refusal(ErrorCode::InvalidRequest, "the server is initialized already");
    const std::string& asked = rpc::string_member(parameters, "protocolVersion");
    const bool known = std::find(kRevisions.begin(), kRevisions.end(), asked) != kRevisions.end();
    initialized_ = true;
    return {{"protocolVersion", known ? asked : std::string(kRevisions.front())},
            {"capabilities", {{"tools", json::object()}, {"resources", json::object()}}},
            {"serverInfo", {{"name", "whittle"}, {"title", "Whittle"}, {"version", WHITTLE_VERSION}}},
            {"instructions", instructions()}};
}

json Server::call_tool(const json& parameters)
{
    const std::string& name = rpc::string_member(parameters, "name");
    const auto given = parameters.find("arguments");
    const json none = json::object();
    if (given != parameters.end() && !given->is_object())
        throw Refusal(ErrorCode::InvalidParams, "'arguments' has to be an object");
    const json& arguments = given != parameters.end() ? *given : none;
    for (const Tool& tool : tools()) {
        if (tool.name != name) continue;
        check_names(tool, arguments);
        try {
            return tool.call(shop_, arguments);
        } catch (const ToolFailure& failure) {
            return text_result(failure.what(), true);
        }
    }
    throw Refusal(ErrorCode::InvalidParams, fmt::format("there is no tool '{}'", name));
}

/// While a tool works: what the client says is heard.
bool Server::still_wanted()
{
    pollfd waits{input_file_, POLLIN, 0};
    while (!ended_ && waiting_.size() < kMostWaiting && ::poll(&waits, 1, 0) > 0) {
        if (!input_.fill()) ended_ = true;
        std::string line;
        while (const auto what = input_.waiting_line(line)) {
            if (what == rpc::Input::What::TooLong) refuse(ErrorCode::InvalidRequest, "the message is too long");
            else if (!listen_while_busy(line)) waiting_.push_back(line);
        }
    }
    return !cancelled_ && !output_.gone();
}

/// True: there is no more to do about it.
bool Server::listen_while_busy(const std::string& line)
{
    try {
        const rpc::Call call = rpc::call_in(line);
        if (call.method == "ping" && call.wants_answer) {
            send(rpc::result_reply(call.id, json::object()));
            return true;
        }
        if (call.method != "notifications/cancelled") return false;
        const json* const id = rpc::find_member(call.parameters, {"requestId"});
        if (id == nullptr) return true;
        if (*id == running_) cancelled_ = true;
        // One that has not begun is not begun.
        std::erase_if(waiting_, [&](const std::string& other) {
            try {
                const rpc::Call waiting = rpc::call_in(other);
                return waiting.wants_answer && waiting.id == *id;
            } catch (const Refusal&) {
                return false;
            }
        });
        return true;
    } catch (const Refusal&) {
        return false;  // it is answered in its turn
    }
}

}  // namespace app::mcp
