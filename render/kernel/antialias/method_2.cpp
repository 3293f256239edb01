#include "render/kernel/antialias/methods.h"

#include "render/kernel/antialias/block_grid.h"
#include "render/kernel/antialias/jitter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

namespace trace {
namespace {

/// Method 2: a pixel is the mean of its corners, split in four while they differ. The squares of many pixels are looked
/// at level by level, so that the samples of a level fill tiles. Pixels that are divided alike share the samples
/// between them.
class Method2 {
public:
    Method2(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
            const SampleTracer& tracer, AntialiasScratch& scratch)
        : settings_(settings), distance_(distance), block_(block), tracer_(tracer), scratch_(scratch),
          amplitude_(settings.jitter / ((1 << settings.depth) + 1))
    {}

    void run(scene::Color* out)
    {
        const SampleGrid corners{{block_.left - 0.5, block_.top - 0.5}, block_.width + 1, block_.height + 1};
        trace_block_grid(corners, tracer_, scratch_);
        distance_.encode(scratch_.samples, 0);
        // As many pixels at a time as their squares, all of them divided, take a few megabytes.
        constexpr std::size_t kSquares = 16384, kMostPixels = 1024;
        const std::size_t at_once = tracer_.in_order ? 1
                                                     : std::clamp(kSquares >> std::min(30, 2 * (settings_.depth - 1)),
                                                                  std::size_t{1}, kMostPixels);
        order_cells(block_.width, block_.height, tracer_.in_order, scratch_);
        find_plain(out);
        const std::span<const std::uint32_t> pixels(scratch_.unsure);
        for (std::size_t first = 0; first < pixels.size(); first += at_once) {
            const auto now = pixels.subspan(first, std::min(at_once, pixels.size() - first));
            run(now, corners.count());
            for (std::size_t i = 0; i < now.size(); ++i) out[now[i]] = scratch_.squares[i].mean;
        }
    }

private:
    /// The pixels whose corners are surely alike get their means; the others are left for squares, in order.
    void find_plain(scene::Color* out)
    {
        const auto width = static_cast<std::size_t>(block_.width), stride = width + 1;
        const auto height = static_cast<std::size_t>(block_.height);
        const std::array<std::size_t, 4> corners{0, stride, 1, stride + 1};
        scratch_.differing.assign(width * height, 0);
        for (std::size_t row = 0; row < height; ++row) {
            std::uint8_t* unsure = scratch_.differing.data() + row * width;
            distance_.mark_unsure(scratch_.samples, row * stride, width, corners, 1, unsure);
            const scene::Color* at = scratch_.samples.colors.data() + row * stride;
            for (std::size_t i = 0; i < width; ++i)
                if (unsure[i] == 0) out[row * width + i] = mean(at[i], at[i + stride], at[i + 1], at[i + stride + 1]);
        }
        scratch_.unsure.clear();
        for (const std::uint32_t pixel : scratch_.order)
            if (scratch_.differing[pixel] != 0) scratch_.unsure.push_back(pixel);
    }

    static scene::Color mean(scene::Color sum, const scene::Color& b, const scene::Color& c, const scene::Color& d)
    {
        for (const scene::Color* more : {&b, &c, &d}) add(sum, *more);
        return divided(sum, 4);
    }

    /// Antialiases these pixels of the block, given by number. The first `corners` samples are those of the block's
    /// grid and stay; the others are replaced.
    void run(std::span<const std::uint32_t> pixels, std::size_t corners)
    {
        const auto width = static_cast<std::uint32_t>(block_.width), stride = width + 1;
        scratch_.samples.colors.resize(corners);
        scratch_.squares.clear();
        for (const std::uint32_t i : pixels) {
            const std::uint32_t row = i / width, column = i % width, at = row * stride + column;
            scratch_.squares.push_back({{block_.left + static_cast<int>(column), block_.top + static_cast<int>(row)},
                                        0.5,
                                        {at, at + stride, at + 1, at + stride + 1},
                                        i,
                                        0,
                                        {}});
        }
        std::size_t begin = 0;
        for (int level = settings_.depth - 1; level > 0 && begin < scratch_.squares.size(); --level) {
            const std::size_t end = scratch_.squares.size();
            divide(begin, end);
            begin = end;
        }
        for (std::size_t i = scratch_.squares.size(); i-- > 0;) {
            AntialiasSquare& square = scratch_.squares[i];
            const auto part = [&](std::size_t k) {
                return square.quarters != 0 ? scratch_.squares[square.quarters + k].mean
                                            : scratch_.samples.colors[square.corners[k]];
            };
            square.mean = mean(part(0), part(1), part(2), part(3));
        }
    }

