#include "parser/stream/blocks/runner.h"
#include "parser/stream/token_stream.h"

#include <algorithm>

/// Single expressions that are read again and again: where they are kept and used, by the token at which they begin.
namespace parser {

namespace blocks {

bool Runner::expression(const Form& form, Tuple& out)
{
    constexpr int kMostPrograms = 4;  // for one place; types may take turns
    Cursor& cursor = stream_.cursors_.back();
    const std::uint32_t at = cursor.position - (stream_.has_ahead_ ? 1u : 0u);
    if (at >= cursor.end || (stream_.has_ahead_ && stream_.ahead_ != &cursor.tokens[at])) return false;
    if (!cursor.sites) cursor.sites = sites_in(expression_sites_, cursor.file);
    std::uint32_t& site = cursor.sites[at];
    if (site < kFirst && site != kSeen) {
        if (site == kUnseen) site = kSeen;
        return false;
    }
    if (!stream_.deprecated_.empty() || stream_.language_.version < 150) return false;

    int programs = 0;
    for (std::uint32_t i = site < kFirst ? kNoIndex : site - kFirst; i != kNoIndex; ++programs) {
        const Expression& known = *expressions_[i];
        if (known.form == form && work_out(known, out)) return take(known, at, out);
        i = known.next;
    }
    if (programs >= kMostPrograms) return false;
    auto made = std::make_unique<Expression>();
    if (!compile(form, at, *made)) {
        if (site < kFirst) site = kNever;
        return false;
    }
    made->next = site < kFirst ? kNoIndex : site - kFirst;
    site = static_cast<std::uint32_t>(expressions_.size()) + kFirst;
    const Expression& known = *expressions_.emplace_back(std::move(made));
    return work_out(known, out) && take(known, at, out);
}

bool Runner::compile(const Form& form, std::uint32_t at, Expression& made) const
{
    const Cursor& cursor = stream_.cursors_.back();
    const Meanings meanings(stream_.symbols_);
    Emitter emitter(made.program);
    ExpressionCompiler reader(cursor.tokens, at, cursor.end, meanings, emitter);
    made.form = form;
    made.count = reader.expression(form);
    made.end = reader.at();
    if (made.count == 0) return false;
    made.program.registers = kStackRegisters;
    emitter.in_registers(static_cast<std::size_t>(made.count));
    emitter.emit(kStop);
    return true;
}

/// False: something is not as the program expects, and nothing has changed.
bool Runner::work_out(const Expression& known, Tuple& out)
{
    const std::vector<Op>& ops = known.program.ops;
    stream_.random_undo_.keep();
    alone_.enter(known.program, stream_.symbols_.depth());
    alone_.run(ops.data());
    if (alone_.stopped != &ops.back()) return stream_.random_undo_.give_up();
    std::copy(alone_.registers, alone_.registers + known.count, out.at.begin());
    return true;
}

bool Runner::take(const Expression& known, std::uint32_t at, Tuple& out)
{
    out.count = known.count;
    Cursor& cursor = stream_.cursors_.back();
    const std::uint32_t length = known.end - at;
    cursor.position = known.end;
    stream_.has_ahead_ = stream_.ahead_raw_ = false;
    stream_.last_ = &cursor.tokens[known.end - 1];
    stream_.taken_ += length;
    stream_.left_ -= std::min<std::uint64_t>(stream_.left_, length);
    return true;
}

}  // namespace blocks

namespace {

/// A name that stands before it is not all of an expression, unless it is a number before '('.
bool goes_on(Kind kind)
{
    return kind == Kind::Plus || kind == Kind::Minus || kind == Kind::Star || kind == Kind::Slash ||
           kind == Kind::Period || kind == Kind::LeftParen;
}

}  // namespace

bool TokenStream::find_compiled(int requested, bool full, Tuple& out)
{
    return runner_->expression({requested, full, raw_operators_}, out);
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
