#include "function/internal/internal.h"
#include "function/internal/internal_shapes.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

/// Sums of noise octaves (spec 5b, 16.2). POV-Ray keeps f_ridged_mf's octave weights from its first call, whatever
/// later calls ask for; here every call has its own.
namespace function {
int generator(double parameter)
{
    return std::max(1, static_cast<int>(std::clamp(std::trunc(parameter), -1e9, 1e9)) & 3);
}

double hetero_mf(const double* a, const Host& host)
{
    const int kind = generator(a[8]);
    const double decay = numbers::pow(a[4], -a[3]), octaves = std::min(a[5], kMostOctaves);
    const double power = std::max(0.0, std::trunc(a[7]));
    glm::dvec3 p(a[0], a[1], a[2]);
    const auto value = [&] { return 2.0 * host.noise(p, kind) - 1.0 + a[6]; };
    double sum = value(), weight = decay;
    p *= a[4];
    for (double i = 1.0; i < octaves; i += 1.0) {
        sum += value() * weight * hetero_gain(sum, power);
        p *= a[4];
        weight *= decay;
    }
    const double rest = octaves - std::floor(octaves);
    if (rest != 0.0) sum += rest * (value() * weight) * sum;
    return sum;
}

double ridge(const double* a, const Host& host)
{
    const int kind = generator(a[8]);
    const double lambda = a[3], omega = a[5], offset = a[6], crest = a[7];
    const double whole = std::trunc(std::min(a[4], kMostOctaves));
    const double scale = 1.0 / std::max(crest, 1.0 - crest), range = 1.0 / std::max(offset, 1.0 - offset);
    const glm::dvec3 p(a[0], a[1], a[2]);
    const auto value = [&](double l) { return std::abs(host.noise(l * p, kind) - crest) * scale - offset; };
    double sum = value(1.0), total = 1.0, l = lambda, o = omega;
    for (double i = 2.0; i <= whole; i += 1.0) {
        sum += o * value(l);
        total += o;
        l *= lambda;
        o *= omega;
    }
    const double rest = std::min(a[4], kMostOctaves) - whole;
    if (rest != 0.0) {
        sum += o * rest * value(l);
        total += o * rest;
    }
    return sum * range / total;
}

std::vector<double> ridged_weights(double h, double lacunarity, double octaves)
{
    std::vector<double> weights;
    double frequency = 1.0;
    for (double i = 1.0; i < std::min(octaves, kMostOctaves); i += 1.0) {
        frequency *= lacunarity;
        weights.push_back(numbers::pow(frequency, -h));
    }
    return weights;
}

double ridged_mf(const double* a, const Host& host, const double* weights)
{
    const int kind = generator(a[8]);
    const double octaves = std::min(a[5], kMostOctaves);
    glm::dvec3 p(a[0], a[1], a[2]);
    const auto crest = [&] {
        const double v = a[6] - std::abs(2.0 * host.noise(p, kind) - 1.0);
        return v * v;
    };
    double signal = crest(), sum = signal, frequency = 1.0;
    for (double i = 1.0; i < octaves; i += 1.0) {
        p *= a[4];
        frequency *= a[4];
        signal = std::clamp(signal * a[7], 0.0, 1.0) * crest();
        sum += signal * (weights != nullptr ? *weights++ : numbers::pow(frequency, -a[3]));
    }
    return sum;
}

}  // namespace function
