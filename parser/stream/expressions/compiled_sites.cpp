#include "parser/stream/values/compiled.h"
#include "parser/stream/token_stream.h"

#include <algorithm>

/// Where compiled expressions are kept and used: by the token at which they begin.
namespace parser {
namespace {

enum Site : std::uint32_t { kUnseen, kSeen, kNever, kFirst };  // from kFirst on: a list's index
constexpr int kMostLists = 4;                                  // for one place; types may take turns

/// A name that stands before it is not all of an expression, unless it is a number before '('.
bool goes_on(Kind kind)
{
    return kind == Kind::Plus || kind == Kind::Minus || kind == Kind::Star || kind == Kind::Slash ||
           kind == Kind::Period || kind == Kind::LeftParen;
}

}  // namespace

bool TokenStream::find_compiled(CompiledKey key, Tuple& out)
{
    Cursor& cursor = cursors_.back();
    const Token* const tokens = cursor.tokens;
    const std::uint32_t at = cursor.position - (has_ahead_ ? 1u : 0u);
    if (at >= cursor.end || (has_ahead_ && ahead_ != &tokens[at])) return false;
    if (!cursor.sites) cursor.sites = sites_of(cursor.file);
    std::uint32_t& site = cursor.sites[at];
    if (site < kFirst && site != kSeen) {
        if (site == kUnseen) site = kSeen;
        return false;
    }
    if (!deprecated_.empty() || language_.version < 150) return false;

    const CompiledContext context{symbols_, random_undo_, hooks_};
    int lists = 0;
    for (std::uint32_t list = site < kFirst ? kNoIndex : site - kFirst; list != kNoIndex; ++lists) {
        const CompiledExpression& expression = compiled_[list];
        if (expression.key == key && run_compiled(expression, context, out.at.data()))
            return take_compiled(expression, at, out);
        list = expression.next;
    }
    return lists < kMostLists && compile_here(key, at, out);
}

bool TokenStream::compile_here(CompiledKey key, std::uint32_t at, Tuple& out)
{
    const Cursor& cursor = cursors_.back();
    std::uint32_t& site = cursor.sites[at];
    CompiledExpression made;
    if (!compile_expression(cursor.tokens, at, cursor.end, key, Meanings(symbols_), made)) {
        if (site < kFirst) site = kNever;
        return false;
    }
    made.next = site < kFirst ? kNoIndex : site - kFirst;
    site = static_cast<std::uint32_t>(compiled_.size()) + kFirst;
    compiled_.push_back(std::move(made));
    return run_compiled(compiled_.back(), {symbols_, random_undo_, hooks_}, out.at.data()) &&
           take_compiled(compiled_.back(), at, out);
}

std::uint32_t* TokenStream::sites_of(std::uint16_t file)
{
    if (file >= sites_.size()) sites_.resize(file + 1u);
    if (sites_[file].empty()) sites_[file].resize(files_[file]->tokens.size());
    return sites_[file].data();
}

bool TokenStream::take_compiled(const CompiledExpression& expression, std::uint32_t at, Tuple& out)
{
    out.count = expression.count;
    Cursor& cursor = cursors_.back();
    const std::uint32_t length = expression.end - at;
    cursor.position = expression.end;
    has_ahead_ = ahead_raw_ = false;
    last_ = &cursor.tokens[expression.end - 1];
    taken_ += length;
    left_ -= std::min<std::uint64_t>(left_, length);
    return true;
}

/// `#declare NAME = expression;` of a number or vector that replaces a number or vector, or makes a new one. Behind the
/// word; false, with nothing done: not so simple.
bool TokenStream::declare_compiled(bool local)
{
    if (has_ahead_ || blocks_.empty() || !blocks_.back().repeats) return false;
    Cursor& cursor = cursors_.back();
    const Token* const tokens = cursor.tokens;
    const std::uint32_t begin = cursor.position;
    if (begin + 2 >= cursor.end || tokens[begin].kind != Kind::Identifier || tokens[begin + 1].kind != Kind::Equal)
        return false;
    const std::uint32_t name = tokens[begin].name;
    const Value* old = symbols_.find(name);
    if (old && !old->get_if<Tuple>()) return false;
    cursor.position = begin + 2;
    raw_operators_ = true;
    Tuple value;
    const bool known = run_compiled_here(1, false, value);
    raw_operators_ = false;
    if (!known) {
        cursor.position = begin;
        return false;
    }
    Value& target = local ? *symbols_.local(name, symbols_.depth()) : *symbols_.declare(name);
    if (Tuple* same = target.get_if<Tuple>()) *same = value.stored();
    else target = value.stored();
    std::uint32_t& at = cursors_.back().position;
    const std::uint32_t end = cursors_.back().end;
    if (at >= end || tokens[at].kind != Kind::Semicolon) {
        end_declaration(true);
        return true;
    }
    ++at;
    if (language_.version >= 350 && at < end && tokens[at].kind == Kind::Semicolon) ++at;
    return true;
}

/// An argument of a macro that is one name or a compiled expression; the token behind it is next. Null: neither.
Cell TokenStream::argument_compiled(std::uint32_t scope)
{
    if (has_ahead_ || symbols_.depth() != scope) return nullptr;  // also where another macro's text goes on with it
    Cursor& cursor = cursors_.back();
    const Token* const tokens = cursor.tokens;
    const std::uint32_t at = cursor.position;
    if (at + 1 >= cursor.end) return nullptr;
    const Kind behind = tokens[at + 1].kind;
    if (tokens[at].kind == Kind::Identifier && (behind == Kind::Comma || behind == Kind::RightParen)) {
        if (!deprecated_.empty()) return nullptr;
        Cell cell = symbols_.find_cell(tokens[at].name);
        if (!cell || !(cell->get_if<Tuple>() || cell->get_if<std::string>() || cell->get_if<std::shared_ptr<Array>>()))
            return nullptr;
        ++cursor.position;
        return cell;
    }
    // A name or `A[I]` alone is the variable itself: what the macro does to its parameter happens to that.
    if (tokens[at].kind == Kind::Identifier && !goes_on(behind)) return nullptr;
    const bool maybe_called = tokens[at].kind == Kind::Identifier && behind == Kind::LeftParen;
    const Value* const called = maybe_called ? value_of(tokens[at]) : nullptr;
    if (called && called->get_if<Tuple>()) return nullptr;
    Tuple value;
    if (!run_compiled_here(1, false, value)) return nullptr;
    return make_cell(value.stored());
}

}  // namespace parser
