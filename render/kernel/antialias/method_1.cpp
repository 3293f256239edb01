#include "render/kernel/antialias/methods.h"

#include "render/kernel/antialias/block_grid.h"
#include "render/kernel/antialias/jitter.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace trace {
namespace {

std::uint64_t eight(const std::uint8_t* flags)
{
    std::uint64_t all = 0;
    std::memcpy(&all, flags, sizeof all);
    return all;
}

/// The first of the flags [from, end) that is not 0; end: none is.
std::size_t next_set(const std::uint8_t* flags, std::size_t from, std::size_t end)
{
    while (from + 8 <= end && eight(flags + from) == 0) from += 8;
    while (from < end && flags[from] == 0) ++from;
    return from;
}

/// Method 1: centre samples of the block and of the row above and the column left of it, then a scan in reading order
/// that refines a pixel and its neighbour wherever the two differ. A pixel is compared with what the scan has made of
/// those on its left and above. So that samples fill tiles, the scan goes on with the old colours of the pixels that it
/// refines, all of them are traced, and it is made again with what is known now, until it asks for nothing new: then it
/// has found what a scan that waits finds. About one of a hundred samples turns out not to have been needed.
class Method1 {
public:
    Method1(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
            const SampleTracer& tracer, AntialiasScratch& scratch)
        : settings_(settings), distance_(distance), block_(block), tracer_(tracer), scratch_(scratch),
          stride_(static_cast<std::size_t>(block.width) + 1)
    {}

    void run(scene::Color* out)
    {
        trace_centres();
        compare_centres();
        while (scan()) refine();
        const auto width = static_cast<std::size_t>(block_.width);
        for (int row = 0; row < block_.height; ++row, out += width) {
            const std::size_t first = index(0, row);
            std::copy_n(scratch_.samples.colors.data() + first, width, out);
            const std::uint8_t* marked = scratch_.marked.data() + first;
            for (std::size_t i = next_set(marked, 0, width); i < width; i = next_set(marked, i + 1, width)) {
                out[i] = now(first + i).color;
                scratch_.supersamples += samples_of_pixel();
            }
        }
    }

private:
    enum Differs : std::uint8_t { kLeft = 1, kUp = 2 };
    static std::uint8_t flags_of(bool left, bool up)
    {
        return static_cast<std::uint8_t>((left ? kLeft : 0) | (up ? kUp : 0));
    }

    std::size_t samples_of_pixel() const
    {
        return static_cast<std::size_t>(settings_.depth) * static_cast<std::size_t>(settings_.depth);
    }

