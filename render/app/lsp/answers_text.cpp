#include "language/format/edit.h"
#include "language/places/colors.h"
#include "language/places/structure.h"
#include "render/app/lsp/asked.h"

#include <fmt/format.h>

#include <algorithm>

// Requests about a text as a whole: outline, folds, colours, layout.
namespace app::lsp {
namespace {

using language::Entry;

/// SymbolKind.
int number_of(Entry::Kind kind)
{
    switch (kind) {
    case Entry::Kind::Function: return 12;
    case Entry::Kind::Constant: return 14;
    case Entry::Kind::Object: return 19;
    default: return 13;
    }
}

json symbol(const Entry& entry, const Positions& positions)
{
    json out = {{"name", entry.name},
                {"kind", number_of(entry.kind)},
                {"range", positions.range(entry.whole)},
                {"selectionRange", positions.range(entry.word)}};
    if (!entry.detail.empty()) out["detail"] = entry.detail;
    for (const Entry& inner : entry.inner) out["children"].push_back(symbol(inner, positions));
    return out;
}

/// What `rgb` means in a text: its scene says so where it does not.
bool linear_light(World& world, const Asked& asked)
{
    if (language::linear_light(asked.document())) return true;
    for (const std::string& root : world.files.open_paths()) {
        if (root == asked.path) continue;
        const std::vector<std::string> reached = world.files.reached(root);
        if (std::find(reached.begin(), reached.end(), asked.path) == reached.end()) continue;
        if (const language::KnownPtr known = world.files.find(root); known && language::linear_light(known->document))
            return true;
    }
    return false;
}

double share(const json& color, const char* name)
{
    const json* const found = find_member(color, {name});
    if (found == nullptr || !found->is_number())
        throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' of the colour has to be a number", name));
    return std::clamp(found->get<double>(), 0.0, 1.0);
}

language::format::Options layout_of(const json& parameters)
{
    language::format::Options layout;
    if (const json* const size = find_member(parameters, {"options", "tabSize"}); size && size->is_number())
        layout.indent = static_cast<int>(std::clamp(size->get<double>(), 1.0, 16.0));
    if (const json* const blanks = find_member(parameters, {"options", "insertSpaces"}); blanks && blanks->is_boolean())
        layout.tabs = !blanks->get<bool>();
    return layout;
}

/// The edits that `make` asks for. What cannot be laid out is refused with its place.
template <class Make>
json edits(const Asked& asked, const Positions& positions, Make&& make)
{
    json out = json::array();
    try {
        if (const auto edit = make(std::string_view(asked.document().text())))
            out.push_back(
                {{"range", positions.range(language::Range{edit->begin, edit->end})}, {"newText", edit->text}});
    } catch (const language::format::Refused& refused) {
        throw Refusal(ErrorCode::RequestFailed,
                      fmt::format("line {}: {}", positions.line_of(refused.offset) + 1, refused.what()));
    }
    return out;
}

}  // namespace

json symbols(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const Positions positions = asked.positions(world);
    json out = json::array();
    for (const Entry& entry : language::entries_of(asked.document(), asked.known->outline))
        out.push_back(symbol(entry, positions));
    return out;
}

json folding(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    json out = json::array();
    for (const language::Fold& fold : language::folds_of(asked.document())) {
        json made = {{"startLine", fold.first - 1}, {"endLine", fold.last - 1}};
        if (fold.comment) made["kind"] = "comment";
        out.push_back(std::move(made));
    }
    return out;
}

json colors(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const Positions positions = asked.positions(world);
    json out = json::array();
    for (const language::Swatch& swatch : language::swatches_of(asked.document(), linear_light(world, asked))) {
        const auto [red, green, blue, alpha] = language::screen_color(swatch);
        out.push_back({{"range", positions.range(swatch.range)},
                       {"color", {{"red", red}, {"green", green}, {"blue", blue}, {"alpha", alpha}}}});
    }
    return out;
}

json color_presentation(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const Positions positions = asked.positions(world);
    const language::Range range = positions.range(object_member(parameters, "range"));
    const json& color = object_member(parameters, "color");
    const std::array<double, 4> wanted{share(color, "red"), share(color, "green"), share(color, "blue"),
                                       share(color, "alpha")};
    json out = json::array();
    for (const language::Swatch& swatch : language::swatches_of(asked.document(), linear_light(world, asked))) {
        if (!(swatch.range == range)) continue;
        const std::string text = language::color_text(swatch, wanted);
        out.push_back({{"label", text}, {"textEdit", {{"range", positions.range(range)}, {"newText", text}}}});
    }
    return out;
}

json formatting(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    return edits(asked, asked.positions(world),
                 [&](std::string_view text) { return language::format::layout_edit(text, layout_of(parameters)); });
}

json range_formatting(World& world, const json& parameters)
{
    const Asked asked(world, parameters);
    const Positions positions = asked.positions(world);
    const language::Range range = positions.range(object_member(parameters, "range"));
    return edits(asked, positions, [&](std::string_view text) {
        return language::format::layout_edit(text, range.begin, range.end, layout_of(parameters));
    });
}

}  // namespace app::lsp
