#include "render/kernel/antialias/methods.h"

#include "numbers/random.h"
#include "render/plan/textures/chi_square.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {
namespace {

/// Samples of one pixel: their sum, and sums and squares of the components as differences see them.
struct PixelSums {
    glm::dvec3 rgb{0};
    double filter = 0.0, transmit = 0.0;
    std::array<double, 4> seen{}, squares{};
    std::uint32_t count = 0;
};

/// Method 3 of POV-Ray 3.8: passes of one random sample in each pixel that is not sure yet (spec 7, 3.2). A pixel is
/// sure when its samples and those of its four neighbours, taken together, leave an error of at most the threshold with
/// the confidence that was asked for. Neighbours in other blocks are not asked: a block is made alone. What goes on in
/// one pixel may make its neighbours unsure again.
class Method3 {
public:
    Method3(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
            const SampleTracer& tracer, AntialiasScratch& scratch)
        : distance_(distance), block_(block), tracer_(tracer), scratch_(scratch), threshold_(settings.threshold),
          bound_(std::sqrt(plan::chi_square(1, 1.0 - settings.confidence))), most_(1u << 2 * settings.depth),
          seed_(settings.seed)
    {}

    void run(scene::Color* out)
    {
        const auto pixels = static_cast<std::size_t>(block_.width) * static_cast<std::size_t>(block_.height);
        sums_.assign(pixels, {});
        std::vector<std::uint32_t>& unsure = scratch_.unsure;
        unsure.resize(pixels);
        for (std::uint32_t i = 0; i < pixels; ++i) unsure[i] = i;
        while (!unsure.empty()) {
            sample(unsure);
            choose(unsure);
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            const PixelSums& s = sums_[i];
            const double n = s.count;
            out[i] = {static_cast<float>(s.rgb.r / n), static_cast<float>(s.rgb.g / n), static_cast<float>(s.rgb.b / n),
                      static_cast<float>(s.filter / n), static_cast<float>(s.transmit / n)};
            scratch_.supersamples += s.count - 1;
        }
    }

private:
    /// One sample more in each of these.
    void sample(const std::vector<std::uint32_t>& pixels)
    {
        std::vector<SamplePosition>& places = scratch_.sub_positions;
        places.clear();
        for (const std::uint32_t pixel : pixels) {
            const SamplePosition centre = place(pixel);
            const std::uint64_t own = numbers::stirred((seed_ << 48) ^ (static_cast<std::uint64_t>(centre.y) << 24) ^
                                                       static_cast<std::uint64_t>(centre.x));
            const std::uint32_t n = sums_[pixel].count;
            places.push_back(centre + SamplePosition(numbers::random_of(own, n, 0), numbers::random_of(own, n, 1)) -
                             0.5);
        }
        EncodedColors& samples = scratch_.samples;
        samples.colors.resize(places.size());
        tracer_.few(places.data(), static_cast<int>(places.size()), samples.colors.data());
        distance_.encode(samples, 0);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            PixelSums& s = sums_[pixels[i]];
            const scene::Color& c = samples.colors[i];
            s.rgb += glm::dvec3(c.rgb());
            s.filter += static_cast<double>(c.filter);
            s.transmit += static_cast<double>(c.transmit);
            const std::array<float, 4> seen{samples.red[i], samples.green[i], samples.blue[i], samples.transmit[i]};
            for (std::size_t k = 0; k < seen.size(); ++k) {
                const auto v = static_cast<double>(seen[k]);
                s.seen[k] += v;
                s.squares[k] += v * v;
            }
            ++s.count;
        }
    }

    /// Which pixels go on: among those that got a sample and their neighbours, for the others are as sure as before.
    void choose(std::vector<std::uint32_t>& pixels)
    {
        asked_.assign(sums_.size(), 0);
        for (const std::uint32_t pixel : pixels) around(pixel, [&](std::uint32_t near) { asked_[near] = 1; });
        pixels.clear();
        for (std::uint32_t i = 0; i < asked_.size(); ++i)
            if (asked_[i] != 0 && sums_[i].count < most_ && !sure(i)) pixels.push_back(i);
    }

    bool sure(std::uint32_t pixel) const
    {
        PixelSums all;
        around(pixel, [&](std::uint32_t near) {
            const PixelSums& s = sums_[near];
            all.count += s.count;
            for (std::size_t k = 0; k < all.seen.size(); ++k) all.seen[k] += s.seen[k], all.squares[k] += s.squares[k];
        });
        if (all.count < 2) return false;
        const double n = all.count;
        double deviations = 0.0;  // of the mean, added up over the components
        for (std::size_t k = 0; k < all.seen.size(); ++k) {
            const double variance = (all.squares[k] - all.seen[k] * all.seen[k] / n) / (n - 1.0);
            constexpr double kRoundings = 1e-13;  // of sums of thousands of squares: samples that are all alike
            if (variance > kRoundings * all.squares[k] / n) deviations += std::sqrt(variance / n);
        }
        return !(bound_ * deviations > threshold_);
    }

    /// For a pixel and those at its sides.
    template <class Do>
    void around(std::uint32_t pixel, Do&& act) const
    {
        const auto width = static_cast<std::uint32_t>(block_.width);
        const std::uint32_t column = pixel % width;
        act(pixel);
        if (column > 0) act(pixel - 1);
        if (column + 1 < width) act(pixel + 1);
        if (pixel >= width) act(pixel - width);
        if (pixel + width < sums_.size()) act(pixel + width);
    }

    SamplePosition place(std::uint32_t pixel) const
    {
        const auto width = static_cast<std::uint32_t>(block_.width);
        return {block_.left + static_cast<int>(pixel % width), block_.top + static_cast<int>(pixel / width)};
    }

    const ColorDistance& distance_;
    const Block& block_;
    const SampleTracer& tracer_;
    AntialiasScratch& scratch_;
    double threshold_;
    double bound_;        ///< deviations of a normal variable on both sides that the confidence stands for
    std::uint32_t most_;  ///< samples of a pixel
    std::uint64_t seed_;
    std::vector<PixelSums> sums_;
    std::vector<std::uint8_t> asked_;
};

}  // namespace

void antialias_3(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out)
{
    Method3(settings, distance, block, tracer, scratch).run(out);
}

}  // namespace trace
