#include "render/texture/noise/noise_points.h"

#include "render/texture/noise/cells.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/single_points.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace texture {
namespace {

inline void put(Values& v, std::size_t i, const Double& d) { d.store_aligned(v.data() + i); }

/// The coordinates of some points, aligned for vectors.
struct Coordinates {
    const double *x, *y, *z;
};

/// `Rows` sums of every point; `first`: of the rows, 0 to 2.
template <int Rows, bool MayBeFlat>
[[gnu::always_inline]] inline void sum_rows(const Coordinates& p, std::size_t points, std::size_t first,
                                            const std::array<double*, Rows>& out)
{
    const double* lattice = first_row(first);
    for (std::size_t i = 0; i < points; i += kLanes) {
        Axes axes;
        const bool together =
            axes.prepare(Double::load_aligned(p.x + i), Double::load_aligned(p.y + i), Double::load_aligned(p.z + i));
        const std::size_t count = std::min(kLanes, points - i);
        double* at[Rows];
        for (std::size_t r = 0; r < Rows; ++r) at[r] = out[r] + i;
        const auto sum = [&]<Flat F>() {
            if (together) shared_cell<Rows, F>(axes, lattice, at);
            else own_cells<Rows, F>(axes, count, lattice, at);
        };
        const Flat flat = MayBeFlat ? axes.flat() : Flat::No;
        if (flat == Flat::Y) sum.template operator()<Flat::Y>();
        else if (flat == Flat::Z) sum.template operator()<Flat::Z>();
        else sum.template operator()<Flat::No>();
    }
}

/// The same where the first point is at y = 0 or z = 0. Out of line: all others would pay for it.
template <int Rows>
[[gnu::noinline]] void flat_rows(const Coordinates& p, std::size_t points, std::size_t first,
                                 const std::array<double*, Rows>& out)
{
    sum_rows<Rows, true>(p, points, first, out);
}

template <int Rows>
void lattice_rows(const Coordinates& p, std::size_t points, std::size_t first, const std::array<double*, Rows>& out)
{
    if (p.y[0] == 0.0 || p.z[0] == 0.0) flat_rows<Rows>(p, points, first, out);
    else sum_rows<Rows, false>(p, points, first, out);
}

template <int Rows>
void lattice_points(const Points& p, std::size_t first, const std::array<double*, Rows>& out)
{
    lattice_rows<Rows>({p.x.data(), p.y.data(), p.z.data()}, p.size(), first, out);
}

/// f of every value, a vector at a time.
template <class F>
inline void each(std::size_t count, F&& f)
{
    for (std::size_t i = 0; i < count; i += kLanes) f(i);
}

/// The points farther out by a factor, in places from `at` on, which begins a vector.
void scale(const Points& p, double by, Points& out, std::size_t at = 0)
{
    const Double factor(by);
    out.count = static_cast<int>(at) + p.count;
    out.density = p.density;
    each(p.size(), [&](std::size_t i) {
        put(out.x, at + i, factor * get(p.x, i));
        put(out.y, at + i, factor * get(p.y, i));
        put(out.z, at + i, factor * get(p.z, i));
    });
}

/// What the octave of this share adds to granite or wrinkles; shares are powers of 2, so that products are quotients.
inline Double octave_term(const Double& n, OctaveSum kind, int generator, const Double& share)
{
    if (kind == OctaveSum::Wrinkles) return (generator == 1 ? n : clamp01(Double(2.0) * n - Double(0.5))) * share;
    if (generator == 1) return xsimd::abs(Double(0.5) - n) * share;
    const Double half(0.5), g = xsimd::abs(Double(1.0) - Double(2.0) * n);
    return xsimd::select(g < half, g, half) * share;
}

constexpr int octaves_of(OctaveSum kind) { return kind == OctaveSum::Granite ? 6 : 10; }
constexpr double first_scale(OctaveSum kind) { return kind == OctaveSum::Granite ? 4.0 : 1.0; }
constexpr double last_factor(OctaveSum kind) { return kind == OctaveSum::Granite ? 1.0 : 0.5; }
/// No octave adds more than this times its share.
constexpr double greatest_term(OctaveSum kind) { return kind == OctaveSum::Granite ? 0.5 : 1.0; }

}  // namespace

