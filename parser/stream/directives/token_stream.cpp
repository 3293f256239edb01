#include "parser/stream/blocks/runner.h"
#include "parser/stream/token_stream.h"

#include "parser/stream/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace parser {
namespace {

bool may_begin_block(Kind directive)
{
    return directive == Kind::Declare || directive == Kind::Local || directive == Kind::If ||
           directive == Kind::While || directive == Kind::For || directive == Kind::Switch ||
           directive == Kind::Ifdef || directive == Kind::Ifndef;
}

}  // namespace

TokenStream::TokenStream(const Options& options, GrammarHooks& hooks, MessageSink sink, void* sink_context)
    : options_(options), hooks_(hooks), sink_(sink), sink_context_(sink_context), kept_files_(options.texts)
{
    language_.version = options.version;
    language_.version_set = options.version_given;
    constexpr int kFirstOf38 = 371;
    language_.povray = options.povray.value_or(
        options.version_given && options.version >= kFirstOf38 ? scene::PovRay::V38 : scene::PovRay::V37);
    later_ = options.most_tokens != 0 ? options.most_tokens : std::numeric_limits<std::uint64_t>::max();
    predefine();
    runner_ = std::make_unique<blocks::Runner>(*this);
}

TokenStream::~TokenStream() = default;

TokenStream::Nesting::Nesting(TokenStream& stream) : stream_(stream)
{
    if (stream_.nesting_ >= kMostNesting) stream_.fail(stream_.last(), "this is nested too deeply");
    ++stream_.nesting_;
}

const Token& TokenStream::advance_further()
{
    for (;;) {
        Cursor& cursor = cursors_.back();
        if (cursor.position < cursor.end) {
            if (left_ == 0) allow_more(cursor.tokens[cursor.position]);
            --left_;
            return cursor.tokens[cursor.position++];
        }
        if (cursors_.size() == 1) return files_[cursor.file]->tokens.back();
        leave_cursor();
    }
}

/// The next share of the tokens that may be read; between shares is the time to look whether anybody still wants them.
void TokenStream::allow_more(const Token& next)
{
    constexpr std::uint64_t kShare = 1 << 10;  // in a loop that calls trace() they take a millisecond
    spend_time();
    if (options_.cancel && *options_.cancel) {
        const Token* loop = innermost_loop();
        const scene::SourceRef at = place(loop ? *loop : next);
        report(located(Severity::Note, at, loop ? "reading is cancelled, in this loop" : "reading is cancelled here"));
        throw Cancelled();
    }
    if (later_ == 0) fail(place(next), "the limit of tokens is reached: does this loop end?");
    left_ = std::min(kShare, later_);
    later_ -= left_;
}

/// Null: no loop is being read.
const Token* TokenStream::innermost_loop() const
{
    for (std::size_t i = blocks_.size(); i-- > 0;)
        if (blocks_[i].kind == BlockKind::While || blocks_[i].kind == BlockKind::For)
            return &files_[blocks_[i].file]->tokens[blocks_[i].branch];
    return nullptr;
}

void TokenStream::leave_cursor()
{
    const Cursor& cursor = cursors_.back();
    if (cursor.macro) {
        blocks_.resize(cursor.blocks);
    } else {
        for (std::size_t i = cursor.blocks; i < blocks_.size(); ++i)
            if (blocks_[i].kind == BlockKind::While || blocks_[i].kind == BlockKind::For)
                fail(place(files_[blocks_[i].file]->tokens[blocks_[i].branch]), "this loop has no #end in its file");
    }
    symbols_.close_scope();
    cursors_.pop_back();
}

TokenStream::Again::Again(TokenStream& stream, const Token* begin, const Token* end)
    : stream_(stream), depth_(stream.cursors_.size()), ahead_(stream.ahead_), last_(stream.last_),
      has_ahead_(stream.has_ahead_), ahead_raw_(stream.ahead_raw_), raw_operators_(stream.raw_operators_),
      left_(stream.left_)
{
    const Token* const tokens = stream.files_[begin->file]->tokens.data();
    Cursor cursor;
    cursor.file = begin->file;
    cursor.macro = true;
    cursor.tokens = tokens;
    cursor.position = static_cast<std::uint32_t>(begin - tokens);
    cursor.end = static_cast<std::uint32_t>(end - tokens);
    cursor.blocks = stream.blocks_.size();
    stream.cursors_.push_back(cursor);
    stream.symbols_.open_scope();
    stream.has_ahead_ = stream.ahead_raw_ = stream.raw_operators_ = false;
    stream.left_ = cursor.end;  // they are counted with the block that they stand in
}

TokenStream::Again::~Again()
{
    while (stream_.cursors_.size() > depth_) stream_.leave_cursor();
    stream_.ahead_ = ahead_;
    stream_.last_ = last_;
    stream_.has_ahead_ = has_ahead_;
    stream_.ahead_raw_ = ahead_raw_;
    stream_.raw_operators_ = raw_operators_;
    stream_.left_ = left_;
}