    /// The squares that need it get quarters, and those their samples.
    void divide(std::size_t begin, std::size_t end)
    {
        scratch_.sub_positions.clear();
        scratch_.nominal_positions.clear();
        scratch_.sub_pixels.clear();
        scratch_.refined.clear();
        for (std::size_t i = begin; i < end; ++i)
            if (any_differ(scratch_.squares[i])) scratch_.refined.push_back(i);
        if (scratch_.refined.empty()) return;
        std::size_t room = 64;
        while (room < 16 * scratch_.refined.size()) room *= 2;  // five new samples a square, at most
        scratch_.places.assign(room, kNoPlace);
        const auto first_sample = static_cast<std::uint32_t>(scratch_.samples.size());
        for (const std::size_t i : scratch_.refined) quarter(i, first_sample);
        scratch_.samples.colors.resize(first_sample + scratch_.sub_positions.size());
        tracer_.few(scratch_.sub_positions.data(), static_cast<int>(scratch_.sub_positions.size()),
                    scratch_.samples.colors.data() + first_sample);
        scratch_.supersamples += scratch_.sub_positions.size();
        distance_.encode(scratch_.samples, first_sample);
    }

    void quarter(std::size_t i, std::uint32_t first_sample)
    {
        const AntialiasSquare square = scratch_.squares[i];
        const SamplePosition c = square.centre;
        const double half = square.half, q = half / 2;
        const auto inner = [&](double x, double y) { return first_sample + place_of(square.pixel, {x, y}); };
        const std::uint32_t left = inner(c.x - half, c.y), top = inner(c.x, c.y - half), right = inner(c.x + half, c.y),
                            bottom = inner(c.x, c.y + half), middle = inner(c.x, c.y);
        scratch_.squares[i].quarters = static_cast<std::uint32_t>(scratch_.squares.size());
        const auto add_quarter = [&](double x, double y, const std::array<std::uint32_t, 4>& corners) {
            scratch_.squares.push_back({c + SamplePosition(x, y), q, corners, square.pixel, 0, {}});
        };
        const auto& at = square.corners;
        add_quarter(-q, -q, {at[0], left, top, middle});
        add_quarter(-q, q, {left, at[1], middle, bottom});
        add_quarter(q, -q, {top, middle, at[2], right});
        add_quarter(q, q, {middle, bottom, right, at[3]});
    }

    /// The number of the sample at a position, asked for now if no square before has done so: squares share the samples
    /// of their edges.
    std::uint32_t place_of(std::uint32_t pixel, const SamplePosition& nominal)
    {
        // The low bits of such positions are empty, and a product's digits depend on those below alone.
        std::uint64_t hash = std::bit_cast<std::uint64_t>(nominal.x) * 0x9e3779b97f4a7c15u ^
                             std::bit_cast<std::uint64_t>(nominal.y);
        hash = (hash ^ hash >> 32) * 0xbf58476d1ce4e5b9u;
        const std::size_t mask = scratch_.places.size() - 1;
        for (std::size_t at = hash >> 32 & mask;; at = (at + 1) & mask) {
            std::uint32_t& place = scratch_.places[at];
            if (place == kNoPlace) {
                place = static_cast<std::uint32_t>(scratch_.sub_positions.size());
                scratch_.nominal_positions.push_back(nominal);
                scratch_.sub_pixels.push_back(pixel);
                scratch_.sub_positions.push_back(
                    settings_.jitter > 0 ? nominal + amplitude_ * jitter(nominal.x, nominal.y) : nominal);
                return place;
            }
            if (scratch_.nominal_positions[place] != nominal) continue;
            // Counted once for each pixel that asks; a pixel's squares ask one after the other.
            if (std::exchange(scratch_.sub_pixels[place], pixel) != pixel) ++scratch_.supersamples;
            return place;
        }
    }

    bool any_differ(const AntialiasSquare& square) const
    {
        const auto& at = square.corners;
        const auto& samples = scratch_.samples;
        const std::array<EncodedColor, 4> corners{samples[at[0]], samples[at[1]], samples[at[2]], samples[at[3]]};
        if (distance_.surely_alike(corners)) return false;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                if (distance_.differ(corners[i], corners[j])) return true;
        return false;
    }

    const plan::Antialiasing& settings_;
    const ColorDistance& distance_;
    const Block& block_;
    const SampleTracer& tracer_;
    AntialiasScratch& scratch_;
    double amplitude_;
};

}  // namespace

void antialias_2(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out)
{
    Method2(settings, distance, block, tracer, scratch).run(out);
}

}  // namespace trace
