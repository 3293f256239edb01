#include "render/texture/noise/single_points.h"

#include "render/texture/noise/noise.h"
#include "render/texture/noise/single_cells.h"

namespace texture {
namespace {

/// Calls take(i, cells, quads): cells of point i and those behind it, of which so many quads are wanted.
template <class Take>
inline void each_cells(const Points& p, Take&& take)
{
    for (std::size_t i = 0; i < p.size(); i += kSingles) {
        const std::size_t left = p.size() - i, second = left > kLanes ? i + kLanes : i;
        take(i, SingleCells(p.x.data(), p.y.data(), p.z.data(), i, second), left > kLanes ? kQuads : (kQuads + 1) / 2);
    }
}

/// One number for each of three components.
struct Three {
    Floats of[3];
};

/// Sums over the corners of point 4 q + j, Count components; first: the rows of the first of them.
template <std::size_t Q, std::size_t Count>
[[gnu::always_inline]] inline Three point_sums(const SingleCells& cells, std::size_t j, const float* first)
{
    const SingleFactors<Q> factors(floats(cells.low[j]), floats(cells.shares[0][j]), floats(cells.shares[1][j]));
    const SingleRows rows(cells, 4 * Q + j, first);
    Three out;
    for (std::size_t c = 0; c < Count; ++c) out.of[c] = factors.sum(rows, c);
    return out;
}

/// The same of points j, 4 + j, ...: of so many quads.
template <std::size_t Count>
[[gnu::always_inline]] inline Three quad_sums(const SingleCells& cells, std::size_t j, const float* first,
                                              std::size_t quads)
{
    const Three a = point_sums<0, Count>(cells, j, first);
    Three out;
#if defined(__AVX512F__)
    const Three b = point_sums<1, Count>(cells, j, first), c = quads == 2 ? a : point_sums<2, Count>(cells, j, first),
                d = quads == 2 ? b : point_sums<3, Count>(cells, j, first);
    for (std::size_t i = 0; i < Count; ++i) out.of[i] = joined(a.of[i], b.of[i], c.of[i], d.of[i]);
#elif defined(__AVX2__)
    const Three b = quads == 1 ? a : point_sums<1, Count>(cells, j, first);
    for (std::size_t i = 0; i < Count; ++i) out.of[i] = joined(a.of[i], b.of[i]);
#else
    static_cast<void>(quads);
    for (std::size_t i = 0; i < Count; ++i) out.of[i] = joined(a.of[i]);
#endif
    return out;
}

/// Widened, as points lie.
inline void put_wide(Floats v, double* out)
{
    alignas(64) float parts[kSingles];
    put_floats(parts, v);
    for (std::size_t k = 0; k < kSingles; ++k) out[k] = static_cast<double>(parts[k]);
}

/// Components of all points of the cells.
template <std::size_t Count>
inline void put_sums(const SingleCells& cells, const float* first, std::size_t quads, double* const (&out)[Count])
{
    alignas(64) float sums[Count][4][kSingles];
    for (std::size_t j = 0; j < 4; ++j) {
        const Three found = quad_sums<Count>(cells, j, first, quads);
        for (std::size_t c = 0; c < Count; ++c) put_floats(sums[c][j], found.of[c]);
    }
    for (std::size_t c = 0; c < Count; ++c)
        put_wide(quad_totals(floats(sums[c][0]), floats(sums[c][1]), floats(sums[c][2]), floats(sums[c][3])), out[c]);
}

/// Calls tell(i, vector noise) of the points out of all cells among those from `first` on.
template <class Tell>
inline void each_far(const Points& p, std::size_t first, std::uint32_t far, Tell&& tell)
{
    for (std::size_t i = first; far != 0 && i < p.size(); ++i, far >>= 1)
        if ((far & 1) != 0) tell(i, vector_noise(p.at(i)));
}

}  // namespace

void single_sums(const Points& p, std::size_t component, Values& out)
{
    const float* const first = first_single(component);
    each_cells(p, [&](std::size_t i, const SingleCells& cells, std::size_t quads) {
        put_sums<1>(cells, first, quads, {out.data() + i});
        each_far(p, i, cells.far, [&](std::size_t k, const glm::dvec3& n) { out[k] = n[static_cast<int>(component)]; });
    });
}

void single_vector_sums(const Points& p, unsigned live, Points& out)
{
    switch (live) {
    case 1: return single_sums(p, 0, out.x);
    case 2: return single_sums(p, 1, out.y);
    case 4: return single_sums(p, 2, out.z);
    default: break;
    }
    out.count = p.count;
#if defined(__AVX512F__)
    each_cells(p, [&](std::size_t i, const SingleCells& cells, std::size_t quads) {
        alignas(64) float sums[kSingles][kSingles];
        for (std::size_t j = 0; j < 4; ++j) {
            const Floats low = floats(cells.low[j]), shares_low = floats(cells.shares[0][j]),
                         shares_high = floats(cells.shares[1][j]);
            const auto point = [&]<std::size_t Q>() {
                put_floats(sums[4 * Q + j], SingleFactors<Q>(low, shares_low, shares_high)
                                                .three(SingleRows(cells, 4 * Q + j, first_single(0))));
            };
            point.template operator()<0>();
            point.template operator()<1>();
            if (quads == 2) continue;
            point.template operator()<2>();
            point.template operator()<3>();
        }
        for (std::size_t k = 0; k < 4 * quads; k += 4) {  // a component in each quad
            const Floats of =
                quad_totals(floats(sums[k]), floats(sums[k + 1]), floats(sums[k + 2]), floats(sums[k + 3]));
            _mm256_store_pd(out.x.data() + i + k, _mm256_cvtps_pd(_mm512_castps512_ps128(of)));
            _mm256_store_pd(out.y.data() + i + k, _mm256_cvtps_pd(_mm512_extractf32x4_ps(of, 1)));
            _mm256_store_pd(out.z.data() + i + k, _mm256_cvtps_pd(_mm512_extractf32x4_ps(of, 2)));
        }
        each_far(p, i, cells.far, [&](std::size_t k, const glm::dvec3& n) { out.set(k, n); });
    });
#else
    each_cells(p, [&](std::size_t i, const SingleCells& cells, std::size_t quads) {
        put_sums<3>(cells, first_single(0), quads, {out.x.data() + i, out.y.data() + i, out.z.data() + i});
        each_far(p, i, cells.far, [&](std::size_t k, const glm::dvec3& n) { out.set(k, n); });
    });
#endif
}

}  // namespace texture
