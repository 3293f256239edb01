#include "parser/stream/expression.h"
#include "parser/stream/token_stream.h"
#include "parser/stream/values/elements.h"

#include <fmt/format.h>

#include <utility>

/// What version 3.8 adds and that is no container.
namespace parser {

const Token& TokenStream::new_word(const Token& token) const
{
    const Kind meant = names_.new_word(token.name);
    const bool of_38 = meant != Kind::Steps && meant != Kind::File;  // 3.7 has the one, Whittle alone the other
    const bool left_out = options_.povray == scene::PovRay::V37 && of_38;
    return left_out || value_of(token) ? token : files_[token.file]->new_words[token.jump];
}

/// Of a name that would be a word of 3.8, or nothing.
std::string TokenStream::why_no_word(const Token& token) const
{
    if (token.kind != Kind::Identifier || token.jump == kNoIndex) return {};
    return fmt::format("; '{}' is a word of POV-Ray 3.8, and --povray=3.7 asks for the language before it",
                       word(token));
}

/// Reads the tokens from `at` + 1 to the bracket that closes the one at `at`, behind which `at` stands then. What that
/// draws of random numbers is given back, for the same text is read again where it counts. False: it is not closed.
template <class Read>
bool TokenStream::look_into_brackets(const Cursor& in, std::uint32_t& at, Read&& read)
{
    std::uint32_t close = at + 1;
    for (int open = 1; close < in.end; ++close) {
        open += in.tokens[close].kind == Kind::LeftSquare;
        open -= in.tokens[close].kind == Kind::RightSquare;
        if (open == 0) break;
    }
    if (close >= in.end) return false;
    const std::vector<std::uint32_t> drawn = random_streams_;
    read_again(&in.tokens[at + 1], &in.tokens[close] + 1, read);
    random_streams_ = drawn;
    at = close + 1;
    return true;
}

/// `.Key` or `["Key"]` among the tokens that are not taken; `at` then stands behind it.
std::optional<std::string> TokenStream::key_ahead(const Cursor& in, std::uint32_t& at)
{
    if (at + 1 >= in.end) return std::nullopt;
    if (in.tokens[at].kind == Kind::Period) {
        if (in.tokens[at + 1].name == kNoIndex) return std::nullopt;  // no word: read_key() says so
        at += 2;
        return word(in.tokens[at - 1]);
    }
    std::string key;
    if (in.tokens[at].kind != Kind::LeftSquare || !look_into_brackets(in, at, [&] { key = string_expr(*this); }))
        return std::nullopt;
    return key;
}

/// The element of a mixed array among such tokens; null: none is named. Elements of others are all alike.
const Value* TokenStream::element_ahead(const Array& array, const Cursor& in, std::uint32_t& at)
{
    std::size_t index = 0;
    for (const std::uint32_t size : array.sizes) {
        double subscript = -1.0;
        if (at >= in.end || in.tokens[at].kind != Kind::LeftSquare) return nullptr;
        if (!look_into_brackets(in, at, [&] { subscript = float_expr(*this) + kSubscriptSlack; })) return nullptr;
        if (!(subscript >= 0.0 && subscript < size)) return nullptr;
        index = index * size + static_cast<std::size_t>(subscript);
    }
    return &array.elements[index];
}

const Value* TokenStream::named_ahead()
{
    const Token& token = peek();
    const Kind scope = at_pseudo_scope();
    const Value* value = scope == Kind::EndOfText && token.kind == Kind::Identifier ? value_of(token) : nullptr;
    if (scope == Kind::EndOfText && (!value || !is_container(*value))) return value;
    const Cursor in = cursors_.back();
    std::uint32_t at = in.position;
    if (scope != Kind::EndOfText)
        if (const auto key = key_ahead(in, at)) value = in_scope(scope, names_.intern(*key)).get();
    while (value) {
        if (const auto* dictionary = value->get_if<std::shared_ptr<Dictionary>>()) {
            if (at >= in.end || (in.tokens[at].kind != Kind::Period && in.tokens[at].kind != Kind::LeftSquare)) break;
            const auto key = key_ahead(in, at);
            const auto found = key ? (*dictionary)->members.find(*key) : (*dictionary)->members.end();
            value = found == (*dictionary)->members.end() ? nullptr : found->second.get();
        } else if (const auto* array = value->get_if<std::shared_ptr<Array>>(); array && (*array)->mixed) {
            if (at >= in.end || in.tokens[at].kind != Kind::LeftSquare) break;
            value = element_ahead(**array, in, at);
        } else {
            break;
        }
    }
    return value;
}

Kind TokenStream::at_pseudo_scope()
{
    const Kind scope = as_word(peek_raw()).kind;
    if (scope != Kind::Local && scope != Kind::Global) return Kind::EndOfText;
    const Cursor& cursor = cursors_.back();
    if (cursor.position >= cursor.end) return Kind::EndOfText;
    const Kind behind = cursor.tokens[cursor.position].kind;
    return behind == Kind::Period || behind == Kind::LeftSquare ? scope : Kind::EndOfText;
}

/// What a name means in the innermost or the outermost scope alone. Null: nothing.
Cell TokenStream::in_scope(Kind scope, std::uint32_t name) const
{
    if (scope == Kind::Global) return symbols_.find_global(name);
    return symbols_.in_current_scope(name) ? symbols_.find_cell(name) : nullptr;
}

/// `local.X`, `global["X"]`: takes it; the scope and the name.
Kind TokenStream::read_pseudo_name(Token& name)
{
    const Token scope = as_word(raw_next());
    const bool bracket = peek_raw().kind == Kind::LeftSquare;
    const std::string key = read_key();
    name = bracket ? scope : *last_;
    name.kind = Kind::Identifier;
    name.name = names_.intern(key);
    return scope.kind;
}

Cell TokenStream::take_name(Token& name)
{
    if (at_pseudo_scope() != Kind::EndOfText) {
        const Kind scope = read_pseudo_name(name);
        Cell cell = in_scope(scope, name.name);
        if (!cell) fail(place(name), fmt::format("'{}' is not declared in this scope", word(name)));
        return cell;
    }
    name = next();
    return name.kind == Kind::Identifier ? symbols_.find_cell(name.name) : nullptr;
}

/// `#declare (A, B) = (1, 2);` and `#declare { A, , B } = Array;`. A value between parentheses is stored before the
/// next is read, so that `(A, B) = (B, A)` gives both the value of B.
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

    const auto keep = [&](const Place& to, Value value) {
        if (!to.wanted || (!value.set() && to.optional)) return;
        if (!value.set()) fail(last(), fmt::format("there is no value for '{}'", word(to.target.name)));
        store(to.target, std::move(value), local, scope);
    };
    if (from_array) {
        const Value read = read_value();
        const auto* array = read.get_if<std::shared_ptr<Array>>();
        if (!array || (*array)->sizes.size() != 1) fail(last(), "expected an array of one dimension");
        for (std::size_t i = 0; i < places.size(); ++i)
            keep(places[i], i < (*array)->elements.size() ? (*array)->elements[i] : Value());
    } else {
        expect(Kind::LeftParen, "'(' and the values");
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (i > 0) expect(Kind::Comma, "',' and the next value");
            const bool given = peek().kind != Kind::Comma && peek().kind != Kind::RightParen;
            keep(places[i], given ? read_value() : Value());
        }
        expect(Kind::RightParen, fmt::format("')' after {} values", places.size()));
    }
    end_declaration(false);
}

}  // namespace parser
