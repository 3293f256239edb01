#include "parser/stream/token_stream.h"

/// Going on behind a statement with a mistake, so that one run tells several.
namespace parser {

void TokenStream::begin_statement()
{
    const bool plain = has_ahead_ && cursors_.size() == 1 && blocks_.empty();
    statement_ = plain ? cursors_.back().position - 1 : kNoIndex;
    open_blocks_.clear();
    block_warnings_.clear();
}

bool TokenStream::skip_statement()
{
    if (statement_ == kNoIndex || cursors_.size() != 1 || !blocks_.empty()) return false;
    Cursor& cursor = cursors_.back();
    std::uint32_t at = statement_ + 1;
    if (at >= cursor.end || cursor.tokens[at].kind != Kind::LeftBrace) return false;
    for (int depth = 0; at < cursor.end; ++at) {
        const Kind kind = cursor.tokens[at].kind;
        if (kind == Kind::Hash || kind == Kind::Bad) return false;  // a directive may declare what later text needs
        if (kind == Kind::LeftBrace) ++depth;
        if (kind == Kind::RightBrace && --depth == 0) break;
    }
    if (at >= cursor.end || cursor.position > at + 1) return false;
    cursor.position = at + 1;
    has_ahead_ = ahead_raw_ = raw_operators_ = false;
    statement_ = kNoIndex;
    return true;
}

}  // namespace parser
