#include "render/picture/sampling/denoise.h"

#include "numbers/functions/functions.h"
#include "render/picture/threads.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {
namespace {

// An a-trous wavelet filter (Dammertz et al. 2010) whose edges are those of normals, depth and albedo, and of light as
// far as its variance allows (Schied et al., "Spatiotemporal variance-guided filtering", 2017).
constexpr int kLevels = 5;           // the last reaches 2^6 pixels to each side
constexpr float kDepthSteps = 1.5f;  // slopes of the depth that two places of one surface may be apart
constexpr float kAlbedoWidth = 0.15f;
constexpr float kLightSigmas = 3.0f;  // standard deviations of light that may be noise
constexpr std::uint32_t kFewest = 4;  // samples of a pixel that tell of their own spread
constexpr float kDarkest = 0.02f;     // least albedo that light is divided by

/// What the filter goes by, and what it works on: light without the colour of the surface.
struct Place {
    glm::vec3 light{0}, albedo{1}, normal{0};
    float variance = 0, depth = 0, slope = 0;
    bool held = false;
};

float bright(const glm::vec3& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// The 64th power of the cosine between normals.
float normal_share(float cosine)
{
    for (int k = 0; k < 6; ++k) cosine *= cosine;
    return cosine;
}

class Filter {
    template <class Places>
    auto& at(Places& places, int x, int y) const
    {
        return places[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    }
    template <class F>
    void rows(F&& f) const
    {
        threads_.each(0, static_cast<std::size_t>(height_), [&](std::size_t y, int) { f(static_cast<int>(y)); });
    }

public:
    Filter(const SampledPicture& samples, const PathFeatures& features, int threads)
        : threads_(threads_of(threads)), width_(samples.width()), height_(samples.height()),
          places_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))
    {
        rows([&](int y) {
            for (int x = 0; x < width_; ++x) read(samples, features, x, y);
        });
        rows([&](int y) {
            for (int x = 0; x < width_; ++x) at(places_, x, y).slope = slope_at(x, y);
        });
        rows([&](int y) {
            for (int x = 0; x < width_; ++x)
                if (samples.at(x, y).count < kFewest) at(places_, x, y).variance = variance_of_neighbours(x, y);
        });
    }

    void run()
    {
        std::vector<Place> next = places_;
        smooth_variance(next);
        for (int level = 0; level < kLevels; ++level) {
            rows([&](int y) {
                for (int x = 0; x < width_; ++x) pass(x, y, 1 << level, at(next, x, y));
            });
            places_.swap(next);
        }
    }

    void show(image::Image& image) const
    {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const Place& place = at(places_, x, y);
                if (!place.held) continue;
                const glm::vec3 color = place.light * place.albedo;
                float* const to = image.at(x, y);
                for (int k = 0; k < 3; ++k) to[k] = color[k];
            }
    }

private:
    void read(const SampledPicture& samples, const PathFeatures& features, int x, int y)
    {
        const SampledPicture::Pixel& pixel = samples.at(x, y);
        if (pixel.count == 0) return;
        const PathFeatures::Pixel& seen = features.sum(x, y);
        const auto n = static_cast<float>(pixel.count);
        Place& to = at(places_, x, y);
        to.held = true;
        to.albedo = glm::max(glm::vec3(kDarkest), seen.albedo / n);
        to.normal = seen.normal / n;
        to.depth = seen.depth / n;
        constexpr std::array<double, 3> kShares{0.2126, 0.7152, 0.0722};
        double spread = 0.0;  // standard deviations of colours add up: their noise is the same
        for (std::size_t k = 0; k < 3; ++k) {
            const auto albedo = static_cast<double>(to.albedo[static_cast<int>(k)]);
            to.light[static_cast<int>(k)] = static_cast<float>(pixel.mean(k) / albedo);
            spread += kShares[k] * std::sqrt(pixel.spread(k)) / albedo;
        }
        const double freedom = std::max(pixel.count - 1.0, 1.0);
        to.variance = static_cast<float>(spread * spread / (freedom * pixel.count));
    }

    /// Depth from pixel to pixel; of two sides the flatter, as the other may be an edge.
    float slope_at(int x, int y) const
    {
        const Place& own = at(places_, x, y);
        const auto step = [&](int dx, int dy) {
            float least = 1e30f;
            for (const int side : {-1, 1}) {
                const int u = x + side * dx, v = y + side * dy;
                if (u < 0 || v < 0 || u >= width_ || v >= height_ || !at(places_, u, v).held) continue;
                least = std::min(least, std::abs(at(places_, u, v).depth - own.depth));
            }
            return least < 1e30f ? least : 0.0f;
        };
        return std::max(step(1, 0), step(0, 1));
    }

