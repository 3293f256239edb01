#include "render/kernel/camera/focal_blur.h"

#include "numbers/functions/functions.h"
#include "numbers/lanes.h"
#include "render/texture/evaluate.h"
#include "render/plan/textures/chi_square.h"
#include "render/kernel/antialias/jitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace trace {
namespace {

constexpr std::array<glm::dvec2, 67> kLens = {{
#include "render/kernel/camera/lens_table.inc"
}};

struct LensSet {
    int size;
    std::size_t first;  ///< in kLens
    double amplitude;   ///< of the jitter around a place; 0: by the number of samples
};
constexpr std::array<LensSet, 4> kSets = {{{37, 30, 0.0721688}, {19, 11, 0.096225}, {7, 4, 0.144338}, {4, 0, 0.0}}};

constexpr int kLaterBatch = 4;

/// The largest set that the samples hold; of 4 for fewer than 7.
const LensSet& set_of(int samples)
{
    for (const LensSet& set : kSets)
        if (samples >= set.size) return set;
    return kSets.back();
}

/// Of 16 steps across a pixel, from its centre.
double step(std::uint32_t k) { return (2.0 * k + 1.0) / 32.0 - 0.5; }

/// k + 1 mirrored at the point in a number system (Halton 1964).
double radical_inverse(int base, int k)
{
    double result = 0.0, place = 1.0;
    for (int i = k + 1; i > 0; i /= base) {
        place /= base;
        result += place * (i % base);
    }
    return result;
}

}  // namespace

FocalBlur::FocalBlur(const scene::Camera& camera, const texture::TextureSet& textures, std::uint32_t bokeh)
    : samples_(camera.aperture != 0.0 ? std::max(0, camera.blur_samples) : 0), fewest_(camera.blur_fewest),
      radius_(camera.aperture / 2.0), row_(camera.povray == scene::PovRay::V38 ? 0.5 : -0.5), location_(camera.location)
{
    if (!active()) return;
    const glm::dvec3& d = camera.direction;
    focal_ratio_ = camera.focal_distance / glm::length(d);
    right_ = glm::normalize(glm::cross(camera.up, d));
    up_ = glm::normalize(glm::cross(d, right_));
    amplitude_ = 0.5 / std::sqrt(static_cast<double>(samples_));
    if (bokeh != texture::kNone) {
        place_by_brightness(textures, bokeh);
    } else {
        const LensSet& set = set_of(samples_);
        set_ = set.size;
        if (samples_ == set.size && set.amplitude > 0.0) amplitude_ = set.amplitude;
        const int fixed = std::min(set.size, samples_);
        places_.assign(kLens.begin() + static_cast<std::ptrdiff_t>(set.first),
                       kLens.begin() + static_cast<std::ptrdiff_t>(set.first) + fixed);
        place_further_samples();
    }
    for (std::uint32_t k = 0; k < 256; ++k) moves_.push_back((jitter(step(k / 16), step(k % 16)) - 0.5) / 16.0);
    thresholds_.assign(static_cast<std::size_t>(samples_) + 1, 0.0);
    if (samples_ < 2) return;
    const double last = plan::chi_square(samples_ - 1, camera.confidence);
    for (int n = 1; n <= samples_; ++n)
        thresholds_[static_cast<std::size_t>(n)] = camera.variance * plan::chi_square(n, camera.confidence) / last;
}

