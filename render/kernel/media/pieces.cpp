#include "render/kernel/media/pieces.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// Starts and ends are sorted each by themselves, as POV-Ray has it.
void add_parts(double length, std::vector<MediaRange>& ranges, std::vector<MediaPiece>& out)
{
    const auto sort_by = [&](double MediaRange::*end) {
        for (std::size_t i = 1; i < ranges.size(); ++i)
            for (std::size_t k = i; k > 0 && ranges[k].*end < ranges[k - 1].*end; --k)
                std::swap(ranges[k].*end, ranges[k - 1].*end);
    };
    sort_by(&MediaRange::from);
    sort_by(&MediaRange::to);
    const auto add = [&](double from, double to, bool lit) { out.push_back({from, to - from, 1, lit}); };
    if (ranges[0].from > 0.0) add(0.0, ranges[0].from, false);
    double begin = ranges[0].from, end = ranges[0].to;
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        if (ranges[i].from > end) {
            add(begin, end, true);
            add(end, ranges[i].from, false);
            begin = ranges[i].from;
            end = ranges[i].to;
        } else {
            end = std::max(end, ranges[i].to);
        }
    }
    add(begin, end, true);
    if (end < length) add(end, length, false);
}

}  // namespace

void add_pieces(const MediaMix& mix, double length, std::vector<MediaRange>& ranges, std::vector<MediaPiece>& out)
{
    const plan::Media& control = *mix.control;
    const std::size_t first = out.size();
    if (ranges.empty()) out.push_back({0.0, length, 1, false});
    else add_parts(length, ranges, out);
    const auto pieces = static_cast<int>(out.size() - first);
    const int intervals = std::max(control.intervals, pieces);
    if (pieces == 1) {
        MediaPiece& whole = out.back();
        whole.count = !whole.lit && !control.has_density ? 1 : intervals;
        whole.step /= whole.count;
        return;
    }
    double sum = 0.0;
    const auto weight = [&](const MediaPiece& piece) { return piece.lit ? control.ratio : 1.0 - control.ratio; };
    for (std::size_t i = first; i < out.size(); ++i) sum += weight(out[i]);
    int left = intervals;
    for (int i = 0; i < pieces; ++i) {
        MediaPiece& piece = out[first + static_cast<std::size_t>(i)];
        const double share = sum > 0.0 ? weight(piece) / sum : 0.0;
        piece.count = static_cast<int>(std::floor(std::clamp(share, 0.0, 1.0) * intervals)) + 1;
        piece.count = std::max(1, std::min(piece.count, left - pieces + i + 1));
        piece.step /= piece.count;
        left -= piece.count;
    }
}

}  // namespace trace
