#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <utility>

namespace parser {
namespace {

/// Far more than POV-Ray's 98; reached only by a recursion without end.
constexpr std::size_t kDeepestCalls = 2000;

}  // namespace

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
        if (token.kind != Kind::Identifier) fail_expected_at(token, "a parameter's name or ')'");
        macro->parameters.push_back(token.name);
    }
    macro->begin = cursors_.back().position;
    macro->end = end;
    check_skipped(macro->begin, end);
    cursors_.back().position = end + 2;
    *symbols_.global(name.name) = std::shared_ptr<const Macro>(std::move(macro));
}

void TokenStream::call_macro(const Token& name, const std::shared_ptr<const Macro>& macro)
{
    const auto guard = nest();
    const bool raw = std::exchange(raw_operators_, false);
    const scene::SourceRef call = place(name);
    last_ = name;
    expect(Kind::LeftParen, fmt::format("'(' after the name of macro {}", word(name)));
    std::vector<Cell> arguments;
    arguments.reserve(macro->parameters.size());
    for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
        if (peek().kind == Kind::RightParen)
            fail_expected(fmt::format("argument '{}' of macro {}", names_.word(macro->parameters[i]), word(name)));
        Cell cell;
        Value value = read_value(&cell);
        if (!cell) cell = std::make_shared<Value>(std::move(value));
        arguments.push_back(std::move(cell));
        accept_comma();
    }
    expect(Kind::RightParen, fmt::format("')' after the arguments of macro {}", word(name)));
    raw_operators_ = raw;

    if (cursors_.size() >= kDeepestCalls) fail(call, "macros call each other too deeply; does a recursion never end?");
    symbols_.open_scope();
    for (std::size_t i = 0; i < arguments.size(); ++i) symbols_.bind(macro->parameters[i], std::move(arguments[i]));
    Cursor cursor;
    cursor.file = macro->file;
    cursor.macro = true;
    cursor.name = macro->name;
    cursor.position = macro->begin;
    cursor.end = macro->end;
    cursor.blocks = blocks_.size();
    cursor.call = call;
    Block marker = block(BlockKind::Macro, 0);
    push_block(marker);
    cursors_.push_back(cursor);
    ++statistics_.macro_calls;
}

}  // namespace parser
