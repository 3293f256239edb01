#include "render/trace/antialias.h"

#include "render/trace/jitter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {
namespace {

/// Exponents this close to 1 count as 1, and then negative values are kept (spec 2, 8.1).
constexpr double kIdentityExponent = 0.01;

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

/// Method 1: centre samples of the block and of the row above and the column left of it, then a scan in reading order
/// that refines a pixel and its neighbour wherever the two differ.
class Method1 {
public:
    Method1(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
            const SampleTracer& tracer, AntialiasScratch& scratch)
        : settings_(settings), distance_(distance), block_(block), tracer_(tracer), scratch_(scratch),
          stride_(static_cast<std::size_t>(block.width) + 1)
    {
    }

    void run(scene::Color* out)
    {
        trace_centres();
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) visit(column, row);
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) *out++ = scratch_.colors[index(column, row)];
    }

private:
    /// -1 is the border on the left or above.
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row + 1) * stride_ + static_cast<std::size_t>(column + 1);
    }

    void trace_centres()
    {
        const SampleGrid grid{{block_.left - 1, block_.top - 1}, block_.width + 1, block_.height + 1};
        scratch_.colors.resize(grid.count());
        scratch_.marked.assign(grid.count(), 0);
        for (int column = -1; column < block_.width; ++column) scratch_.marked[index(column, -1)] = 1;
        for (int row = 0; row < block_.height; ++row) scratch_.marked[index(-1, row)] = 1;
        tracer_.grid(grid, scratch_.colors.data());
    }

    void visit(int column, int row)
    {
        const std::size_t here = index(column, row), left = here - 1, up = here - stride_;
        const bool left_differs = distance_.differ(scratch_.colors[left], scratch_.colors[here]);
        const bool up_differs = distance_.differ(scratch_.colors[up], scratch_.colors[here]);
        if (left_differs) refine(left);
        if (up_differs) refine(up);
        if (left_differs || up_differs) refine(here);
    }

    void refine(std::size_t pixel)
    {
        if (scratch_.marked[pixel] != 0) return;
        scratch_.marked[pixel] = 1;
        const int n = settings_.depth;
        const double amplitude = settings_.jitter / n;
        const SamplePosition centre(block_.left - 1 + static_cast<int>(pixel % stride_),
                                    block_.top - 1 + static_cast<int>(pixel / stride_));
        scratch_.sub_positions.clear();
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                SamplePosition p = centre + SamplePosition(-0.5 + (column + 0.5) / n, -0.5 + (row + 0.5) / n);
                if (settings_.jitter > 0) p += amplitude * jitter(p.x, p.y);
                scratch_.sub_positions.push_back(p);
            }
        scratch_.sub_colors.resize(scratch_.sub_positions.size());
        tracer_.few(scratch_.sub_positions.data(), n * n, scratch_.sub_colors.data());
        scratch_.supersamples += static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
        scene::Color sum = scratch_.colors[pixel];
        for (const scene::Color& c : scratch_.sub_colors) add(sum, c);
        scratch_.colors[pixel] = divided(sum, n * n + 1);
    }

    const plan::Antialiasing& settings_;
    const ColorDistance& distance_;
    const Block& block_;
    const SampleTracer& tracer_;
    AntialiasScratch& scratch_;
    std::size_t stride_;
};

/// Method 2: a pixel is the mean of its corners, split in four while they differ.
class Method2 {
public:
    Method2(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
            const SampleTracer& tracer, AntialiasScratch& scratch)
        : settings_(settings), distance_(distance), block_(block), tracer_(tracer), scratch_(scratch),
          amplitude_(settings.jitter / ((1 << settings.depth) + 1))
    {
    }

