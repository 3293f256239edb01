#include "render/app/lsp/watch_link.h"

namespace app::lsp {
namespace {

bool says_yes(const json* member) { return member != nullptr && member->is_boolean() && member->get<bool>(); }

}  // namespace

WatchLink::WatchLink(World& world, std::mutex& mutex, std::function<void(const json&)> send)
    : world_(world), mutex_(mutex), send_(std::move(send)),
      mailbox_("lsp", [this](const std::string& text, const std::string& from) { take(text, from); })
{}

void WatchLink::set_client(const json& parameters)
{
    shows_ = says_yes(find_member(parameters, {"capabilities", "window", "showDocument", "support"}));
    edits_ = says_yes(find_member(parameters, {"capabilities", "workspace", "applyEdit"}));
}

void WatchLink::cursor(const std::string& path, std::uint32_t offset) const
{
    const language::KnownPtr known = world_.files.find(path);
    if (!known) return;
    const std::string& text = known->document.text();
    mailbox_.tell("watch", text_of({{"cursor", {{"file", path}, {"offset", offset}, {"mark", mark_of(text)}}}}));
}

void WatchLink::take(const std::string& text, const std::string& from)
{
    try {
        const json message = guarded_json(text);
        const std::lock_guard lock(mutex_);
        if (const json* const wanted = find_member(message, {"show"}); wanted != nullptr && show(*wanted))
            mailbox_.answer(from, text_of({{"shown", *wanted}}));
        if (const json* const wanted = find_member(message, {"edit"}); wanted != nullptr && edit(*wanted))
            mailbox_.answer(from, text_of({{"written", *wanted}}));
    } catch (const std::exception&) {
        // Nobody waits for an answer to what is no message.
    }
}

/// Whether a client is asked about a file: one that it has open, or one of its workspace's.
bool WatchLink::concerns(const std::string& path) const
{
    if (world_.files.is_open(path)) return true;
    for (const std::string& folder : world_.folders)
        if (path.starts_with(folder) &&
            (folder.ends_with("/") || path[std::min(folder.size(), path.size() - 1)] == '/'))
            return true;
    return false;
}

bool WatchLink::show(const json& wanted)
{
    const std::string path = string_member(wanted, "file");
    if (!shows_ || path.empty() || !concerns(path)) return false;
    const language::KnownPtr known = world_.files.find(path);
    if (!known) return false;
    const Positions positions(known->document.text(), world_.encoding);
    const std::uint64_t line = count_member(wanted, "line"), column = count_member(wanted, "column");
    if (line == 0 || line > positions.lines()) return false;
    const language::Range whole = positions.line(static_cast<std::size_t>(line - 1));
    const auto at =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(whole.begin + (column > 0 ? column - 1 : 0), whole.end));
    const std::size_t word = known->document.word_at(at);
    const language::Range selected = word != language::kNone && known->document.range(word).begin == at
                                         ? known->document.range(word)
                                         : language::Range{at, at};
    ask("window/showDocument",
        {{"uri", world_.uri_of(path)}, {"takeFocus", true}, {"selection", positions.range(selected)}});
    return true;
}

/// Of a text that the editor has open, and that is the one which the page knows.
bool WatchLink::edit(const json& wanted)
{
    const std::string path = string_member(wanted, "file");
    const json* const changes = find_member(wanted, {"changes"});
    if (!edits_ || !world_.files.is_open(path) || changes == nullptr || !changes->is_array()) return false;
    const std::string& old = world_.files.text(path);
    if (mark_of(old) != wanted.at("mark").get<std::uint64_t>()) return false;
    const Positions positions(old, world_.encoding);
    json edits = json::array();
    for (const json& change : *changes) {
        const std::uint64_t offset = count_member(change, "offset"), length = count_member(change, "length");
        if (offset > old.size() || length > old.size() - offset) return false;
        const language::Range range{static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(offset + length)};
        edits.push_back({{"range", positions.range(range)}, {"newText", string_member(change, "text")}});
    }
    ask("workspace/applyEdit",
        {{"label", "numbers of whittle watch"}, {"edit", {{"changes", {{world_.uri_of(path), std::move(edits)}}}}}});
    return true;
}

void WatchLink::ask(const char* method, json parameters)
{
    send_({{"jsonrpc", "2.0"},
           {"id", "whittle-" + std::to_string(++asked_)},
           {"method", method},
           {"params", std::move(parameters)}});
}

}  // namespace app::lsp
