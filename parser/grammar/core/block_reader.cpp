#include "parser/grammar/core/block_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace parser {

BlockReader::BlockReader(SceneBuilder& build)
    : build_(build), keyword_(spelling(build.stream().taken_last().kind)), source_(build.stream().last())
{}

void BlockReader::open() { opened_ = build_.open_block(keyword_); }

void BlockReader::close(const std::vector<Kind>& items)
{
    build_.close_block(keyword_, opened_, [&] { return items; });
}

void fail_range(TokenStream& in, const scene::SourceRef& at, Kind keyword, const Range& range)
{
    const std::string_view from = range.above ? "above" : "at least";
    const std::string limits = std::isinf(range.high)
                                   ? fmt::format("{} {}", from, range.low)
                                   : fmt::format("{}{} to {}", range.above ? "above " : "from ", range.low, range.high);
    in.fail(at, fmt::format("'{}' must be {}", spelling(keyword), limits));
}

}  // namespace parser
