#include "parser/stream/expression.h"
#include "parser/stream/limits.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <cmath>

namespace parser {
namespace {

constexpr double kTruth = 1e-10;  // values up to this size count as false (spec 1, 9)

bool opens(Kind kind)
{
    return kind == Kind::If || kind == Kind::Ifdef || kind == Kind::Ifndef || kind == Kind::While ||
           kind == Kind::For || kind == Kind::Switch || kind == Kind::Macro;
}

}  // namespace

double TokenStream::condition()
{
    expect(Kind::LeftParen, "'('");
    const double value = float_expr(*this, Level::Full);
    expect(Kind::RightParen, "')'");
    return value;
}

bool TokenStream::read_if() { return std::abs(condition()) > kTruth; }

bool TokenStream::read_ifdef() { return read_defined(); }

bool TokenStream::read_defined()
{
    if (raw_next().kind != Kind::LeftParen) fail(last(), "expected '(' before the name");
    Token name;
    Cell cell;
    if (at_pseudo_scope() != Kind::EndOfText) {
        const Kind scope = read_pseudo_name(name);
        cell = in_scope(scope, name.name);
    } else {
        name = raw_next();
        const bool text = name.kind == Kind::String && !strictly_37();  // which is there, as in 3.8
        if (name.kind != Kind::Identifier && !is_keyword(name.kind) && !text) fail(place(name), "expected a name");
        if (text) return expect(Kind::RightParen, "')'"), true;
        if (name.kind == Kind::Identifier) cell = symbols_.find_cell(name.name);
    }
    const Kind behind = cell && is_container(*cell) ? peek_raw().kind : Kind::EndOfText;
    if (behind == Kind::LeftSquare || behind == Kind::Period) cell = subscripted(cell, name, true);
    if (raw_next().kind != Kind::RightParen) fail(last(), "expected ')' after the name");
    return cell && cell->set();
}

Block TokenStream::block(BlockKind kind, std::uint32_t hash) const
{
    Block made;
    made.kind = kind;
    made.file = cursors_.back().file;
    made.branch = hash;
    made.cursors = cursors_.size();
    made.repeats = kind == BlockKind::While || kind == BlockKind::For || kind == BlockKind::Macro ||
                   (!blocks_.empty() && blocks_.back().repeats);
    return made;
}

void TokenStream::push_block(const Block& made)
{
    if (blocks_.size() >= kMostBlocks) fail(last(), "too many conditionals, loops and macro calls inside each other");
    blocks_.push_back(made);
}

void TokenStream::begin_if(std::uint32_t hash, bool (TokenStream::*test)(), bool wanted)
{
    const Block made = block(BlockKind::If, hash);
    const bool truth = (this->*test)() == wanted;
    push_block(made);
    if (truth) return;
    for (;;) {
        const Kind word = next_branch();
        if (word == Kind::Else) return;
        if (word == Kind::Elseif && read_if()) return;
        if (word == Kind::End) {
            blocks_.pop_back();
            return;
        }
    }
}

void TokenStream::begin_switch(std::uint32_t hash)
{
    const Block made = block(BlockKind::Switch, hash);
    const double value = condition();
    for (;;) {  // other directives may stand before the first case
        const Token first = raw_next();
        const Cursor& cursor = cursors_.back();
        const Kind word = cursor.position < cursor.end ? file().tokens[cursor.position].kind : Kind::EndOfText;
        if (first.kind != Kind::Hash) fail(place(first), "expected #case or #range after #switch");
        if (word == Kind::Case || word == Kind::Range) break;
        execute_directive();
    }
    --cursors_.back().position;
    push_block(made);
    for (;;) {
        const Kind branch = next_branch();
        if (branch == Kind::Else) return;
        if (branch == Kind::Case && std::abs(condition() - value) < kTruth) return;
        if (branch == Kind::Range) {
            expect(Kind::LeftParen, "'('");
            const double low = float_expr(*this);
            accept_comma();
            const double high = float_expr(*this);
            expect(Kind::RightParen, "')'");
            if (low <= value && value <= high) return;
        }
        if (branch == Kind::End) {
            blocks_.pop_back();
            return;
        }
    }
}

/// A `#case` reached while reading: control falls through, but its condition is still evaluated.
void TokenStream::next_case(Kind word, std::uint32_t hash)
{
    if (blocks_.empty() || blocks_.back().kind != BlockKind::Switch) fail(last(), "this stands outside of any #switch");
    blocks_.back() = block(BlockKind::Switch, hash);
    if (word == Kind::Case) {
        condition();
        return;
    }
    expect(Kind::LeftParen, "'('");
    float_expr(*this);
    accept_comma();
    float_expr(*this);
    expect(Kind::RightParen, "')'");
}

void TokenStream::else_branch(std::uint32_t hash)
{
    if (blocks_.empty() || (blocks_.back().kind != BlockKind::If && blocks_.back().kind != BlockKind::Switch))
        fail(last(), "this belongs to no #if");
    const Block& open = blocks_.back();
    const BlockKind kind = open.kind;
    if (kind == BlockKind::If && files_[open.file]->tokens[open.branch + 1].kind == Kind::Else)
        fail(last(), "this #if has its #else already, in " + line_of(place(files_[open.file]->tokens[open.branch])));
    blocks_.back() = block(kind, hash);
    if (kind == BlockKind::If) skip_to_end();  // the branch before it was the true one
}

void TokenStream::end_block(std::uint32_t hash)
{
    if (blocks_.empty() || blocks_.back().kind == BlockKind::Macro) fail(last(), "this #end belongs to nothing");
    switch (blocks_.back().kind) {
    case BlockKind::While: end_while(hash); break;
    case BlockKind::For: end_for(hash); break;
    default: blocks_.pop_back();
    }
}

void TokenStream::break_block(std::uint32_t hash)
{
    while (!blocks_.empty() && blocks_.back().kind == BlockKind::If) blocks_.pop_back();
    if (blocks_.empty()) fail(last(), "there is nothing here that #break could leave");
    const Block left = blocks_.back();
    switch (left.kind) {
    case BlockKind::Switch:
        if (left.cursors != cursors_.size()) blocks_.back() = block(BlockKind::Switch, hash);
        skip_to_end();
        break;
    case BlockKind::Macro:
        while (!cursors_.back().macro) leave_cursor();
        cursors_.back().position = cursors_.back().end;
        break;
    default:
        while (cursors_.size() > left.cursors) leave_cursor();
        blocks_.pop_back();
        leave_loop(left.branch);
    }
}

/// Leaves the branch that is being read: stands behind the word of the next one at its level, which it returns.
Kind TokenStream::next_branch()
{
    Block& top = blocks_.back();
    Cursor& cursor = cursors_.back();
    const std::uint32_t jump = files_[top.file]->tokens[top.branch].jump;
    if (top.cursors != cursors_.size() || top.file != cursor.file || jump == kNoIndex || jump + 1 >= cursor.end + 1)
        return scan_for_branch();
    check_skipped(cursor.position, jump);
    top.branch = jump;
    cursor.position = jump + 2;
    return file().tokens[jump + 1].kind;
}

/// The same where the conditional goes on in another text than it began in.
Kind TokenStream::scan_for_branch()
{
    for (int nested = 0;;) {
        Cursor& cursor = cursors_.back();
        const std::vector<Token>& tokens = files_[cursor.file]->tokens;
        while (cursor.position < cursor.end) {
            const Token& token = tokens[cursor.position++];
            if (token.kind == Kind::Bad) fail_bad(token);
            if (token.kind != Kind::Hash || cursor.position >= cursor.end) continue;
            const Kind word = tokens[cursor.position].kind;
            const bool choice = word == Kind::Case || word == Kind::Range;
            if (opens(word)) ++nested;
            else if (nested > 0) nested -= word == Kind::End;
            else if (word == Kind::End || word == Kind::Else || word == Kind::Elseif ||
                     (choice && blocks_.back().kind == BlockKind::Switch)) {
                blocks_.back() = block(blocks_.back().kind, cursor.position - 1);
                ++cursor.position;
                return word;
            }
        }
        if (cursors_.size() == 1 || cursor.macro)
            fail(place(files_[blocks_.back().file]->tokens[blocks_.back().branch]), "this has no #end");
        leave_cursor();
    }
}

void TokenStream::skip_to_end()
{
    while (next_branch() != Kind::End) {}
    blocks_.pop_back();
}

void TokenStream::check_skipped(std::uint32_t begin, std::uint32_t end)
{
    for (const std::uint32_t bad : file().bad)
        if (bad >= begin && bad < end) fail_bad(file().tokens[bad]);
}

}  // namespace parser
