#include "render/app/lsp/diagnostics.h"

#include "render/app/lsp/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace app::lsp {
namespace {

using parser::Kind;

constexpr std::size_t kMostOfText = 200;

/// Of the protocol.
int number_of(scene::Severity severity)
{
    switch (severity) {
    case scene::Severity::Error: return 1;
    case scene::Severity::Warning: return 2;
    default: return 3;
    }
}

/// Texts, with their positions made once.
class Places {
public:
    Places(language::Files& files, Encoding encoding) : files_(files), encoding_(encoding) {}

    /// The word at a place, or the place alone; its path is made absolute.
    json range(const scene::Place& place, std::string& path)
    {
        path = language::normal_path(place.path);
        const language::KnownPtr known = files_.find(path);
        if (!known || place.at.line == 0) return empty();
        const language::Document& document = known->document;
        if (place.at.line > document.lines().lines()) return empty();
        const auto size = static_cast<std::uint32_t>(document.text().size());
        const std::uint32_t offset = std::min(document.lines().start(place.at.line) + place.at.column - 1, size);
        auto found = positions_.find(path);
        if (found == positions_.end()) found = positions_.emplace(path, Positions(document.text(), encoding_)).first;
        kept_.push_back(known);  // the positions look into its text
        const std::size_t token = document.before(offset + 1);
        language::Range range{offset, offset};
        if (token != language::kNone && document.range(token).begin == offset) range = document.range(token);
        return found->second.range(range);
    }

private:
    static json empty()
    {
        const json start = {{"line", 0}, {"character", 0}};
        return {{"start", start}, {"end", start}};
    }
    language::Files& files_;
    Encoding encoding_;
    std::map<std::string, Positions> positions_;
    std::vector<language::KnownPtr> kept_;
};

json related(Places& places, const scene::Place& place, const std::string& text)
{
    std::string path;
    json range = places.range(place, path);
    return {{"location", {{"uri", uri_of_path(path)}, {"range", std::move(range)}}}, {"message", text}};
}

json diagnostic(json range, int severity, const std::string& text)
{
    return {{"range", std::move(range)}, {"severity", severity}, {"source", "whittle"}, {"message", text}};
}

}  // namespace

Diagnostics diagnostics_of(const Reading& reading, language::Files& files, Encoding encoding)
{
    Diagnostics out;
    Places places(files, encoding);
    for (const Told& told : reading.told) {
        const scene::Message& message = told.message;
        if (message.severity == scene::Severity::Debug) continue;
        scene::Place place = message.place;
        if (place.path.empty()) place = {reading.scene, {1, 1}};
        std::string path;
        json range = places.range(place, path);
        if (out[path].size() >= kMostOfText) continue;
        std::string text = message.text;
        if (const std::string name = fmt::format(" [{}]", told.check); !told.check.empty() && text.ends_with(name))
            text.resize(text.size() - name.size());  // it has a member of its own
        json made = diagnostic(std::move(range), number_of(message.severity), text);
        if (!told.check.empty()) made["code"] = told.check;
        json others = json::array();
        if (message.opened) others.push_back(related(places, *message.opened, "opened here"));
        for (const scene::RelatedPlace& one : message.related) others.push_back(related(places, one.place, one.text));
        if (!others.empty()) made["relatedInformation"] = std::move(others);
        out[path].push_back(std::move(made));
        // A mistake in an include file would not be seen in the scene that is being written.
        if (path != reading.scene && message.severity == scene::Severity::Error && !message.related.empty()) {
            std::string root;
            json at = places.range(message.related.back().place, root);
            if (root != reading.scene) continue;
            json here = diagnostic(std::move(at), number_of(message.severity), "leads to: " + text);
            here["relatedInformation"] = json::array({related(places, message.place, text)});
            out[root].push_back(std::move(here));
        }
    }
    return out;
}

std::vector<json> token_diagnostics(const language::Document& document, Encoding encoding)
{
    const Positions positions(document.text(), encoding);
    std::vector<json> out;
    const auto add = [&](std::size_t token, const std::string& text) {
        if (out.size() < kMostOfText)
            out.push_back(diagnostic(positions.range(document.range(token)), number_of(scene::Severity::Error), text));
    };
    // Branches may each open what is closed once behind them: only a text without any is sure.
    const bool branches = std::any_of(
        document.tokens().begin(), document.tokens().end(),
        [](const parser::Token& token) { return token.kind == Kind::Hash && token.jump != parser::kNoIndex; });
    for (std::size_t at = 0; at < document.tokens().size(); ++at) {
        const Kind kind = document.kind(at);
        const bool bracket = kind == Kind::LeftBrace || kind == Kind::RightBrace || kind == Kind::LeftParen ||
                             kind == Kind::RightParen || kind == Kind::LeftSquare || kind == Kind::RightSquare;
        if (kind == Kind::Bad) add(at, std::string(document.complaint(at)));
        if (bracket && document.partner(at) == language::kNone && !branches)
            add(at, fmt::format("this '{}' has no partner", parser::spelling(kind)));
    }
    return out;
}

}  // namespace app::lsp