    /// Few samples tell little of their own spread: the pixels around tell of it too.
    void smooth_variance(std::vector<Place>& scratch)
    {
        rows([&](int y) {
            for (int x = 0; x < width_; ++x) at(scratch, x, y).variance = variance_around(x, y);
        });
        places_ = scratch;
    }

    float variance_around(int x, int y) const
    {
        const Place& own = at(places_, x, y);
        float sum = 0.0f, weights = 0.0f;
        for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) {
                const Place& other = at(places_, u, v);
                if (!other.held) continue;
                const float w = (u == x ? 2.0f : 1.0f) * (v == y ? 2.0f : 1.0f) * alike(own, other, 1.0f);
                sum += w * other.variance;
                weights += w;
            }
        return weights > 0.0f ? sum / weights : own.variance;
    }

    /// Of light from pixel to pixel of the same surface, where a pixel's own samples are too few to tell.
    float variance_of_neighbours(int x, int y) const
    {
        constexpr int kReach = 3;
        const Place& own = at(places_, x, y);
        float weights = 0.0f, sum = 0.0f, squares = 0.0f;
        for (int v = std::max(0, y - kReach); v <= std::min(height_ - 1, y + kReach); ++v)
            for (int u = std::max(0, x - kReach); u <= std::min(width_ - 1, x + kReach); ++u) {
                const Place& other = at(places_, u, v);
                if (!other.held) continue;
                const float w = alike(own, other, numbers::hypot(static_cast<float>(u - x), static_cast<float>(v - y)));
                const float light = bright(other.light);
                weights += w;
                sum += w * light;
                squares += w * light * light;
            }
        return weights > 0.0f ? std::max(0.0f, squares / weights - sum * sum / (weights * weights)) : 0.0f;
    }

    /// Whether two places are of one surface, 0 to 1. apart: in pixels
    static float alike(const Place& a, const Place& b, float apart)
    {
        const float cosine = glm::dot(a.normal, b.normal), sizes = glm::dot(a.normal, a.normal);
        const bool sky = sizes < 1e-6f, other_sky = glm::dot(b.normal, b.normal) < 1e-6f;
        if (sky != other_sky) return 0.0f;
        const float normal = sky ? 1.0f : normal_share(std::clamp(cosine / std::max(sizes, 1e-6f), 0.0f, 1.0f));
        const float depth = std::abs(a.depth - b.depth) / (kDepthSteps * a.slope * apart + 1e-3f * a.depth + 1e-12f);
        const glm::vec3 color = a.albedo - b.albedo;
        return normal * numbers::exp(-depth - glm::dot(color, color) / (kAlbedoWidth * kAlbedoWidth));
    }

    void pass(int x, int y, int step, Place& out) const
    {
        constexpr std::array<float, 3> kSpline{3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f};
        const Place& own = at(places_, x, y);
        out = own;
        if (!own.held) return;
        const float noise = kLightSigmas * std::sqrt(variance_around(x, y)) + 1e-6f, here = bright(own.light);
        glm::vec3 light(0);
        float weights = 0.0f, variance = 0.0f;
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) {
                const int u = x + i * step, v = y + j * step;
                if (u < 0 || v < 0 || u >= width_ || v >= height_) continue;
                const Place& other = at(places_, u, v);
                if (!other.held) continue;
                float w = kSpline[static_cast<std::size_t>(std::abs(i))] *
                          kSpline[static_cast<std::size_t>(std::abs(j))];
                if (i != 0 || j != 0) {
                    const float apart = numbers::hypot(static_cast<float>(u - x), static_cast<float>(v - y));
                    w *= alike(own, other, apart) * numbers::exp(-std::abs(bright(other.light) - here) / noise);
                }
                light += w * other.light;
                variance += w * w * other.variance;
                weights += w;
            }
        out.light = light / weights;
        out.variance = variance / (weights * weights);
    }

    mutable Threads threads_;
    int width_, height_;
    std::vector<Place> places_;
};

}  // namespace

void denoise(const SampledPicture& samples, const PathFeatures& features, int threads, image::Image& image)
{
    samples.show(image);
    Filter filter(samples, features, threads);
    filter.run();
    filter.show(image);
}

}  // namespace trace
