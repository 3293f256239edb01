#include "parser/stream/blocks/runner.h"
#include "parser/stream/expression.h"
#include "parser/stream/limits.h"
#include "parser/stream/token_stream.h"

#include <cmath>

namespace parser {

void TokenStream::leave_loop(std::uint32_t hash_of_loop)
{
    Cursor& cursor = cursors_.back();
    const std::uint32_t end = file().tokens[hash_of_loop].jump;
    if (end == kNoIndex) fail(place(file().tokens[hash_of_loop]), "this loop has no #end in its file");
    check_skipped(cursor.position, end);
    cursor.position = end + 2;
}

void TokenStream::begin_while(std::uint32_t hash)
{
    Block loop = block(BlockKind::While, hash);
    loop.again = hash + 2;
    const bool go = read_if();
    while (cursors_.size() > loop.cursors) leave_cursor();
    if (!go) return leave_loop(hash);
    push_block(loop);
}

void TokenStream::end_while(std::uint32_t hash)
{
    if (runner_->at_end_of_pass(hash)) return;
    const Block loop = blocks_.back();
    if (loop.cursors != cursors_.size() || loop.file != cursors_.back().file)
        fail(last(), "this loop does not end in the file where it began");
    cursors_.back().position = loop.again;
    const bool go = read_if();
    while (cursors_.size() > loop.cursors) leave_cursor();
    if (go) return;
    blocks_.pop_back();
    cursors_.back().position = hash + 2;
}

void TokenStream::begin_for(std::uint32_t hash)
{
    Block loop = block(BlockKind::For, hash);
    expect(Kind::LeftParen, "'('");
    const Token name = raw_next();
    if (name.kind != Kind::Identifier) fail(place(name), "expected the name of the loop's variable");
    accept_comma();
    const double start = float_expr(*this);
    accept_comma();
    loop.limit = float_expr(*this);
    loop.step = 1.0;
    accept_comma();
    if (peek().kind != Kind::RightParen) loop.step = float_expr(*this);
    expect(Kind::RightParen, "')'");
    while (cursors_.size() > loop.cursors) leave_cursor();
    if (!(std::abs(loop.step) >= kSlackOfFor)) fail(place(name), "the step of this #for is zero");
    loop.variable = symbols_.local(name.name, symbols_.depth());
    *loop.variable = Tuple::of(start);
    loop.again = cursors_.back().position;
    if (!for_goes_on(start, loop.limit, loop.step)) return leave_loop(hash);
    push_block(loop);
}

void TokenStream::end_for(std::uint32_t hash)
{
    if (runner_->at_end_of_pass(hash)) return;
    const Block& loop = blocks_.back();
    if (loop.cursors != cursors_.size() || loop.file != cursors_.back().file)
        fail(last(), "this loop does not end in the file where it began");
    Tuple* variable = loop.variable->get_if<Tuple>();
    if (!variable || variable->count != 1) fail(last(), "the variable of this #for is no longer a number");
    const double value = variable->at[0] + loop.step;
    *variable = Tuple::of(value);
    if (for_goes_on(value, loop.limit, loop.step)) {
        cursors_.back().position = loop.again;
        return;
    }
    blocks_.pop_back();
    cursors_.back().position = hash + 2;
}

}  // namespace parser
