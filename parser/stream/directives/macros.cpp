#include "parser/stream/functions/function.h"
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
        const bool optional = as_word(token).kind == Kind::Optional && peek_raw().kind == Kind::Identifier;
        if (optional) token = raw_next();
        if (token.kind != Kind::Identifier) fail_expected_at(token, "a parameter's name or ')'");
        macro->parameters.push_back(token.name);
        macro->optional.push_back(optional);
        if (peek_raw().kind == Kind::Comma) raw_next();
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
    const bool raw = std::exchange(raw_operators_, true);
    const std::uint32_t scope = symbols_.depth();
    const std::size_t first = arguments_.size(), count = macro.parameters.size();
    last_ = &name;
    if (!accept(Kind::LeftParen)) fail_expected(fmt::format("'(' after the name of macro {}", word(name)));
    for (std::size_t i = 0; i < count; ++i) {
        if (macro.optional[i] && left_out()) {
            arguments_.emplace_back();
        } else if (Cell simple = argument_compiled(scope)) {
            arguments_.push_back(std::move(simple));
        } else {
            if (peek().kind == Kind::RightParen)
                fail_expected(fmt::format("argument '{}' of macro {}", names_.word(macro.parameters[i]), word(name)));
            arguments_.push_back(argument(scope, i + 1 == count));
        }
        end_of_argument(arguments_.back());
    }
    if (!accept(Kind::RightParen)) fail_expected(fmt::format("')' after the arguments of macro {}", word(name)));
    raw_operators_ = raw;
    enter_macro(name, macro, first);
}

/// `scope`: of the call. What a name means that only a macro knows which has ended since is handed over by value.
Cell TokenStream::argument(std::uint32_t scope, bool is_last)
{
    const Token& first = peek();
    Named named;
    Value value = read_value(&named);
    if (!named.cell) return make_cell(std::move(value));
    const Value& own = *named.cell;
    const auto by_value = [](const Value& given) { return make_cell(deep_copy(given)); };
    const bool shared = named.cell.use_count() > 1;
    const Cell given = named.scope > scope && shared ? by_value(own) : named.cell;
    if (is_last || !may_go_on(own)) return given;
    check_uncalled(own);
    if (element_ahead()) return by_value(own);
    const Cell next = taken_instead(first, own);
    if (!next) return given;
    if (symbols_.scope_of(ahead_->name) > scope) return by_value(own);
    return own.get_if<function::FunctionPtr>() ? by_value(*next) : next;
}

/// Where an operator might have stood no directive is executed: POV-Ray takes none there, and no call of a macro.
void TokenStream::end_of_argument(const Cell& given)
{
    if (!plain_ahead() && given && may_go_on(*given) && (peek_raw().kind == Kind::Hash || is_macro(*ahead_)))
        fail(place(*ahead_), fmt::format("expected ',' or ')' after the argument, found {}: a comma before it or "
                                         "parentheses around the argument help",
                                         ahead_->kind == Kind::Hash ? "a directive" : "a macro's name"));
    accept_comma();
}

/// An operator or parentheses might follow it where it is named.
bool TokenStream::may_go_on(const Value& value)
{
    return value.get_if<Tuple>() || value.get_if<function::FunctionPtr>() || value.get_if<SplinePtr>();
}

/// The name ahead has subscripts.
bool TokenStream::element_ahead() const
{
    if (!has_ahead_ || ahead_->kind != Kind::Identifier) return false;
    const Value* const value = value_of(*ahead_);
    const Cursor& cursor = cursors_.back();
    if (!value || !is_container(*value) || cursor.position >= cursor.end) return false;
    const Kind behind = cursor.tokens[cursor.position].kind;
    return behind == Kind::LeftSquare || (behind == Kind::Period && value->get_if<std::shared_ptr<Dictionary>>());
}

/// A number, function or spline was named by itself: a name that stands right behind it is what POV-Ray takes instead
/// (docs/povray/01-language.md, 8.4). Null: none stands there.
Cell TokenStream::taken_instead(const Token& first, const Value& named)
{
    if (!has_ahead_ || ahead_->kind != Kind::Identifier || element_ahead() || is_macro(*ahead_)) return nullptr;
    Cell next = symbols_.find_cell(ahead_->name);
    const bool same = next.get() == &named || (last_ == &first && first.name == ahead_->name);
    if (next && !same) {
        const std::string text = word(first) + (last_->kind == Kind::RightSquare ? "[...]" : "");
        warn(place(first),
             fmt::format("'{}' is taken in place of '{}', as in POV-Ray, because no comma stands between "
                         "them; write '{}, {}'",
                         word(*ahead_), text, text, word(*ahead_)),
             "missing-comma");
    }
    return next;
}

/// Behind a function or spline that is named and not called.
void TokenStream::check_uncalled(const Value& value)
{
    if (value.get_if<Tuple>()) return;
    const Kind behind = peek_operator().kind;
    if (behind == Kind::Plus || behind == Kind::Minus || behind == Kind::Star || behind == Kind::Slash ||
        element_ahead())
        fail_expected(fmt::format("a comma, or '(' and what {} is called with", type_name(value)));
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