void noise_points(const Points& p, int generator, Values& out)
{
    if (generator == 3) {
        for (std::size_t i = 0; i < p.size(); ++i) out[i] = noise(p.at(i), 3);
        return;
    }
    if (p.density) single_sums(p, 0, out);
    else lattice_points<1>(p, 0, {out.data()});
    each(p.size(), [&](std::size_t i) { put(out, i, noise_of_sum(get(out, i), generator)); });
}

void noise_eight(const double* x, const double* y, const double* z, int generator, double* out)
{
    if (generator == 3) {
        for (std::size_t i = 0; i < 8; ++i) out[i] = noise({x[i], y[i], z[i]}, 3);
        return;
    }
    lattice_rows<1>({x, y, z}, 8, 0, {out});
    each(8, [&](std::size_t i) { noise_of_sum(Double::load_aligned(out + i), generator).store_aligned(out + i); });
}

void vector_noise_points(const Points& p, unsigned live, Points& out)
{
    out.count = p.count;
    if (p.density) return single_vector_sums(p, live, out);
    switch (live) {
    case 1: return lattice_points<1>(p, 0, {out.x.data()});
    case 2: return lattice_points<1>(p, 1, {out.y.data()});
    case 4: return lattice_points<1>(p, 2, {out.z.data()});
    case 3: return lattice_points<2>(p, 0, {out.x.data(), out.y.data()});
    case 6: return lattice_points<2>(p, 1, {out.y.data(), out.z.data()});
    default: return lattice_points<3>(p, 0, {out.x.data(), out.y.data(), out.z.data()});
    }
}

void vector_turbulence_points(const Points& p, int octaves, double lambda, double omega, unsigned live, Points& out)
{
    vector_noise_points(p, live, out);
    double l = lambda, o = omega;
    Points scaled, term;
    for (int k = 1; k < octaves; ++k) {
        scale(p, l, scaled);
        vector_noise_points(scaled, live, term);
        const Double share(o);
        const auto add = [&](unsigned bit, Values& to, const Values& from) {
            if ((live & bit) != 0)
                each(p.size(), [&](std::size_t i) { put(to, i, get(to, i) + share * get(from, i)); });
        };
        add(1, out.x, term.x);
        add(2, out.y, term.y);
        add(4, out.z, term.z);
        l *= lambda;
        o *= omega;
    }
}

void scalar_turbulence_points(const Points& p, int octaves, double lambda, double omega, int generator, Values& out)
{
    const auto term = [&](const Values& n, std::size_t i) {
        return generator == 1 ? get(n, i) : Double(2.0) * get(n, i) - Double(0.5);
    };
    Values n;
    noise_points(p, generator, n);
    each(p.size(), [&](std::size_t i) { put(out, i, generator == 1 ? term(n, i) : clamp01(term(n, i))); });
    double l = lambda, o = omega;
    Points scaled;
    for (int k = 1; k < octaves; ++k) {
        scale(p, l, scaled);
        noise_points(scaled, generator, n);
        const Double share(o);
        each(p.size(), [&](std::size_t i) { put(out, i, get(out, i) + share * term(n, i)); });
        l *= lambda;
        o *= omega;
    }
}

namespace {

/// Sums of octaves. No term is negative or above its bound, so that a sum need not be finished which is large enough,
/// or so small that what is left can't raise it enough.
class OctaveSums {
public:
    OctaveSums(const Points& p, OctaveSum kind, int generator) : kind_(kind), generator_(generator)
    {
        left_.take(p);
        each(p.size(), [&](std::size_t i) { put(sums_, i, Double(0.0)); });
        for (std::size_t i = 0; i < p.size(); ++i) place_[i] = static_cast<std::uint8_t>(i);
    }

    void add(double factor)
    {
        scale(left_, first_scale(kind_) * factor, scaled_);
        noise_points(scaled_, generator_, n_);
        each(left_.size(), [&](std::size_t i) {
            put(sums_, i, get(sums_, i) + octave_term(get(n_, i), kind_, generator_, Double(1.0 / factor)));
        });
    }

