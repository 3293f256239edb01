#pragma once

#include "parser/stream/token_stream.h"

#include <string>

namespace parser_test {

/// A grammar that knows no scene: enough to drive directives and expressions.
struct NoGrammar : parser::GrammarHooks {
    std::optional<parser::Value> parse_declared_value(parser::TokenStream&) override { return std::nullopt; }
    void parse_default(parser::TokenStream& stream) override { stream.expect(parser::Kind::LeftBrace, "'{'"); }
};

/// What #debug prints until the text ends.
inline std::string debug_of(const std::string& text, const parser::Options& options = {})
{
    NoGrammar grammar;
    parser::TokenStream stream(options, grammar);
    stream.open_text(text, "test.pov");
    while (stream.peek().kind != parser::Kind::EndOfText) stream.next();
    std::string all;
    for (const parser::Message& message : stream.messages())
        if (message.severity == parser::Severity::Debug) all += message.text;
    return all;
}

/// The plain tokens that come out, as words with blanks between them.
inline std::string plain(const std::string& text)
{
    NoGrammar grammar;
    parser::TokenStream stream({}, grammar);
    stream.open_text(text, "test.pov");
    std::string all;
    while (stream.peek().kind != parser::Kind::EndOfText) {
        const parser::Token token = stream.next();
        if (!all.empty()) all += ' ';
        if (token.kind == parser::Kind::Number) all += std::to_string(static_cast<int>(token.number));
        else if (token.kind == parser::Kind::Identifier) all += stream.word(token);
        else all += parser::spelling(token.kind);
    }
    return all;
}

inline std::string error_of(const std::string& text)
{
    try {
        plain(text);
    } catch (const parser::Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace parser_test