/// One in each cell of a grid, as long as the budget of draws lasts.
void FocalBlur::place_further_samples()
{
    const int side = 2 * static_cast<int>(std::ceil(std::sqrt(samples_ / std::numbers::pi))) + 1;
    std::vector<bool> occupied(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    const auto cell_of = [&](const glm::dvec2& g) {
        const auto at = [&](double v) {
            return static_cast<std::size_t>(std::clamp(static_cast<int>((v + 0.5) * side), 0, side - 1));
        };
        return at(g.y) * static_cast<std::size_t>(side) + at(g.x);
    };
    for (const glm::dvec2& g : places_) occupied[cell_of(g)] = true;
    int budget = 10 * samples_;
    for (int k = 0; static_cast<int>(places_.size()) < samples_;) {
        const double r = std::sqrt(0.25 * radical_inverse(2, k)),
                     angle = 2.0 * std::numbers::pi * radical_inverse(3, k);
        const glm::dvec2 g{r * numbers::cos(angle), r * numbers::sin(angle)};
        ++k;
        --budget;
        const bool picky = budget > samples_ - static_cast<int>(places_.size());
        if (picky && (occupied[cell_of(g)] || glm::length(g) > 0.5)) continue;
        occupied[cell_of(g)] = true;
        places_.push_back(g);
    }
}

/// The brighter the pigment, the sooner a place is taken; the longer it takes, the less it asks for.
void FocalBlur::place_by_brightness(const texture::TextureSet& set, std::uint32_t bokeh)
{
    std::mt19937 generator;
    generator();  // POV-Ray's first number is never used
    const double patience = static_cast<double>(samples_) * samples_;
    for (int k = 0; static_cast<int>(places_.size()) < samples_; ++k) {
        const glm::dvec2 at{radical_inverse(2, k), radical_inverse(3, k)};
        const scene::Color c = texture::pigment_color(set, bokeh, {at.x, at.y, 0.0}, {});
        const double enough = static_cast<double>(scene::grey(c.rgb())) + k / patience;
        if (static_cast<double>(generator()) / 4294967296.0 <= enough) places_.push_back(at - 0.5);
    }
}

int FocalBlur::batch(int taken) const
{
    static constexpr std::array<int, 8> kOf37 = {7, 6, 6, 4, 4, 4, 4, 2};
    static constexpr std::array<int, 3> kOf19 = {7, 6, 6};
    int size = kLaterBatch;
    const auto among = [&](const auto& sizes) {
        int before = 0;
        for (const int s : sizes) {
            if (before == taken) size = s;
            before += s;
        }
    };
    if (set_ == 37) among(kOf37);
    if (set_ == 19) among(kOf19);
    if (set_ == 7 && taken == 0) size = 7;
    return std::min(size, samples_ - taken);
}

void FocalBlur::Sums::add(const scene::Color& c, bool has_ray)
{
    const std::array<float, 4> parts{c.red, c.green, c.blue, c.transmit};
    for (std::size_t k = 0; k < 4; ++k) {
        sum[k] += parts[k];
        squares[k] += parts[k] * parts[k];
    }
    filter += c.filter;
    if (has_ray) shown_transmit += c.transmit;
    ++count;
}

scene::Color FocalBlur::Sums::mean() const
{
    const auto n = static_cast<float>(count);
    return {sum[0] / n, sum[1] / n, sum[2] / n, filter / n, shown_transmit / n};
}

bool FocalBlur::converged(const Sums& sums) const
{
    if (sums.count < fewest_) return false;
    const double n = sums.count, threshold = thresholds_[static_cast<std::size_t>(sums.count)];
    for (std::size_t k = 0; k < 4; ++k) {
        const double mean = static_cast<double>(sums.sum[k]) / n;
        if (!((static_cast<double>(sums.squares[k]) / n - mean * mean) / n < threshold)) return false;
    }
    return true;
}

bool FocalBlur::ray(const CameraRays& rays, const glm::dvec2& position, int n, csg::Ray& out) const
{
    const std::uint32_t seed = truncated(313.0 * position.x + 11.0) + truncated(311.0 * position.y + 17.0) +
                               static_cast<std::uint32_t>(n);
    const std::uint32_t across = permuted(seed) % 16u, down = permuted(seed + 1) % 16u;
    const glm::dvec2 moved = position + glm::dvec2(step(across), step(down)) + moves_[16u * across + down];
    const bool found = rays.unscaled_ray(moved.x, moved.y, out);
    const glm::dvec2 place =
        radius_ * (places_[static_cast<std::size_t>(n)] + 2.0 * amplitude_ * jitter(moved.x + 0.5, moved.y + row_));
    const glm::dvec3 offset = place.x * right_ - place.y * up_;
    out.origin = location_ + offset;
    if (!found) return false;
    const glm::dvec3 direction = out.direction * focal_ratio_ - offset;
    const double length = glm::length(direction);
    if (!(length > 0.0)) return false;
    out.direction = direction / length;
    return true;
}

bool FocalBlur::rays(const CameraRays& rays, const Waiting& samples, csg::RayTile& out) const
{
    using numbers::lanes::Double;
    if (!rays.is_perspective()) return false;
    constexpr std::size_t kRays = csg::kTileRays;
    alignas(64) std::array<double, kRays> x{}, y{}, shifted_x{}, shifted_y{}, place_x, place_y;
    std::array<std::uint32_t, kRays> seed;
    const std::size_t lanes = (static_cast<std::size_t>(samples.count) + 7u) & ~std::size_t{7};
    for (std::size_t i = 0; i < lanes; ++i)
        seed[i] = truncated(313.0 * samples.x[i] + 11.0) + truncated(311.0 * samples.y[i] + 17.0) +
                  static_cast<std::uint32_t>(samples.n[i]);
    for (std::size_t i = 0; i < lanes; ++i) {
        const std::uint32_t across = permuted(seed[i]) % 16u, down = permuted(seed[i] + 1) % 16u;
        const glm::dvec2& move = moves_[16u * across + down];
        x[i] = samples.x[i] + step(across) + move.x;
        y[i] = samples.y[i] + step(down) + move.y;
        shifted_x[i] = x[i] + 0.5;
        shifted_y[i] = y[i] + row_;
        const glm::dvec2& place = places_[static_cast<std::size_t>(samples.n[i])];
        place_x[i] = place.x;
        place_y[i] = place.y;
    }
    rays.unscaled_perspective(x.data(), y.data(), samples.count, out.dx.data(), out.dy.data(), out.dz.data());
    jitter(shifted_x.data(), shifted_y.data(), samples.count, x.data(), y.data());
    const auto all = [](bool ok, Double length) {
        constexpr std::uint32_t kAll = (1u << numbers::lanes::kDoubles) - 1u;
        return ok && numbers::lanes::mask(length > Double(0.0)) == kAll;
    };
    const Double radius(radius_), swing(2.0 * amplitude_), ratio(focal_ratio_);
    bool found = true;
    for (std::size_t i = 0; i < lanes; i += numbers::lanes::kDoubles) {
        const auto at = [i](const auto& values) { return Double::load_aligned(values.data() + i); };
        const Double across = radius * (at(place_x) + swing * at(x)), along = radius * (at(place_y) + swing * at(y));
        const auto offset = [&](int axis) { return across * Double(right_[axis]) - along * Double(up_[axis]); };
        const Double ox = offset(0), oy = offset(1), oz = offset(2);
        const Double dx = at(out.dx) * ratio - ox, dy = at(out.dy) * ratio - oy, dz = at(out.dz) * ratio - oz;
        const Double length = xsimd::sqrt(dx * dx + dy * dy + dz * dz);
        found = all(found, length);
        (Double(location_.x) + ox).store_aligned(out.ox.data() + i);
        (Double(location_.y) + oy).store_aligned(out.oy.data() + i);
        (Double(location_.z) + oz).store_aligned(out.oz.data() + i);
        (dx / length).store_aligned(out.dx.data() + i);
        (dy / length).store_aligned(out.dy.data() + i);
        (dz / length).store_aligned(out.dz.data() + i);
    }
    out.count = samples.count;
    return found;
}

}  // namespace trace
