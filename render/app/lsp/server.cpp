#include "render/app/lsp/server.h"

#include "render/app/lsp/asked.h"
#include "render/app/lsp/capabilities.h"
#include "render/app/rpc/rpc.h"
#include "render/app/lsp/uri.h"

#include <algorithm>
#include <array>
#include <csignal>

namespace app::lsp {
namespace {

struct Request {
    std::string_view method;
    json (*answer)(World&, const json&);
};

constexpr std::array kRequests = {
    Request{"textDocument/completion", completion},
    Request{"textDocument/hover", hover},
    Request{"textDocument/definition", definition},
    Request{"textDocument/references", references},
    Request{"textDocument/documentHighlight", highlights},
    Request{"textDocument/prepareRename", prepare_rename},
    Request{"textDocument/rename", rename},
    Request{"textDocument/documentSymbol", symbols},
    Request{"textDocument/foldingRange", folding},
    Request{"textDocument/documentColor", colors},
    Request{"textDocument/colorPresentation", color_presentation},
    Request{"textDocument/formatting", formatting},
    Request{"textDocument/rangeFormatting", range_formatting},
};

/// A file that others include and that need not stand alone.
bool is_include_file(const std::string& path)
{
    const auto ends = [&](std::string_view extension) {
        return path.size() >= extension.size() &&
               std::equal(extension.begin(), extension.end(),
                          path.end() - static_cast<std::ptrdiff_t>(extension.size()),
                          [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
    };
    return ends(".inc") || ends(".mcr");
}

}  // namespace

Server::Server(const Settings& settings, const Limits& limits, std::vector<std::string> library_path, Output& output)
    : output_(output),
      files_(std::move(library_path)), world_{files_,
                                              Encoding::Utf16,
                                              {},
                                              [this](const std::string& path, const std::string& name) {
                                                  return value_of(path, name);
                                              },
                                              [this](const std::string& path) { return uri_of(path); }},
      reader_(settings, limits, [this](Reading&& reading) { take_reading(std::move(reading)); }),
      watch_(world_, mutex_, [this](const json& message) { send(message); })
{}

void Server::complain(ErrorCode code, const std::string& text) { send(error_reply(nullptr, code, text)); }

bool Server::take(std::string_view text)
{
    const Call call = call_in(text);
    if (call.method.empty() && !call.wants_answer) return true;  // an answer: nothing was asked
    const std::lock_guard lock(mutex_);
    if (call.wants_answer) answer(call.id, call.method, call.parameters);
    else if (call.method == "exit") return false;
    else if (state_ == State::Running) notice(call.method, call.parameters);
    return true;
}

void Server::answer(const json& id, const std::string& method, const json& parameters)
{
    json reply;
    try {
        reply = result_reply(id, result_of(method, parameters));
    } catch (const Refusal& refusal) {
        reply = error_reply(id, refusal.code, refusal.what());
    } catch (const std::exception& error) {
        reply = error_reply(id, ErrorCode::InternalError, error.what());
    }
    send(reply);
}

json Server::result_of(const std::string& method, const json& parameters)
{
    if (state_ == State::ShutDown) throw Refusal(ErrorCode::InvalidRequest, "the server was shut down");
    if (method == "initialize") {
        if (state_ != State::New) throw Refusal(ErrorCode::InvalidRequest, "the server is initialized already");
        return initialize(parameters);
    }
    if (state_ == State::New) throw Refusal(ErrorCode::NotInitialized, "the server is not initialized");
    if (method == "shutdown") {
        state_ = State::ShutDown;
        return nullptr;
    }
    if (method == "textDocument/documentHighlight") tell_cursor(parameters);
    for (const Request& request : kRequests)
        if (request.method == method) return request.answer(world_, parameters);
    throw Refusal(ErrorCode::MethodNotFound, "there is no method '" + method + "'");
}

json Server::initialize(const json& parameters)
{
    world_.encoding = encoding_for(parameters);
    watch_.set_client(parameters);
    const json* const folders = find_member(parameters, {"workspaceFolders"});
    if (folders != nullptr && folders->is_array())
        for (const json& folder : *folders)
            if (const json* const uri = find_member(folder, {"uri"}); uri && uri->is_string())
                world_.folders.push_back(path_of_uri(*uri));
    if (const json* const root = find_member(parameters, {"rootUri"});
        world_.folders.empty() && root && root->is_string())
        world_.folders.push_back(path_of_uri(*root));
    if (const json* const process = find_member(parameters, {"processId"}); process && process->is_number_integer()) {
        const auto number = process->get<std::int64_t>();
        // In another container the number means nothing here.
        if (number > 1 && number < (1 << 30) && ::kill(static_cast<int>(number), 0) == 0)
            client_ = static_cast<int>(number);
    }
    state_ = State::Running;
    return capabilities(world_.encoding);
}

void Server::notice(const std::string& method, const json& parameters)
{
    try {
        if (method == "textDocument/didOpen") did_open(parameters);
        else if (method == "textDocument/didChange") did_change(parameters);
        else if (method == "textDocument/didClose") did_close(parameters);
        else if (method == "whittle/cursor") tell_cursor(parameters);
        else if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") read_all();
    } catch (const std::exception&) {
        // A notification has no answer, and what is wrong with it is the client's.
    }
}

void Server::did_open(const json& parameters)
{
    const json& text = object_member(parameters, "textDocument");
    const std::string& uri = string_member(text, "uri");
    const std::string path = path_of_uri(uri);
    files_.open(path, string_member(text, "text"));
    open_[path] = {uri, text.value("version", json()), 0};
    changed(path);
}

void Server::did_change(const json& parameters)
{
    const json& document = object_member(parameters, "textDocument");
    const std::string path = path_of_uri(string_member(document, "uri"));
    if (!files_.is_open(path)) return;
    const json* const changes = find_member(parameters, {"contentChanges"});
    if (changes == nullptr || !changes->is_array()) return;
    std::string text = files_.text(path);
    for (const json& change : *changes) {
        const std::string& added = string_member(change, "text");
        if (!change.contains("range")) {
            text = added;
            continue;
        }
        const auto [begin, end] = Positions(text, world_.encoding).range(object_member(change, "range"));
        if (text.size() - (end - begin) + added.size() > Input::kLongest) return;
        text.replace(begin, end - begin, added);
    }
    files_.open(path, std::move(text));
    open_[path].version = document.value("version", json());
    changed(path);
}

void Server::did_close(const json& parameters)
{
    const std::string path = path_of_uri(string_member(object_member(parameters, "textDocument"), "uri"));
    if (open_.erase(path) == 0) return;
    files_.close(path);
    reader_.forget(path);
    values_.erase(path);
    replace_diagnostics(path, {});
    read_all();
}

/// Pages of `whittle watch` light up what stands there. Clients that say nothing of their cursor ask for the highlights
/// of a word there.
void Server::tell_cursor(const json& parameters)
{
    const Asked asked(world_, parameters);
    watch_.cursor(asked.path, asked.offset(world_, parameters));
}

void Server::changed(const std::string& path)
{
    auto texts = std::make_shared<Reader::Texts>();
    for (const auto& [open, text] : open_) texts->emplace(open, files_.text(open));
    std::set<std::string> reached_includes;
    for (auto& [scene, text] : open_) {
        if (is_include_file(scene)) continue;
        const std::vector<std::string> reached = files_.reached(scene);
        reached_includes.insert(reached.begin(), reached.end());
        if (path.empty() || std::find(reached.begin(), reached.end(), path) != reached.end())
            text.asked = reader_.ask(scene, texts);
    }
    for (const auto& [include, text] : open_) {
        if (!is_include_file(include)) continue;
        if (reached_includes.contains(include)) {
            if (told_.contains(include)) replace_diagnostics(include, {});
        } else if (const language::KnownPtr known = files_.find(include)) {
            replace_diagnostics(include, {{include, token_diagnostics(known->document, world_.encoding)}});
        }
    }
}

/// Something on disk changed, or what lay over it is gone.
void Server::read_all() { changed(""); }

void Server::take_reading(Reading&& reading)
{
    const std::lock_guard lock(mutex_);
    const auto open = open_.find(reading.scene);
    if (open == open_.end() || open->second.asked != reading.number || state_ != State::Running) return;
    replace_diagnostics(reading.scene, diagnostics_of(reading, files_, world_.encoding));
    if (reading.whole) values_[reading.scene] = std::move(reading.values);
}

void Server::replace_diagnostics(const std::string& scene, Diagnostics diagnostics)
{
    std::set<std::string> paths;
    for (const auto& [path, list] : told_[scene]) paths.insert(path);
    for (const auto& [path, list] : diagnostics) paths.insert(path);
    paths.insert(scene);  // an editor that waits for a text's diagnostics is told that there are none
    if (diagnostics.empty()) told_.erase(scene);
    else told_[scene] = std::move(diagnostics);
    for (const std::string& path : paths) publish(path);
}

void Server::publish(const std::string& path)
{
    json all = json::array();
    for (const auto& [scene, diagnostics] : told_)
        if (const auto found = diagnostics.find(path); found != diagnostics.end())
            for (const json& one : found->second)
                if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    json parameters = {{"uri", uri_of(path)}, {"diagnostics", std::move(all)}};
    const auto open = open_.find(path);
    if (open != open_.end() && open->second.version.is_number_integer()) parameters["version"] = open->second.version;
    send({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(parameters)}});
}

std::string Server::uri_of(const std::string& path) const
{
    const auto open = open_.find(path);
    return open != open_.end() ? open->second.uri : uri_of_path(path);
}

std::string Server::value_of(const std::string& path, const std::string& name)
{
    for (const auto& [scene, values] : values_) {
        const std::vector<std::string> reached = files_.reached(scene);
        if (std::find(reached.begin(), reached.end(), path) == reached.end()) continue;
        if (const auto found = values.find(name); found != values.end()) return found->second;
    }
    return {};
}

}  // namespace app::lsp
