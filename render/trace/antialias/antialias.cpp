#include "render/trace/antialias/antialias.h"

#include "render/trace/antialias/block_grid.h"
#include "render/trace/antialias/jitter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

namespace trace {
namespace {

/// Sums are kept in single precision after each step, as POV-Ray does.
void add(scene::Color& sum, const scene::Color& c)
{
    sum.red += c.red;
    sum.green += c.green;
    sum.blue += c.blue;
    sum.filter += c.filter;
    sum.transmit += c.transmit;
}

scene::Color divided(const scene::Color& sum, double by)
{
    const auto part = [by](float v) { return static_cast<float>(static_cast<double>(v) / by); };
    return {part(sum.red), part(sum.green), part(sum.blue), part(sum.filter), part(sum.transmit)};
}

constexpr std::uint32_t kNoPlace = 0xffffffffu;

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
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) {
                const std::size_t at = index(column, row);
                if (scratch_.marked[at] != 0) scratch_.supersamples += samples_of_pixel();
                *out++ = now(at).color;
            }
    }

private:
    enum Differs : std::uint8_t { kLeft = 1, kUp = 2 };

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
        scratch_.samples.clear();
        distance_.encode(scratch_.colors, scratch_.samples);
        order_cells(grid.columns, grid.rows, tracer_.in_order, scratch_);
    }

    void compare_centres()
    {
        const EncodedColor* samples = scratch_.samples.data();
        scratch_.differing.resize(scratch_.samples.size());
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) {
                const std::size_t here = index(column, row);
                const bool left = distance_.differ(samples[here - 1], samples[here]),
                           up = distance_.differ(samples[here - stride_], samples[here]);
                scratch_.differing[here] = static_cast<std::uint8_t>((left ? kLeft : 0) | (up ? kUp : 0));
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
                visit(column, row);
                if (asked_ && tracer_.in_order) refine();
            }
        return asked_;
    }

    /// Means of more samples follow the centres.
    const EncodedColor& now(std::size_t pixel) const
    {
        const std::uint32_t place = scratch_.places[pixel];
        return scratch_.samples[scratch_.marked[pixel] != 0 && place != kNoPlace ? place : pixel];
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
        scratch_.sub_positions.clear();
        if (!tracer_.in_order)
            for (const std::uint32_t pixel : scratch_.order)
                if (scratch_.marked[pixel] != 0 && scratch_.places[pixel] == kNoPlace)
                    scratch_.refined.push_back(pixel);
        for (const std::size_t pixel : scratch_.refined) add_positions(pixel, n);
        scratch_.sub_colors.resize(scratch_.sub_positions.size());
        tracer_.few(scratch_.sub_positions.data(), static_cast<int>(scratch_.sub_positions.size()),
                    scratch_.sub_colors.data());
        const scene::Color* next = scratch_.sub_colors.data();
        for (const std::size_t pixel : scratch_.refined) {
            scene::Color sum = scratch_.samples[pixel].color;
            for (std::size_t i = 0; i < samples_of_pixel(); ++i) add(sum, *next++);
            scratch_.places[pixel] = static_cast<std::uint32_t>(scratch_.samples.size());
            scratch_.samples.push_back(distance_.encoded(divided(sum, n * n + 1)));
        }
        scratch_.refined.clear();
        asked_ = false;
    }

    void add_positions(std::size_t pixel, int n)
    {
        const double amplitude = settings_.jitter / n;
        const SamplePosition centre(block_.left - 1 + static_cast<int>(pixel % stride_),
                                    block_.top - 1 + static_cast<int>(pixel / stride_));
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                SamplePosition p = centre + SamplePosition(-0.5 + (column + 0.5) / n, -0.5 + (row + 0.5) / n);
                if (settings_.jitter > 0) p += amplitude * jitter(p.x, p.y);
                scratch_.sub_positions.push_back(p);
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
        scratch_.samples.clear();
        distance_.encode(scratch_.colors, scratch_.samples);
        // As many pixels at a time as their squares, all of them divided, take a few megabytes.
        constexpr std::size_t kSquares = 16384, kMostPixels = 1024;
        const std::size_t at_once = tracer_.in_order ? 1
                                                     : std::clamp(kSquares >> std::min(30, 2 * (settings_.depth - 1)),
                                                                  std::size_t{1}, kMostPixels);
        order_cells(block_.width, block_.height, tracer_.in_order, scratch_);
        const std::span<const std::uint32_t> pixels(scratch_.order);
        for (std::size_t first = 0; first < pixels.size(); first += at_once) {
            const auto now = pixels.subspan(first, std::min(at_once, pixels.size() - first));
            run(now, corners.count());
            for (std::size_t i = 0; i < now.size(); ++i) out[now[i]] = scratch_.squares[i].mean;
        }
    }

private:
    /// Pixels of the block by number; `corners` samples are kept.
    void run(std::span<const std::uint32_t> pixels, std::size_t corners)
    {
        const auto width = static_cast<std::uint32_t>(block_.width), stride = width + 1;
        scratch_.samples.resize(corners);
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
                                            : scratch_.samples[square.corners[k]].color;
            };
            scene::Color sum = part(0);
            for (std::size_t k = 1; k < 4; ++k) add(sum, part(k));
            square.mean = divided(sum, 4);
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
        scratch_.sub_colors.resize(scratch_.sub_positions.size());
        tracer_.few(scratch_.sub_positions.data(), static_cast<int>(scratch_.sub_positions.size()),
                    scratch_.sub_colors.data());
        scratch_.supersamples += scratch_.sub_positions.size();
        distance_.encode(scratch_.sub_colors, scratch_.samples);
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

    /// Which of the samples asked for lies there: squares share those of their edges.
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
            // A pixel's squares ask one after the other.
            if (std::exchange(scratch_.sub_pixels[place], pixel) != pixel) ++scratch_.supersamples;
            return place;
        }
    }

    bool any_differ(const AntialiasSquare& square) const
    {
        const auto& at = square.corners;
        const auto& samples = scratch_.samples;
        if (distance_.surely_alike({&samples[at[0]], &samples[at[1]], &samples[at[2]], &samples[at[3]]})) return false;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                if (distance_.differ(scratch_.samples[square.corners[i]], scratch_.samples[square.corners[j]]))
                    return true;
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

void antialias(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma, const Block& block,
               const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out)
{
    if (settings.method == 0) {
        tracer.grid({{block.left, block.top}, block.width, block.height}, out);
        return;
    }
    const ColorDistance distance(settings, gamma);
    if (settings.method == 1) Method1(settings, distance, block, tracer, scratch).run(out);
    else Method2(settings, distance, block, tracer, scratch).run(out);
}

}  // namespace trace
