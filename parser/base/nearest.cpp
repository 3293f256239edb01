#include "parser/base/nearest.h"

#include <algorithm>

namespace parser {
namespace {

/// How many letters must be inserted, removed, exchanged or swapped with their neighbour to turn one into the other.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = previous;
        previous = row;
    }
    return previous[b.size()];
}

}  // namespace

NearestName::NearestName(std::string_view word) : word_(word), distance_(std::min<std::size_t>(word.size() / 3, 2) + 1)
{}

void NearestName::offer(std::string_view candidate)
{
    if (candidate.size() + distance_ <= word_.size() || word_.size() + distance_ <= candidate.size()) return;
    const std::size_t distance = edit_distance(word_, candidate);
    if (distance >= distance_) return;
    distance_ = distance;
    best_ = candidate;
}

std::string nearest_of(std::string_view word, const std::vector<std::string>& names)
{
    const auto lower = [](std::string_view text) {
        std::string out(text);
        for (char& c : out)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return out;
    };
    const std::string wanted = lower(word);
    std::vector<std::string> lowered;
    lowered.reserve(names.size());
    NearestName nearest(wanted);
    for (const std::string& name : names) nearest.offer(lowered.emplace_back(lower(name)));
    for (std::size_t i = 0; i < names.size(); ++i)
        if (lowered[i] == nearest.best()) return names[i];
    return {};
}

}  // namespace parser
