#include "parser/stream/messages.h"

#include <fmt/format.h>

#include <algorithm>

namespace parser {
namespace {

constexpr std::size_t kLongestLine = 110;  // of a quoted source line

}  // namespace

std::string render_message(const SourceFile& file, std::uint32_t line, std::uint32_t column, std::string_view kind,
                           std::string_view text)
{
    if (line == 0) return fmt::format("{}: {}: {}", file.path, kind, text);
    std::string source(file.line_text(line));
    for (char& c : source)
        if (c != '\t' && (c < ' ' || c > '~')) c = '?';
    std::size_t caret = column - 1;
    if (source.size() > kLongestLine) {
        const std::size_t cut = caret > kLongestLine / 2 ? std::min(caret - kLongestLine / 2, source.size()) : 0;
        source = source.substr(cut, kLongestLine);
        caret -= cut;
    }
    std::string below;
    for (std::size_t i = 0; i < caret; ++i) below += i < source.size() && source[i] == '\t' ? '\t' : ' ';
    return fmt::format("{}:{}:{}: {}: {}\n{:>5} | {}\n{:>5} | {}^", file.path, line, column, kind, text, line, source, "",
                       below);
}

std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = previous;
        previous = row;
    }
    return previous[b.size()];
}

NearestName::NearestName(std::string_view word) : word_(word), distance_(std::min<std::size_t>(word.size() / 3, 2) + 1) {}

void NearestName::offer(std::string_view candidate)
{
    if (candidate.size() + distance_ <= word_.size() || word_.size() + distance_ <= candidate.size()) return;
    const std::size_t distance = edit_distance(word_, candidate);
    if (distance >= distance_) return;
    distance_ = distance;
    best_ = candidate;
}

}  // namespace parser
