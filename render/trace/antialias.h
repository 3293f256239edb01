#pragma once

#include "render/trace/blocks.h"
#include "render/scene/color.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

/// POV-Ray's two ways of adding samples where the picture is not smooth (reference manual 3.2.8.7; spec 2, section 8).
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
    void (*trace_grid)(void* context, const SampleGrid& grid, scene::Color* out);
    void (*trace_few)(void* context, const SamplePosition* positions, int count, scene::Color* out);
    void* context;
    void grid(const SampleGrid& g, scene::Color* out) const { trace_grid(context, g, out); }
    void few(const SamplePosition* positions, int count, scene::Color* out) const
    {
        trace_few(context, positions, count, out);
    }
};

/// Working storage of one thread; reused from block to block.
struct AntialiasScratch {
    std::vector<scene::Color> colors;      ///< the block with a border of one pixel (method 1) or its corners (method 2)
    std::vector<std::uint8_t> marked;      ///< method 1: supersampled or never to be
    std::vector<SamplePosition> sub_positions;
    std::vector<scene::Color> sub_colors;
    std::uint64_t supersamples = 0;        ///< samples beyond the first of each pixel, added up
};

/// How different two colours look: spec 2, 8.1.
class ColorDistance {
public:
    ColorDistance(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma);
    bool differ(const scene::Color& a, const scene::Color& b) const;

private:
    float encode(float value) const;
    double exponent_;
    double threshold_;
    bool srgb_;
    bool identity_;
};

/// Colours of the block's pixels, row by row, into `out` (width * height of them). `method` 0 takes one sample a pixel.
void antialias(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma, const Block& block,
               const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out);

}  // namespace trace