bool TokenStream::is_macro(const Token& token) const
{
    if (token.kind != Kind::Identifier) return false;
    const Value* value = symbols_.find(token.name);
    return value && value->get_if<std::shared_ptr<const Macro>>();
}

void TokenStream::fetch()
{
    for (;;) {
        if (has_ahead_) {
            if (!ahead_raw_) return;
            // Fetched where directives are not executed: now they are.
            ahead_raw_ = false;
            if (ahead_->kind != Kind::Hash && !is_macro(*ahead_)) {
                if (!deprecated_.empty() && ahead_->kind == Kind::Identifier) warn_deprecated(*ahead_);
                ahead_ = &as_word(*ahead_);
                return;
            }
            has_ahead_ = false;
            --cursors_.back().position;
        }
        const Token& token = advance();
        switch (token.kind) {
        case Kind::Hash: execute_directive(); break;
        case Kind::Bad: fail_bad(token);
        case Kind::EndOfText:
            if (!blocks_.empty())
                fail(place(files_[blocks_.back().file]->tokens[blocks_.back().branch]), "this has no #end");
            ahead_ = &token;
            has_ahead_ = true;
            return;
        case Kind::Identifier:
            if (const Value* value = symbols_.find(token.name))
                if (const auto* macro = value->get_if<std::shared_ptr<const Macro>>()) {
                    const FlagInScope expected(statements_, false);  // in its arguments
                    call_macro(token, **macro);
                    break;
                }
            if (!deprecated_.empty()) warn_deprecated(token);
            ahead_ = &as_word(token);
            has_ahead_ = true;
            return;
        default:
            ahead_ = &token;
            has_ahead_ = true;
            return;
        }
    }
}

const Token& TokenStream::peek_raw()
{
    if (!has_ahead_ && !fetch_plain()) {
        ahead_ = &advance();
        if (ahead_->kind == Kind::Bad) fail_bad(*ahead_);
        has_ahead_ = ahead_raw_ = true;
    }
    return *ahead_;
}

const Token& TokenStream::raw_next()
{
    peek_raw();
    has_ahead_ = ahead_raw_ = false;
    ++taken_;
    return *(last_ = ahead_);
}

void TokenStream::execute_directive()
{
    Cursor& cursor = cursors_.back();
    if (cursor.position >= cursor.end) return;
    const Token& word = cursor.tokens[cursor.position];
    if (!is_keyword(word.kind)) return;  // `#name` means `name`
    const std::uint32_t hash = cursor.position - 1;
    ++cursor.position;
    const auto guard = nest();
    const bool raw = std::exchange(raw_operators_, false);
    last_ = &word;
    const bool again = !blocks_.empty() && blocks_.back().repeats;
    const FlagInScope expected(statements_, false);  // in what the directive reads
    runner_->expect_statements(expected.before());
    const bool done = again && may_begin_block(word.kind) && runner_->at_directive(hash);
    if (!done && !execute(word.kind, hash)) --cursors_.back().position;  // `#sphere` means `sphere`
    raw_operators_ = raw;
}

void TokenStream::bare_directive(const Token& token)
{
    if (language_.version >= 350) warn(place(token), fmt::format("'{}' should have a '#' before it", word(token)));
    execute(token.kind, cursors_.back().position - 1);
}

bool TokenStream::execute(Kind word, std::uint32_t hash)
{
    switch (word) {
    case Kind::If: begin_if(hash, &TokenStream::read_if, true); break;
    case Kind::Ifdef: begin_if(hash, &TokenStream::read_ifdef, true); break;
    case Kind::Ifndef: begin_if(hash, &TokenStream::read_ifdef, false); break;
    case Kind::Else:
    case Kind::Elseif: else_branch(hash); break;
    case Kind::End: end_block(hash); break;
    case Kind::Switch: begin_switch(hash); break;
    case Kind::Case:
    case Kind::Range: next_case(word, hash); break;
    case Kind::While: begin_while(hash); break;
    case Kind::For: begin_for(hash); break;
    case Kind::Break: break_block(hash); break;
    case Kind::Macro: define_macro(hash); break;
    case Kind::Declare:
        if (!declare_compiled(false)) declare(false);
        break;
    case Kind::Local:
        if (!declare_compiled(true)) declare(true);
        break;
    case Kind::Undef: undefine(); break;
    case Kind::Version: set_version(hash); break;
    case Kind::Include: include(); break;
    case Kind::Default: hooks_.parse_default(*this); break;
    case Kind::Debug:
    case Kind::Warning:
    case Kind::Error:
    case Kind::Render:
    case Kind::Statistics: message_directive(word); break;
    case Kind::Fopen: open_data_file(); break;
    case Kind::Fclose: close_data_file(); break;
    case Kind::Read: read_data(); break;
    case Kind::Write: write_data(); break;
    default: return false;
    }
    return true;
}

}  // namespace parser