    /// Tells the points whose value lies in a flat end whatever is added from the octave of 1 / factor on, if vectors
    /// get fewer without them.
    void drop(const FlatEnds& flat, double factor, Values& out)
    {
        // The shares that are left are less than 2 / factor together; kRounding is above what the sums are off by.
        constexpr double kRounding = 1e-12;
        const Double high(flat.high),
            low(flat.low - 2.0 / factor * greatest_term(kind_) * last_factor(kind_) - kRounding),
            share(last_factor(kind_));
        std::uint64_t open = 0;
        each(left_.size(), [&](std::size_t i) {
            const Double v = get(sums_, i) * share;
            open |= std::uint64_t{numbers::lanes::mask((v >= low) & (v < high))} << i;
        });
        if (left_.size() < kMostPoints) open &= (std::uint64_t{1} << left_.size()) - 1;
        const auto count = static_cast<std::size_t>(std::popcount(open));
        const auto vectors = [](std::size_t points) { return (points + kLanes - 1) / kLanes; };
        if (vectors(count) == vectors(left_.size())) return;
        finish(out);
        std::size_t kept = 0;
        for (; open != 0; open &= open - 1, ++kept) {
            const auto i = static_cast<std::size_t>(std::countr_zero(open));
            left_.x[kept] = left_.x[i];
            left_.y[kept] = left_.y[i];
            left_.z[kept] = left_.z[i];
            sums_[kept] = sums_[i];
            place_[kept] = place_[i];
        }
        left_.count = static_cast<int>(kept);
        if (kept != 0) left_.pad();
    }

    void finish(Values& out) const
    {
        const double share = last_factor(kind_);
        for (std::size_t i = 0; i < left_.size(); ++i) out[place_[i]] = sums_[i] * share;
    }

    bool empty() const { return left_.count == 0; }

private:
    OctaveSum kind_;
    int generator_;
    Points left_, scaled_;
    Values sums_, n_;
    std::array<std::uint8_t, kMostPoints> place_;
};

/// Of few points all octaves side by side: vectors of one would be too few to hide what they wait for. False: there is
/// no room for them.
bool add_together(const Points& p, OctaveSum kind, int generator, Values& out)
{
    const std::size_t stride = (p.size() + kLanes - 1) / kLanes * kLanes,
                      octaves = static_cast<std::size_t>(octaves_of(kind));
    if (stride * octaves > kMostPoints) return false;
    Points all;
    Values n;
    double factor = 1.0;
    for (std::size_t k = 0; k < octaves; ++k, factor *= 2.0) scale(p, first_scale(kind) * factor, all, k * stride);
    all.count = static_cast<int>(stride * octaves);
    noise_points(all, generator, n);
    each(p.size(), [&](std::size_t i) {
        Double sum(0.0);
        double share = 1.0;
        for (std::size_t k = 0; k < octaves; ++k, share *= 0.5)
            sum = sum + octave_term(get(n, k * stride + i), kind, generator, Double(share));
        put(out, i, sum * Double(last_factor(kind)));
    });
    return true;
}

}  // namespace

void octave_points(const Points& p, OctaveSum kind, int generator, const FlatEnds& flat, Values& out)
{
    double factor = 1.0;
    if (!(flat.high < last_factor(kind) * 2.0 || flat.low > 0.0)) {
        if (add_together(p, kind, generator, out)) return;
        Values n;
        Points scaled;
        each(p.size(), [&](std::size_t i) { put(out, i, Double(0.0)); });
        for (int k = 0; k < octaves_of(kind); ++k, factor *= 2.0) {
            scale(p, first_scale(kind) * factor, scaled);
            noise_points(scaled, generator, n);
            each(p.size(), [&](std::size_t i) {
                put(out, i, get(out, i) + octave_term(get(n, i), kind, generator, Double(1.0 / factor)));
            });
        }
        each(p.size(), [&](std::size_t i) { put(out, i, get(out, i) * Double(last_factor(kind))); });
        return;
    }
    OctaveSums sums(p, kind, generator);
    for (int k = 0; k < octaves_of(kind) && !sums.empty(); ++k) {
        sums.add(factor);
        factor *= 2.0;
        if (k >= 1 && k <= 4) sums.drop(flat, factor, out);  // the first is too small as a rule, the last add little
    }
    sums.finish(out);
}

double octaves_at(const glm::dvec3& p, OctaveSum kind, int generator)
{
    Points at;
    Values n, shares;
    double factor = 1.0;
    for (int k = 0; k < octaves_of(kind); ++k, factor *= 2.0) {
        shares[at.size()] = 1.0 / factor;
        at.add(first_scale(kind) * factor * p);
    }
    at.pad();
    for (std::size_t i = at.size(); i < kMostPoints && i % kLanes != 0; ++i) shares[i] = 1.0;
    noise_points(at, generator, n);
    each(at.size(), [&](std::size_t i) { put(n, i, octave_term(get(n, i), kind, generator, get(shares, i))); });
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += n[i];
    return sum * last_factor(kind);
}

}  // namespace texture
