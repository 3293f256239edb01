#include "parser/base/nearest.h"
#include "parser/stream/texts/quoted_text.h"
#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

/// What a TokenStream says about places: errors, warnings, and how a place was reached.
namespace parser {

scene::SourceRef TokenStream::here() { return place(peek()); }

scene::SourceRef TokenStream::last() const { return place(*last_); }

std::string TokenStream::line_of(const scene::SourceRef& at) const
{
    const std::string line = fmt::format("line {}", line_and_column(at).line);
    return at.file == cursors_.back().file ? line : fmt::format("{} of {}", line, files_[at.file]->path);
}

std::string TokenStream::where_opened(std::string_view what, const scene::SourceRef& brace)
{
    const scene::SourceRef now = here();
    if (now.file == brace.file && line_and_column(now).line == line_and_column(brace).line) return {};
    told_brace_ = brace;
    return fmt::format("; the '{{' of {} stands in {}", what, line_of(brace));
}

void TokenStream::expect_closing(std::string_view what, std::string_view block, const scene::SourceRef& brace)
{
    if (!accept(Kind::RightBrace)) fail_expected(what, where_opened(block, brace));
}

scene::Message TokenStream::located(Severity severity, const scene::SourceRef& at, std::string_view text) const
{
    Message out = message(severity, at, text);
    if (at.file >= files_.size()) return out;
    if (out.place.at.line > 0) out.quote = quoted_line(*files_[at.file], out.place.at);
    if (severity == Severity::Error && told_brace_.somewhere())
        out.opened = scene::Place{files_[told_brace_.file]->path, line_and_column(told_brace_)};
    constexpr std::size_t kMostNotes = 8;  // a runaway recursion has hundreds, most of them alike
    for (std::size_t i = cursors_.size(); i-- > 1;) {
        const Cursor& cursor = cursors_[i];
        const scene::SourceRef call = place(*cursor.call);
        scene::RelatedPlace next{{files_[call.file]->path, line_and_column(call)},
                                 cursor.macro ? "in the expansion of macro " + names_.word(cursor.name)
                                              : "included here"};
        if (!out.related.empty() && scene::same_place(out.related.back(), next)) ++out.related.back().times;
        else if (out.related.size() < kMostNotes) out.related.push_back(std::move(next));
        else break;
    }
    return out;
}

void TokenStream::fail(const scene::SourceRef& at, std::string_view text)
{
    Message message = located(Severity::Error, at, text);
    told_brace_ = {};
    throw Error(std::move(message));
}

void TokenStream::fail_bad(const Token& token) { fail(place(token), files_[token.file]->strings[token.name]); }

void TokenStream::fail_expected(std::string_view what, std::string_view more)
{
    if (!has_ahead_) peek();
    fail_expected_at(*ahead_, what, more);
}

void TokenStream::fail_expected_at(const Token& found, std::string_view what, std::string_view more)
{
    if (found.kind == Kind::EndOfText) {
        const bool untold = more.empty() && !open_blocks_.empty();
        if (untold) told_brace_ = open_blocks_.back();
        const std::string open = untold ? fmt::format("; the '{{' in {} is not closed", line_of(open_blocks_.back()))
                                        : std::string(more);
        fail(place(found), fmt::format("expected {}, found the end of the text{}", what, open));
    }
    std::string text = printable(files_[found.file]->token_text(found));
    constexpr std::size_t kLongestQuote = 40;
    if (text.size() > kLongestQuote) text = text.substr(0, character_start(text, kLongestQuote)) + "...";
    if (found.kind == Kind::Identifier && !value_of(found)) {
        if (const std::string why = why_no_word(found); !why.empty())
            fail(place(found), fmt::format("expected {}, found '{}'{}", what, text, why));
        NearestName nearest(text);
        for (std::uint32_t name = 0; name < names_.size(); ++name)
            if (names_.reserved(name) || symbols_.find(name)) nearest.offer(names_.word(name));
        if (!nearest.best().empty())
            fail(place(found), fmt::format("expected {}, found '{}', which is not declared; did you mean '{}'?", what,
                                           text, nearest.best()));
        fail(place(found), fmt::format("expected {}, found '{}', which is not declared", what, text));
    }
    const std::string hint = hint_at(found);
    fail(place(found), fmt::format("expected {}, found '{}'{}", what, text, hint.empty() ? std::string(more) : hint));
}

void TokenStream::fail_undeclared(const Token& token, std::string_view block, std::span<const Kind> items)
{
    const std::string& word = names_.word(token.name);
    if (const std::string why = why_no_word(token); !why.empty())
        fail(place(token), fmt::format("'{}' is not declared{}", word, why));
    NearestName nearest(word);
    for (const Kind item : items) nearest.offer(spelling(item));
    for (std::uint32_t name = 0; name < names_.size(); ++name)
        if (names_.reserved(name) || symbols_.find(name)) nearest.offer(names_.word(name));
    if (!nearest.best().empty())
        fail(place(token), fmt::format("'{}' is not declared; did you mean '{}'?", word, nearest.best()));
    if (block.empty()) fail(place(token), fmt::format("'{}' is not declared", word));
    std::vector<std::string_view> words;
    for (const Kind item : items) words.push_back(spelling(item));
    std::sort(words.begin(), words.end());
    fail(place(token), fmt::format("'{}' is no item of '{}', and it is not declared{}{}", word, block,
                                   words.empty() ? "" : "; the items are ", fmt::join(words, ", ")));
}

void TokenStream::report(Message message)
{
    messages_.push_back(std::move(message));
    if (sink_) sink_(sink_context_, messages_.back());
}

void TokenStream::warn(const scene::SourceRef& at, std::string_view text, std::string_view check)
{
    if (!warned_.insert(message_text(message(Severity::Warning, at, text))).second) return;
    Message told = located(Severity::Warning, at, text);
    told.check = check;
    report(std::move(told));
}

void TokenStream::warn_when_closed(const scene::SourceRef& at, std::string text)
{
    block_warnings_.push_back({open_blocks_.size(), at, std::move(text)});
}

void TokenStream::tell_of_closed_blocks()
{
    while (!block_warnings_.empty() && block_warnings_.back().depth > open_blocks_.size()) {
        const BlockWarning told = std::move(block_warnings_.back());
        block_warnings_.pop_back();
        warn(told.at, told.text);
    }
}

/// #warning: each time, but what it is and how it was reached only once.
void TokenStream::warn_as_written(const scene::SourceRef& at, const std::string& text)
{
    Message line = message(Severity::Warning, at, text);
    const bool first = warned_.insert(message_text(line)).second;
    report(first ? located(Severity::Warning, at, text) : std::move(line));
}

}  // namespace parser