    /// -1 is the border on the left or above.
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row + 1) * stride_ + static_cast<std::size_t>(column + 1);
    }

    void trace_centres()
    {
        const SampleGrid grid{{block_.left - 1, block_.top - 1}, block_.width + 1, block_.height + 1};
        scratch_.places.assign(grid.count(), kNoPlace);
        trace_block_grid(grid, tracer_, scratch_);
        distance_.encode(scratch_.samples, 0);
        order_cells(grid.columns, grid.rows, tracer_.in_order, scratch_);
    }

    void compare_centres()
    {
        const EncodedColors& samples = scratch_.samples;
        scratch_.differing.assign(scratch_.samples.size(), 0);
        const std::array<std::size_t, 2> left{1, 0}, up{stride_, 0};
        const auto width = static_cast<std::size_t>(block_.width);
        for (int row = 0; row < block_.height; ++row) {
            const std::size_t first = index(0, row);
            std::uint8_t* flags = scratch_.differing.data() + first;
            distance_.mark_unsure(samples, first - 1, width, left, kLeft, flags);
            distance_.mark_unsure(samples, first - stride_, width, up, kUp, flags);
            for (std::size_t i = next_set(flags, 0, width); i < width; i = next_set(flags, i + 1, width)) {
                const std::size_t here = first + i;
                const bool from_left = (flags[i] & kLeft) != 0 && distance_.differ(samples[here - 1], samples[here]),
                           from_above = (flags[i] & kUp) != 0 &&
                                        distance_.differ(samples[here - stride_], samples[here]);
                flags[i] = flags_of(from_left, from_above);
            }
        }
    }

    /// Whether it has asked for samples.
    bool scan()
    {
        scratch_.marked.assign(scratch_.samples.size(), 0);
        scratch_.refined.clear();
        asked_ = false;
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) {
                column += alike_from(column, row);
                if (column >= block_.width) break;
                visit(column, row);
                if (asked_ && tracer_.in_order) refine();
            }
        return asked_;
    }

    /// Means of more samples follow the centres.
    EncodedColor now(std::size_t pixel) const
    {
        const std::uint32_t place = scratch_.places[pixel];
        return scratch_.samples[scratch_.marked[pixel] != 0 && place != kNoPlace ? place : pixel];
    }

    /// How many pixels from here on, by eights, visit() would find nothing in.
    int alike_from(int column, int row) const
    {
        const std::size_t here = index(column, row);
        if (scratch_.marked[here - 1] != 0) return 0;
        int count = 0;
        for (; column + count + 8 <= block_.width; count += 8) {
            const std::size_t at = here + static_cast<std::size_t>(count);
            if ((eight(scratch_.differing.data() + at) | eight(scratch_.marked.data() + at - stride_)) != 0) break;
        }
        return count;
    }

    void visit(int column, int row)
    {
        const std::size_t here = index(column, row), left = here - 1, up = here - stride_;
        const auto differs = [&](std::size_t other, Differs centre) {
            return scratch_.marked[other] != 0 ? distance_.differ(now(other), scratch_.samples[here])
                                               : (scratch_.differing[here] & centre) != 0;
        };
        const bool left_differs = differs(left, kLeft), up_differs = differs(up, kUp);
        if (left_differs && column > 0) want(left);
        if (up_differs && row > 0) want(up);
        if (left_differs || up_differs) want(here);
    }

    void want(std::size_t pixel)
    {
        scratch_.marked[pixel] = 1;
        if (scratch_.places[pixel] != kNoPlace) return;
        asked_ = true;
        if (tracer_.in_order) scratch_.refined.push_back(pixel);
    }

    /// More samples for the pixels that were asked for.
    void refine()
    {
        const int n = settings_.depth;
        if (!tracer_.in_order)
            for (const std::uint32_t pixel : scratch_.order)
                if (scratch_.marked[pixel] != 0 && scratch_.places[pixel] == kNoPlace)
                    scratch_.refined.push_back(pixel);
        add_positions(n);
        if (settings_.jitter > 0) jitter_positions(settings_.jitter / n);
        scratch_.sub_colors.resize(scratch_.sub_positions.size());
        tracer_.few(scratch_.sub_positions.data(), static_cast<int>(scratch_.sub_positions.size()),
                    scratch_.sub_colors.data());
        const scene::Color* next = scratch_.sub_colors.data();
        const std::size_t known = scratch_.samples.size();
        for (const std::size_t pixel : scratch_.refined) {
            scene::Color sum = scratch_.samples.colors[pixel];
            for (std::size_t i = 0; i < samples_of_pixel(); ++i) add(sum, *next++);
            scratch_.places[pixel] = static_cast<std::uint32_t>(scratch_.samples.size());
            scratch_.samples.colors.push_back(divided(sum, n * n + 1));
        }
        distance_.encode(scratch_.samples, known);
        scratch_.refined.clear();
        asked_ = false;
    }

    /// Of the refined pixels, before jitter.
    void add_positions(int n)
    {
        scratch_.nominal_positions.clear();
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column)
                scratch_.nominal_positions.emplace_back(-0.5 + (column + 0.5) / n, -0.5 + (row + 0.5) / n);
        scratch_.sub_positions.resize(scratch_.refined.size() * samples_of_pixel());
        SamplePosition* to = scratch_.sub_positions.data();
        for (const std::size_t pixel : scratch_.refined) {
            const SamplePosition centre(block_.left - 1 + static_cast<int>(pixel % stride_),
                                        block_.top - 1 + static_cast<int>(pixel / stride_));
            for (const SamplePosition& beside : scratch_.nominal_positions) *to++ = centre + beside;
        }
    }

    /// Moves the positions by what jitter gives for each.
    void jitter_positions(double amplitude)
    {
        constexpr std::size_t kAtOnce = 64;
        alignas(64) std::array<double, kAtOnce> x, y, by_x, by_y;
        std::vector<SamplePosition>& all = scratch_.sub_positions;
        for (std::size_t first = 0; first < all.size(); first += kAtOnce) {
            const std::size_t count = std::min(kAtOnce, all.size() - first);
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const SamplePosition& p = all[first + std::min(i, count - 1)];
                x[i] = p.x, y[i] = p.y;
            }
            jitter(x.data(), y.data(), static_cast<int>(count), by_x.data(), by_y.data());
            for (std::size_t i = 0; i < count; ++i) all[first + i] += amplitude * SamplePosition(by_x[i], by_y[i]);
        }
    }

    const plan::Antialiasing& settings_;
    const ColorDistance& distance_;
    const Block& block_;
    const SampleTracer& tracer_;
    AntialiasScratch& scratch_;
    std::size_t stride_;
    bool asked_ = false;  ///< for samples that are not known
};

}  // namespace

void antialias_1(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out)
{
    Method1(settings, distance, block, tracer, scratch).run(out);
}

}  // namespace trace
