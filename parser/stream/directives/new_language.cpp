#include "parser/stream/expression.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <utility>

/// What version 3.8 adds and that is no container.
namespace parser {

const Token& TokenStream::new_word(const Token& token) const
{
    const bool left_out = options_.povray == scene::PovRay::V37 && names_.new_word(token.name) != Kind::Steps;
    return left_out || value_of(token) ? token : files_[token.file]->new_words[token.jump];
}

/// Of a name that would be a word of 3.8, or nothing.
std::string TokenStream::why_no_word(const Token& token) const
{
    if (token.kind != Kind::Identifier || token.jump == kNoIndex) return {};
    return fmt::format("; '{}' is a word of POV-Ray 3.8, and --povray=3.7 asks for the language before it", word(token));
}

const Value* TokenStream::member_ahead()
{
    const Value* value = value_of(peek());
    const Cursor& cursor = cursors_.back();
    std::uint32_t at = cursor.position;
    const auto kind = [&](std::uint32_t i) { return i < cursor.end ? cursor.tokens[i].kind : Kind::EndOfText; };
    while (value) {
        const auto* dictionary = value->get_if<std::shared_ptr<Dictionary>>();
        if (!dictionary) break;
        std::string key;
        if (kind(at) == Kind::Period) {
            key = word(cursor.tokens[at + 1]);
            at += 2;
        } else if (kind(at) == Kind::LeftSquare && kind(at + 1) == Kind::String) {
            key = files_[cursor.file]->strings[cursor.tokens[at + 1].name];
            at += 3;
        } else {
            break;
        }
        const auto found = (*dictionary)->members.find(key);
        value = found == (*dictionary)->members.end() ? nullptr : found->second.get();
    }
    return value;
}

Kind TokenStream::at_pseudo_scope()
{
    const Kind scope = as_word(peek_raw()).kind;
    if (scope != Kind::Local && scope != Kind::Global) return Kind::EndOfText;
    const Cursor& cursor = cursors_.back();
    if (cursor.position >= cursor.end || cursor.tokens[cursor.position].kind != Kind::Period) return Kind::EndOfText;
    return scope;
}

/// `local.X`, `global.X`: what X means in the innermost or the outermost scope alone. Null: nothing.
Cell TokenStream::read_pseudo_cell(Token& name)
{
    const bool global = raw_next().kind != Kind::Local;
    raw_next();
    name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "a name behind the scope");
    return global                                 ? symbols_.find_global(name.name)
           : symbols_.in_current_scope(name.name) ? symbols_.find_cell(name.name)
                                                  : nullptr;
}

Value TokenStream::read_pseudo_value()
{
    Token name;
    Cell cell = read_pseudo_cell(name);
    if (!cell) fail(place(name), fmt::format("'{}' is not declared in this scope", word(name)));
    if (is_container(*cell)) cell = subscripted(cell, name, false);
    if (const Tuple* tuple = cell->get_if<Tuple>()) return continue_sum(*this, *tuple, 1);
    return deep_copy(*cell);
}

/// `#declare (A, B) = (1, 2);` and `#declare { A, , B } = Array;`. All values are read before the first is stored.
void TokenStream::declare_several(bool local)
{
    const std::uint32_t scope = symbols_.depth();
    const bool from_array = raw_next().kind == Kind::LeftBrace;
    const Kind closing = from_array ? Kind::RightBrace : Kind::RightParen;
    struct Place {
        bool wanted = false, optional = false;
        DeclarationTarget target;
    };
    std::vector<Place> places;
    for (;;) {
        Place one;
        if (as_word(peek_raw()).kind == Kind::Optional) raw_next(), one.optional = true;
        one.wanted = peek_raw().kind != Kind::Comma && peek_raw().kind != closing;
        if (one.wanted) one.target = read_declaration_target();
        places.push_back(std::move(one));
        if (peek_raw().kind != Kind::Comma) break;
        raw_next();
    }
    if (Token close = raw_next(); close.kind != closing)
        fail_expected_at(close, fmt::format("',' or '{}'", spelling(closing)));
    if (Token equal = raw_next(); equal.kind != Kind::Equal) fail_expected_at(equal, "'=' and the values");

    std::vector<Value> values(places.size());
    if (from_array) {
        const Value read = read_value();
        const auto* array = read.get_if<std::shared_ptr<Array>>();
        if (!array || (*array)->sizes.size() != 1) fail(last(), "expected an array of one dimension");
        for (std::size_t i = 0; i < values.size() && i < (*array)->elements.size(); ++i)
            values[i] = (*array)->elements[i];
    } else {
        expect(Kind::LeftParen, "'(' and the values");
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (i > 0) expect(Kind::Comma, "',' and the next value");
            if (peek().kind != Kind::Comma && peek().kind != Kind::RightParen) values[i] = read_value();
        }
        expect(Kind::RightParen, fmt::format("')' after {} values", places.size()));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i].wanted || (!values[i].set() && places[i].optional)) continue;
        if (!values[i].set()) fail(last(), fmt::format("there is no value for '{}'", word(places[i].target.name)));
        store(places[i].target, std::move(values[i]), local, scope);
    }
    end_declaration(true);
}

}  // namespace parser
