#include "parser/stream/limits.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <utility>

namespace parser {

void TokenStream::define_macro(std::uint32_t hash)
{
    if (language_.version < 310) fail(last(), "macros need #version 3.1 or later");
    const std::uint32_t end = file().tokens[hash].jump;
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail_expected_at(name, "a name for the macro that is no reserved word");
    const Value* old = symbols_.find(name.name);
    if (old && old->set() && !old->get_if<std::shared_ptr<const Macro>>())
        fail(place(name), fmt::format("'{}' is already declared as {}", word(name), type_name(*old)));
    if (end == kNoIndex) fail(place(name), fmt::format("macro {} has no #end in its file", word(name)));

    auto macro = std::make_shared<Macro>();
    macro->name = name.name;
    macro->file = cursors_.back().file;
    if (Token open = raw_next(); open.kind != Kind::LeftParen) fail_expected_at(open, "'(' and the macro's parameters");
    for (Token token = raw_next(); token.kind != Kind::RightParen; token = raw_next()) {
        if (token.kind == Kind::Comma && !macro->parameters.empty()) continue;
        const bool optional = new_language() && token.kind == Kind::Identifier && word(token) == "optional" &&
                              peek_raw().kind == Kind::Identifier;
        if (optional) token = raw_next();
        if (token.kind != Kind::Identifier) fail_expected_at(token, "a parameter's name or ')'");
        macro->parameters.push_back(token.name);
        macro->optional.push_back(optional);
    }
    macro->begin = cursors_.back().position;
    macro->end = end;
    check_skipped(macro->begin, end);
    cursors_.back().position = end + 2;
    macros_.push_back(std::move(macro));
    *symbols_.global(name.name) = macros_.back();
}

void TokenStream::call_macro(const Token& name, const Macro& macro)
{
    const auto guard = nest();
    const bool raw = std::exchange(raw_operators_, false);
    const std::size_t first = arguments_.size();
    last_ = &name;
    if (!accept(Kind::LeftParen)) fail_expected(fmt::format("'(' after the name of macro {}", word(name)));
    for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
        if (macro.optional[i] && left_out()) {
            arguments_.emplace_back();
            accept_comma();
            continue;
        }
        if (Cell simple = argument_compiled()) {
            arguments_.push_back(std::move(simple));
            accept_comma();
            continue;
        }
        if (peek().kind == Kind::RightParen)
            fail_expected(fmt::format("argument '{}' of macro {}", names_.word(macro.parameters[i]), word(name)));
        Cell cell;
        Value value = read_value(&cell);
        if (!cell) cell = make_cell(std::move(value));
        arguments_.push_back(std::move(cell));
        accept_comma();
    }
    if (!accept(Kind::RightParen)) fail_expected(fmt::format("')' after the arguments of macro {}", word(name)));
    raw_operators_ = raw;
    enter_macro(name, macro, first);
}

/// Nothing stands here, or a name that means nothing: an optional parameter stays undeclared.
bool TokenStream::left_out()
{
    const Token& token = peek();
    if (token.kind == Kind::Comma || token.kind == Kind::RightParen) return true;
    const Cursor& cursor = cursors_.back();
    if (token.kind != Kind::Identifier || value_of(token) || cursor.position >= cursor.end) return false;
    const Kind behind = cursor.tokens[cursor.position].kind;
    if (behind != Kind::Comma && behind != Kind::RightParen) return false;
    next();
    return true;
}

void TokenStream::enter_macro(const Token& name, const Macro& macro, std::size_t first)
{
    if (cursors_.size() >= kDeepestCalls)
        fail(place(name), "macros call each other too deeply; does a recursion never end?");
    symbols_.open_scope();
    for (std::size_t i = 0; i < macro.parameters.size(); ++i)
        if (arguments_[first + i]) symbols_.bind(macro.parameters[i], std::move(arguments_[first + i]));
    arguments_.resize(first);
    Block marker;
    marker.kind = BlockKind::Macro;
    marker.repeats = true;
    marker.file = cursors_.back().file;
    marker.cursors = cursors_.size();
    Cursor& cursor = cursors_.emplace_back();
    cursor.file = macro.file;
    cursor.macro = true;
    cursor.name = macro.name;
    cursor.tokens = files_[macro.file]->tokens.data();
    cursor.position = macro.begin;
    cursor.end = macro.end;
    cursor.blocks = blocks_.size();
    cursor.call = &name;
    push_block(marker);
    ++statistics_.macro_calls;
}

}  // namespace parser
