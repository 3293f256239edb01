#include "render/kernel/extinction/media_mix.h"
#include "numbers/functions/functions.h"

#include <algorithm>

namespace trace {
namespace {

double power_of_two(double v, int squarings)
{
    for (int i = 0; i < squarings; ++i) v *= v;
    return v;
}

double phase_of(const plan::Media& media, double cosine)
{
    using Phase = plan::Media::Phase;
    switch (media.phase) {
    case Phase::Isotropic: break;
    case Phase::MieHazy: return 0.576655375 * (1.0 + 9.0 * power_of_two(0.5 * (1.0 + cosine), 3));
    case Phase::MieMurky: return 0.495714547 * (1.0 + 50.0 * power_of_two(0.5 * (1.0 + cosine), 5));
    case Phase::Rayleigh: return 0.799372013 * (1.0 + cosine * cosine);
    case Phase::HenyeyGreenstein: {
        const double g = media.eccentricity;
        return (1.0 - g * g) / numbers::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
    }
    }
    return 1.0;
}

}  // namespace

void MediaMix::add(const plan::MediaSet& set, const plan::MediaList& list)
{
    for (std::uint32_t i = list.first; i < list.first + list.count && count < kMost; ++i) {
        const plan::Media& media = set.media[set.order[i]];
        const auto bound = static_cast<float>(media.aa_threshold);
        threshold = count == 0 ? bound : std::min(threshold, bound);
        if (control == nullptr || media.intervals > control->intervals) control = &media;
        scatters |= media.scatters();
        extinguishes |= media.extinguishes();
        patterned |= media.densities != 0;
        plain &= media.plain;
        one_kind &= count == 0 || (media.phase == members[0]->phase && media.eccentricity == members[0]->eccentricity);
        members[count++] = &media;
    }
}

bool MediaMix::same_members(const MediaMix& other) const
{
    return count == other.count && std::equal(members.begin(), members.begin() + count, other.members.begin());
}

double MediaMix::phase(double cosine) const
{
    if (one_kind) return phase_of(*members[0], cosine);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += phase_of(*members[i], cosine);
    return sum / static_cast<double>(count);
}

}  // namespace trace
