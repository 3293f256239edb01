#include "render/lint/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace lint {
namespace {

using parser::Kind;
using parser::Token;

/// The name that a directive declares, its Hash being the token `at`; null: it declares none.
const Token* declared_at(const std::vector<Token>& tokens, std::size_t at, Kind& word)
{
    if (tokens[at].kind != Kind::Hash || at + 2 >= tokens.size()) return nullptr;
    word = tokens[at + 1].kind;
    if (word != Kind::Declare && word != Kind::Local && word != Kind::Macro && word != Kind::Undef) return nullptr;
    return tokens[at + 2].kind == Kind::Identifier ? &tokens[at + 2] : nullptr;
}

/// Words that a text uses other than to declare them.
void add_uses(const parser::SourceFile& file, std::unordered_set<std::uint32_t>& used)
{
    Kind word{};
    for (std::size_t at = 0; at < file.tokens.size(); ++at) {
        if (declared_at(file.tokens, at, word)) at += 2;
        else if (file.tokens[at].kind == Kind::Identifier) used.insert(file.tokens[at].name);
    }
}

/// A text may be run by Parse_String() and the like.
bool stands_in_string(const parser::SourceFile& file, const std::string& word)
{
    return std::any_of(file.strings.begin(), file.strings.end(),
                       [&](const std::string& s) { return s.find(word) != std::string::npos; });
}

}  // namespace

void check_names(Findings& out, const std::string& path, const std::vector<std::string>& others)
{
    const parser::SourceFile* file = out.texts().file(path);
    if (!file || path.ends_with(".inc")) return;  // an include file declares for others
    bool version = false;
    for (std::size_t at = 0; at + 1 < file->tokens.size(); ++at)
        version = version || file->tokens[at + 1].kind == Kind::Version;
    if (!version && file->tokens.size() > 1)
        out.add(
            "no-version", path, file->tokens.front().offset,
            "the scene has no #version: colours and gamma are those of POV-Ray 3.6 (#version 3.7; asks for today's)");
    if (!out.wants("unused-name")) return;
    std::unordered_set<std::uint32_t> used;
    add_uses(*file, used);
    for (const std::string& other : others)
        if (const parser::SourceFile* included = out.texts().file(other)) add_uses(*included, used);
    std::unordered_set<std::uint32_t> told;
    Kind word{};
    for (std::size_t at = 0; at < file->tokens.size(); ++at) {
        const Token* name = declared_at(file->tokens, at, word);
        if (!name || word == Kind::Undef || used.contains(name->name) || !told.insert(name->name).second) continue;
        const std::string& text = out.texts().names().word(name->name);
        if (stands_in_string(*file, text)) continue;
        out.add("unused-name", path, name->offset,
                fmt::format("{} '{}' is never used", word == Kind::Macro ? "the macro" : "the name", text));
    }
}

}  // namespace lint