    void run(scene::Color* out)
    {
        const std::size_t stride = static_cast<std::size_t>(block_.width) + 1;
        const SampleGrid corners{{block_.left - 0.5, block_.top - 0.5}, block_.width + 1, block_.height + 1};
        scratch_.colors.resize(corners.count());
        tracer_.grid(corners, scratch_.colors.data());
        for (int row = 0; row < block_.height; ++row)
            for (int column = 0; column < block_.width; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column);
                known_positions_.clear();
                known_colors_.clear();
                *out++ = square({block_.left + column, block_.top + row}, 0.5,
                                {scratch_.colors[at], scratch_.colors[at + stride], scratch_.colors[at + 1],
                                 scratch_.colors[at + stride + 1]},
                                settings_.depth - 1);
            }
    }

private:
    using Corners = std::array<scene::Color, 4>;  ///< top left, bottom left, top right, bottom right

    static scene::Color mean(const Corners& c)
    {
        scene::Color sum = c[0];
        for (std::size_t i = 1; i < 4; ++i) add(sum, c[i]);
        return divided(sum, 4);
    }

    bool any_differ(const Corners& c) const
    {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                if (distance_.differ(c[i], c[j])) return true;
        return false;
    }

    /// A point inside the pixel, traced once however many squares share it.
    scene::Color inner(const SamplePosition& nominal)
    {
        for (std::size_t i = 0; i < known_positions_.size(); ++i)
            if (known_positions_[i] == nominal) return known_colors_[i];
        SamplePosition p = nominal;
        if (settings_.jitter > 0) p += amplitude_ * jitter(nominal.x, nominal.y);
        scene::Color color;
        tracer_.few(&p, 1, &color);
        ++scratch_.supersamples;
        known_positions_.push_back(nominal);
        known_colors_.push_back(color);
        return color;
    }

    scene::Color square(const SamplePosition& centre, double half, const Corners& corner, int level)
    {
        if (level <= 0 || !any_differ(corner)) return mean(corner);
        const scene::Color left = inner({centre.x - half, centre.y}), top = inner({centre.x, centre.y - half});
        const scene::Color right = inner({centre.x + half, centre.y}), bottom = inner({centre.x, centre.y + half});
        const scene::Color middle = inner(centre);
        const double q = half / 2;
        return mean({square(centre + SamplePosition(-q, -q), q, {corner[0], left, top, middle}, level - 1),
                     square(centre + SamplePosition(-q, q), q, {left, corner[1], middle, bottom}, level - 1),
                     square(centre + SamplePosition(q, -q), q, {top, middle, corner[2], right}, level - 1),
                     square(centre + SamplePosition(q, q), q, {middle, bottom, right, corner[3]}, level - 1)});
    }

    const plan::Antialiasing& settings_;
    const ColorDistance& distance_;
    const Block& block_;
    const SampleTracer& tracer_;
    AntialiasScratch& scratch_;
    double amplitude_;
    std::vector<SamplePosition>& known_positions_ = scratch_.sub_positions;
    std::vector<scene::Color>& known_colors_ = scratch_.sub_colors;
};

}  // namespace

ColorDistance::ColorDistance(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma)
    : threshold_(static_cast<double>(static_cast<float>(settings.threshold))),
      srgb_(gamma.kind == scene::AssumedGamma::Kind::Srgb)
{
    const double display = settings.gamma > 0 ? settings.gamma : 1.0;
    const double working = gamma.kind == scene::AssumedGamma::Kind::Power ? gamma.exponent : 1.0;
    exponent_ = working / display;
    identity_ = !srgb_ && std::abs(exponent_ - 1.0) <= kIdentityExponent;
}

float ColorDistance::encode(float value) const
{
    if (identity_) return value;
    double v = static_cast<double>(value);
    if (srgb_) v = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    return static_cast<float>(std::pow(std::max(v, 0.0), exponent_));
}

bool ColorDistance::differ(const scene::Color& a, const scene::Color& b) const
{
    if (a == b) return threshold_ <= 0;
    const float d = std::abs(encode(a.red) - encode(b.red)) + std::abs(encode(a.green) - encode(b.green)) +
                    std::abs(encode(a.blue) - encode(b.blue)) + std::abs(a.transmit - b.transmit);
    return static_cast<double>(d) >= threshold_;
}

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
