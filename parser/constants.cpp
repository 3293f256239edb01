#include "parser/constants.h"

#include "parser/lexer/lexer.h"
#include "render/files/whole_file.h"

#include <algorithm>

namespace parser {
namespace {

constexpr std::size_t kLongestText = 4'000'000;  // bytes

/// The number behind `#declare NAME =`, if that is all there is.
/// \param at  of the sign that ends the name
std::optional<double> number_behind(const std::vector<Token>& tokens, std::size_t at)
{
    if (at + 2 >= tokens.size() || tokens[at].kind != Kind::Equal) return {};
    const bool minus = tokens[at + 1].kind == Kind::Minus;
    const std::size_t number = at + (minus ? 2 : 1);
    if (number + 1 >= tokens.size() || tokens[number].kind != Kind::Number) return {};
    const Kind behind = tokens[number + 1].kind;
    if (behind != Kind::Semicolon && behind != Kind::Hash && behind != Kind::EndOfText) return {};
    return minus ? -tokens[number].number : tokens[number].number;
}

}  // namespace

std::vector<SceneConstant> constants_of(const std::string& path)
{
    SourceFile file;
    file.path = path;
    file.text = files::whole_file_if(path).value_or(std::string());
    if (file.text.size() > kLongestText) return {};
    Names names;
    tokenize(file, 0, names, true, false);
    const auto& tokens = file.tokens;
    std::vector<SceneConstant> found;
    const auto named = [&](const std::string& name) {
        return std::find_if(found.begin(), found.end(), [&](const SceneConstant& c) { return c.name == name; });
    };
    for (std::size_t i = 0; i + 4 < tokens.size(); ++i) {
        if (tokens[i].kind != Kind::Hash) continue;
        const Kind word = tokens[i + 1].kind;
        if ((word == Kind::Ifdef || word == Kind::Ifndef) && tokens[i + 2].kind == Kind::LeftParen &&
            tokens[i + 3].kind == Kind::Identifier && named(names.word(tokens[i + 3].name)) == found.end())
            found.push_back({names.word(tokens[i + 3].name), {}});
        if (word != Kind::Declare || tokens[i + 2].kind != Kind::Identifier) continue;
        const auto known = named(names.word(tokens[i + 2].name));
        if (known != found.end() && !known->value) known->value = number_behind(tokens, i + 3);
    }
    return found;
}

}  // namespace parser
