#include "parser/stream/token_stream.h"

#include <fmt/format.h>

#include <algorithm>

// Which macros, loops and files are open, for ReadingProfile.
namespace parser {

void TokenStream::spend_time(std::span<const ReadingProfile::Place> inner)
{
    constexpr std::size_t kInnermost = 256;  // of a recursion a thousand deep the innermost tell enough
    open_places_.clear();
    std::size_t block = 0;
    const std::size_t first = cursors_.size() > kInnermost ? cursors_.size() - kInnermost : 0;
    for (std::size_t i = 0; i < cursors_.size(); ++i) {
        const Cursor& cursor = cursors_[i];
        if (i != 0 && i < first) continue;
        if (cursor.macro) open_places_.push_back({ReadingProfile::What::Macro, cursor.file, cursor.name});
        else open_places_.push_back({ReadingProfile::What::File, cursor.file, 0});
        const std::size_t until = i + 1 < cursors_.size() ? cursors_[i + 1].blocks : blocks_.size();
        for (block = std::max(block, cursor.blocks); block < until && block < blocks_.size(); ++block)
            if (blocks_[block].kind == BlockKind::While || blocks_[block].kind == BlockKind::For)
                open_places_.push_back({ReadingProfile::What::Loop, blocks_[block].file, blocks_[block].branch});
    }
    open_places_.insert(open_places_.end(), inner.begin(), inner.end());
    profile_.spend(open_places_);
    constexpr double kFirst = 5.0, kPeriod = 0.2;  // seconds
    if (!options_.still_reading || profile_.total() < std::max(kFirst, told_reading_ + kPeriod)) return;
    told_reading_ = profile_.total();
    options_.still_reading(described(open_places_.back()), told_reading_);
}

ReadingPlace TokenStream::described(const ReadingProfile::Place& place) const
{
    const SourceFile& source = *files_[place.file];
    if (place.what == ReadingProfile::What::File) return {"file", source.path, source.path};
    ReadingPlace out;
    std::uint32_t first = place.token;
    if (place.what == ReadingProfile::What::Loop) {
        out.what = "loop";
        out.name = fmt::format("#{}", spelling(source.tokens[first + 1].kind));
    } else {
        out.what = "macro";
        out.name = names_.word(place.token);
        first = 0;
        for (const auto& macro : macros_)
            if (macro->file == place.file && macro->name == place.token) first = macro->begin;
    }
    const scene::LineAndColumn at = source.locate(source.tokens[first].offset);
    out.place = fmt::format("{}:{}:{}", source.path, at.line, at.column);
    return out;
}

std::vector<ReadingCost> TokenStream::reading_costs(std::size_t most)
{
    spend_time();
    std::vector<ReadingCost> told;
    for (const ReadingProfile::Cost& cost : profile_.costs(most)) {
        ReadingCost& out = told.emplace_back();
        static_cast<ReadingPlace&>(out) = described(cost.place);
        out.seconds = cost.seconds;
        out.own_seconds = cost.own_seconds;
    }
    return told;
}

}  // namespace parser
