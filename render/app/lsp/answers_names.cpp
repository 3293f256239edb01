#include "language/places/completion.h"
#include "language/places/hover.h"
#include "render/app/lsp/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

// Requests about names: completion, hover, definition, references, rename.
namespace app::lsp {
namespace {

using language::At;
using language::ItemKind;

/// CompletionItemKind.
int number_of(ItemKind kind)
{
    switch (kind) {
    case ItemKind::Function:
    case ItemKind::Macro: return 3;
    case ItemKind::Constant: return 21;
    case ItemKind::Variable:
    case ItemKind::Parameter: return 6;
    case ItemKind::File: return 17;
    case ItemKind::Folder: return 19;
    default: return 14;
    }
}

/// Ranges of several texts, positions made once for each.
json locations(World& world, const std::vector<At>& places)
{
    json out = json::array();
    std::string path;
    language::KnownPtr known;
    std::optional<Positions> positions;
    for (const At& place : places) {
        if (place.path != path || !positions) {
            path = place.path;
            known = world.files.find(path);
            if (!known) continue;
            positions.emplace(known->document.text(), world.encoding);
        }
        out.push_back({{"uri", world.uri_of(path)}, {"range", positions->range(place.range)}});
    }
    return out;
}

/// The file that the text behind #include names, where the byte stands in it.
std::string included_at(World& world, const Asked& asked, std::uint32_t offset)
{
    for (const std::size_t name : asked.known->outline.includes) {
        const language::Range range = asked.document().range(name);
        if (offset < range.begin || offset > range.end) continue;
        const std::string word(asked.document().string(name));
        std::string found = world.files.included(word, asked.path, asked.path);
        for (const std::string& root : world.files.open_paths()) {
            if (!found.empty()) break;
            const std::vector<std::string> reached = world.files.reached(root);
            if (std::find(reached.begin(), reached.end(), asked.path) != reached.end())
                found = world.files.included(word, asked.path, root);
        }
        return found;
    }
    return {};
}

bool in_workspace(const World& world, const std::string& path)
{
    if (world.files.is_open(path)) return true;
    return std::any_of(world.folders.begin(), world.folders.end(), [&](const std::string& folder) {
        return path.starts_with(folder) && (folder.ends_with('/') || path.substr(folder.size()).starts_with('/'));
    });
}

/// The places of a name that may be renamed; throws Refusal with the reason where it may not.
std::vector<At> renamed_places(World& world, const Asked& asked, std::uint32_t offset, language::Symbol& symbol)
{
    const std::size_t token = asked.document().word_at(offset);
    if (token == language::kNone) throw Refusal(ErrorCode::RequestFailed, "no name stands here");
    if (parser::is_keyword(asked.document().kind(token)))
        throw Refusal(ErrorCode::RequestFailed, fmt::format("'{}' is a reserved word", asked.document().word(token)));
    if (asked.document().is_member(token))
        throw Refusal(ErrorCode::RequestFailed, "members of dictionaries cannot be renamed");
    symbol = language::symbol_of(*asked.known, token);
    const std::vector<At> declared = language::declarations_of(world.files, symbol);
    if (declared.empty()) throw Refusal(ErrorCode::RequestFailed, fmt::format("'{}' is declared nowhere", symbol.word));
    std::vector<At> places = language::places_of(world.files, symbol);
    for (const At& place : places)
        if (!in_workspace(world, place.path))
            throw Refusal(ErrorCode::RequestFailed,
                          fmt::format("'{}' stands in {}, which is outside of the workspace", symbol.word, place.path));
    return places;
}

void check_new_name(World& world, const Asked& asked, const language::Symbol& symbol, const std::string& name)
{
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const bool word = !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
        return letter(c) || (c >= '0' && c <= '9');
    });
    if (!word) throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' is no name", name));
    if (parser::keyword_of(name) != parser::Kind::Identifier)
        throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' is a reserved word", name));
    // Where the name is used already, in any way, two things would become one.
    language::Symbol taken = symbol;
    taken.word = name;
    taken.scope = language::kNone;
    taken.reach = symbol.reach == language::Symbol::Reach::Scope ? language::Symbol::Reach::Text : symbol.reach;
    bool used = !language::declarations_of(world.files, taken).empty();
    for (std::size_t at = 0; at < asked.document().tokens().size() && !used; ++at)
        used = asked.document().kind(at) == parser::Kind::Identifier && asked.document().word(at) == name;
    if (used) throw Refusal(ErrorCode::RequestFailed, fmt::format("'{}' has a meaning already", name));
}

}  // namespace

