#include "function/internal/internal.h"

#include "function/internal/internal_curves.h"
#include "function/internal/internal_polynomials.h"
#include "function/internal/internal_shapes.h"
#include "numbers/functions/functions.h"

#include <array>

namespace function {
namespace {

// clang-format off
constexpr std::array<std::uint8_t, kInternals> kParameters = {
    5, 5, 5, 5, 2, 2, 5, 4, 2, 1,  4, 1, 1, 1, 1, 6, 6, 3, 1, 4,  3, 6, 1, 1, 10, 7, 7, 1, 1, 6,
    1, 3, 4, 3, 6, 1, 1, 4, 1, 6,  5, 1, 1, 1, 4, 1, 3, 0, 1, 1,  7, 5, 6, 1, 1, 1, 3, 0, 6, 6,
    4, 1, 5, 4, 6, 1, 4, 7, 2, 0,  2, 3, 1, 1, 2, 6, 0, 0, 1, 1,
};
// clang-format on

}  // namespace

std::uint32_t internal_parameters(std::uint32_t n) { return kParameters[n]; }

bool internal_asks_noise(std::uint32_t n)
{
    return n == kHeteroMultifractal || n == 58 || n == 59 || n == 76 || n == 78;
}

double internal(std::uint32_t n, const double* a, const Host& host, const double* weights)
{
    switch (n) {
    case 6: return blob(a);
    case 7: return blob2(a);
    case 9: return comma(a);
    case 10:
    case 19:
    case 32: return ellipsoids(n, a);
    case 17: return ellipsoid(a);
    case kEnneper: return enneper(a);
    case kWholeEnneper: return whole_enneper(a);
    case 24: return helical_torus(a);
    case 25: return helix1(a);
    case 26: return helix2(a);
    case 27:
    case 28: return hexagonal(n == 28, a);
    case kHeteroMultifractal: return hetero_mf(a, host);
    case 40: return mesh1(a);
    case 47: return numbers::atan2(std::sqrt(a[0] * a[0] + a[2] * a[2]), a[1]);
    case 51: return poly4(a);
    case 52: return polytubes(a);
    case 53: return quantum(a);
    case 57: return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    case 58: return ridge(a, host);
    case kRidgedMultifractal: return ridged_mf(a, host, weights);
    case kRoundedBox: return rounded_box(a);
    case 61: return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) - a[3];
    case 62: return spikes(a);
    case 63:
        return a[1] - a[3] * numbers::cos(a[4] * a[0]) * numbers::cos(a[5] * a[2]) *
                          numbers::exp(-a[6] * (a[0] * a[0] + a[2] * a[2]));
    case 64: return spiral(a);
    case 68: return superellipsoid(a);
    case 69: return numbers::atan2(a[0], a[2]);
    case 70: return torus(a);
    case kNoise: return host.noise({a[0], a[1], a[2]}, 0);
    case 77: return 0.0;
    case kNoiseOfGenerator: return host.noise({a[0], a[1], a[2]}, generator(a[3]));
    default: return is_curve(n) ? curve(n, a) : polynomial<double>(n, a);
    }
}

}  // namespace function
