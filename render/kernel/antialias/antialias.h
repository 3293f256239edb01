#pragma once

#include "render/kernel/antialias/color_distance.h"
#include "render/kernel/tile/block.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

/// POV-Ray's ways of adding samples where the picture is not smooth (reference manual 3.2.8.7; spec 2, section 8; spec
/// 7, 3.2).
namespace trace {

/// A pixel's centre is (column, row); positions grow to the right and downwards.
using SamplePosition = glm::dvec2;

/// Samples one pixel apart: columns x rows of them from `first` on, row by row.
struct SampleGrid {
    SamplePosition first{0};
    int columns = 0, rows = 0;
    std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// Traces samples: a whole grid, which can go in tiles, or a few that lie anywhere. Functions and their context, so
/// that a block costs no allocation.
struct SampleTracer {
    /// \param stride  colours from one row to the next
    void (*trace_grid)(void* context, const SampleGrid& grid, scene::Color* out, std::size_t stride);
    void (*trace_few)(void* context, const SamplePosition* positions, int count, scene::Color* out);
    void* context;
    bool in_order = false;  ///< no sample before the picture is known to need it: each takes the next random numbers
    void grid(const SampleGrid& g, scene::Color* out) const { grid(g, out, static_cast<std::size_t>(g.columns)); }
    void grid(const SampleGrid& g, scene::Color* out, std::size_t stride) const { trace_grid(context, g, out, stride); }
    void few(const SamplePosition* positions, int count, scene::Color* out) const
    {
        trace_few(context, positions, count, out);
    }
};

/// A square of a pixel, by method 2: its corners are samples, and so are its four quarters' if they are not plain.
struct AntialiasSquare {
    SamplePosition centre{0};
    double half = 0.5;
    std::array<std::uint32_t, 4> corners{};  ///< samples: top left, bottom left, top right, bottom right
    std::uint32_t pixel = 0;
    std::uint32_t quarters = 0;  ///< the first of four squares; 0: not divided
    scene::Color mean{};
};

/// Samples that blocks have in common with those on their right and below, by the thread that traced them.
struct BlockEdges {
    SamplePosition right{0};                 ///< the uppermost of the last block's last column
    std::vector<scene::Color> right_colors;  ///< from there down
    struct Below {
        double row = -1e9;
        scene::Color color;
    };
    std::vector<Below> below;  ///< by column: of the last row that a block ended with
};

/// Working storage of one thread; reused from block to block.
struct AntialiasScratch {
    /// Of the block with a border of one pixel (method 1) or its corners (method 2), then refined pixels or what lies
    /// within.
    EncodedColors samples;
    std::vector<std::uint8_t>
        differing;                     ///< method 1: from which neighbours, by centre samples; method 2: 1: corners may
    std::vector<std::uint8_t> marked;  ///< method 1: supersampled
    std::vector<std::size_t> refined;  ///< pixels that get more samples now (method 1), squares to divide (method 2)
    std::vector<AntialiasSquare> squares;
    std::vector<std::uint32_t> places;  ///< method 1: of a pixel's refined colour in `samples`; method 2: samples asked
                                        ///< for now, by a hash of their positions
    std::vector<std::uint32_t> sub_pixels;      ///< method 2: that asked last for each of sub_positions
    std::vector<std::uint32_t> order;           ///< a block's cells, neighbours in the picture side by side
    std::vector<std::uint32_t> unsure;          ///< method 2: cells whose corners may differ, in that order
    int ordered_columns = 0, ordered_rows = 0;  ///< of this block
    std::vector<SamplePosition> sub_positions, nominal_positions;  ///< asked for now; before jitter, or (method 1)
                                                                   ///< those about a pixel's centre
    std::vector<scene::Color> sub_colors;
    BlockEdges edges;
    std::uint64_t supersamples = 0;  ///< samples beyond the first of each pixel, added up; shared ones count for each
};

/// Colours of the block's pixels, row by row, into `out` (width * height of them). `method` 0 takes one sample a pixel.
void antialias(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma, const Block& block,
               const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out);

}  // namespace trace
