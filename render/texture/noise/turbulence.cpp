#include "render/texture/noise/cells.h"
#include "render/texture/noise/noise.h"

#include <algorithm>

/// Turbulence of one point: its octaves lie in the lanes.
namespace texture {
namespace {

/// The octaves of one point's turbulence, side by side, as many at a time as there is room for.
class Octaves {
public:
    static constexpr std::size_t kRoom = 16;  // whole vectors

    Octaves(int octaves, double lambda, double omega) : left_(std::max(octaves, 1)), lambda_(lambda), omega_(omega) {}

    /// False: there are no more.
    bool next()
    {
        count_ = 0;
        for (; left_ > 0 && count_ < kRoom; --left_, ++count_, scale_ *= lambda_, share_ *= omega_) {
            scales_[count_] = scale_;
            shares_[count_] = share_;
        }
        if (count_ == 0) return false;
        for (std::size_t i = count_; i % kLanes != 0; ++i) scales_[i] = shares_[i] = 0.0;
        return true;
    }

    /// Calls take(i, how many, axes) for every vector of octaves of the point.
    template <class Take>
    void each(const glm::dvec3& p, Take&& take) const
    {
        for (std::size_t i = 0; i < count_; i += kLanes) {
            const Double scale = Double::load_aligned(scales_ + i);
            Axes at;
            at.prepare(scale * Double(p.x), scale * Double(p.y), scale * Double(p.z));
            take(i, std::min(kLanes, count_ - i), at);
        }
    }

    std::size_t count() const { return count_; }
    double scale(std::size_t i) const { return scales_[i]; }
    Double shares(std::size_t i) const { return Double::load_aligned(shares_ + i); }

private:
    alignas(64) double scales_[kRoom], shares_[kRoom];
    std::size_t count_ = 0;
    int left_;
    double lambda_, omega_, scale_ = 1.0, share_ = 1.0;
};

}  // namespace

glm::dvec3 vector_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega)
{
    Octaves sums(octaves, lambda, omega);
    alignas(64) double n[3][Octaves::kRoom];
    glm::dvec3 sum(-0.0);  // to which a number adds as itself
    while (sums.next()) {
        sums.each(p, [&](std::size_t i, std::size_t count, const Axes& at) {
            double* const to[3] = {n[0] + i, n[1] + i, n[2] + i};
            own_cells<3>(at, count, first_row(0), to);
            for (double* v : to) (sums.shares(i) * Double::load_aligned(v)).store_aligned(v);
        });
        for (std::size_t i = 0; i < sums.count(); ++i) sum += glm::dvec3(n[0][i], n[1][i], n[2][i]);
    }
    return sum;
}

double scalar_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega, int generator)
{
    Octaves sums(octaves, lambda, omega);
    alignas(64) double n[Octaves::kRoom];
    double sum = -0.0;
    for (bool first = true; sums.next(); first = false) {
        if (generator == 3)
            for (std::size_t i = 0; i < sums.count(); ++i) n[i] = noise(sums.scale(i) * p, 3);
        sums.each(p, [&](std::size_t i, std::size_t count, const Axes& at) {
            double* const to[1] = {n + i};
            if (generator != 3) own_cells<1>(at, count, first_row(0), to);
            const Double v = Double::load_aligned(n + i), ready = generator == 3 ? v : noise_of_sum(v, generator),
                         term = generator == 1 ? ready : Double(2.0) * ready - Double(0.5);
            (sums.shares(i) * term).store_aligned(n + i);
        });
        if (first && generator != 1) n[0] = std::clamp(n[0], 0.0, 1.0);
        for (std::size_t i = 0; i < sums.count(); ++i) sum += n[i];
    }
    return sum;
}

}  // namespace texture