json completion(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const std::uint32_t offset = asked.offset(world, parameters);
    const language::Completion found = language::completion_at(world.files, asked.path, offset);
    const json replaced = asked.positions(world).range(found.replaced);
    json items = json::array();
    for (const language::Item& item : found.items) {
        json made = {{"label", item.word},
                     {"kind", number_of(item.kind)},
                     {"sortText", fmt::format("{}{}", item.rank, item.word)}};
        if (!item.detail.empty()) made["detail"] = item.detail;
        const bool file = item.kind == ItemKind::File || item.kind == ItemKind::Folder;
        if (file) made["textEdit"] = {{"range", replaced}, {"newText", item.word}};
        items.push_back(std::move(made));
    }
    return {{"isIncomplete", !found.complete}, {"items", std::move(items)}};
}

json hover(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const auto value_of = [&](const std::string& name) { return world.value_of(asked.path, name); };
    const auto found = language::hover_at(world.files, asked.path, asked.offset(world, parameters), value_of);
    if (!found) return nullptr;
    std::string text = found->sentence;
    if (!found->code.empty()) text += fmt::format("```pov\n{}\n```\n", found->code);
    if (!found->value.empty()) text += fmt::format("`{}` when the scene was read\n", found->value);
    if (!found->where.empty()) text += fmt::format("\ndeclared {}{}\n", found->code.empty() ? "" : "in ", found->where);
    return {{"contents", {{"kind", "markdown"}, {"value", text}}},
            {"range", asked.positions(world).range(found->word)}};
}

json definition(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const std::uint32_t offset = asked.offset(world, parameters);
    if (const std::string file = included_at(world, asked, offset); !file.empty())
        return locations(world, {{file, {0, 0}}});
    const auto symbol = language::symbol_at(*asked.known, offset);
    if (!symbol) return nullptr;
    const auto found = language::declaration_of(world.files, *symbol, offset);
    return found ? locations(world, {found->at()}) : json(nullptr);
}

json references(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const auto symbol = language::symbol_at(*asked.known, asked.offset(world, parameters));
    if (!symbol) return nullptr;
    std::vector<At> places = language::places_of(world.files, *symbol);
    const json* const declared = find_member(parameters, {"context", "includeDeclaration"});
    if (declared != nullptr && declared->is_boolean() && !declared->get<bool>()) {
        const std::vector<At> declarations = language::declarations_of(world.files, *symbol);
        std::erase_if(places, [&](const At& place) {
            return std::find(declarations.begin(), declarations.end(), place) != declarations.end();
        });
    }
    return locations(world, places);
}

json highlights(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const auto symbol = language::symbol_at(*asked.known, asked.offset(world, parameters));
    if (!symbol) return nullptr;
    const Positions positions = asked.positions(world);
    json out = json::array();
    for (const At& place : language::places_of(world.files, *symbol))
        if (place.path == asked.path) out.push_back({{"range", positions.range(place.range)}, {"kind", 1}});
    return out;
}

json prepare_rename(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const std::uint32_t offset = asked.offset(world, parameters);
    language::Symbol symbol;
    renamed_places(world, asked, offset, symbol);
    const std::size_t token = asked.document().word_at(offset);
    return {{"range", asked.positions(world).range(asked.document().range(token))}, {"placeholder", symbol.word}};
}

json rename(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const std::string& name = string_member(parameters, "newName");
    language::Symbol symbol;
    const std::vector<At> places = renamed_places(world, asked, asked.offset(world, parameters), symbol);
    if (name != symbol.word) check_new_name(world, asked, symbol, name);
    json changes = json::object();
    for (json& location : locations(world, places)) {
        const std::string uri = location["uri"];
        changes[uri].push_back({{"range", std::move(location["range"])}, {"newText", name}});
    }
    return {{"changes", std::move(changes)}};
}

}  // namespace app::lsp
