#include "parser/grammar/core/values.h"

#include <fmt/format.h>

namespace parser {

void fail_range(TokenStream& in, const scene::SourceRef& at, Kind keyword, const Range& range)
{
    const std::string_view from = range.above ? "above" : "at least";
    const std::string limits = range.high >= kMost
                                   ? fmt::format("{} {}", from, range.low)
                                   : fmt::format("{}{} to {}", range.above ? "above " : "from ", range.low, range.high);
    in.fail(at, fmt::format("'{}' must be {}", spelling(keyword), limits));
}

}  // namespace parser
