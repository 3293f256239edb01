#include "render/kernel/gather/photon_map.h"

#include "numbers/functions/functions.h"
#include "render/kernel/gather/photon_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trace {
namespace {

float along(const Photon& photon, int axis) { return axis == 0 ? photon.x : axis == 1 ? photon.y : photon.z; }

/// Orders a range around its middle, POV-Ray's way: the order of equal halves decides which photons its radius is
/// estimated from.
class TreeBuilder {
public:
    explicit TreeBuilder(std::vector<Photon>& photons) : photons_(photons) {}

    void build(std::ptrdiff_t first, std::ptrdiff_t last)
    {
        if (last < first) return;
        const std::ptrdiff_t middle = (first + last) / 2;
        int axis = 0;
        if (last > first) axis = widest(first, last);
        if (last - first >= 2) select(first, last, middle, axis);
        photons_[static_cast<std::size_t>(middle)].axis = static_cast<std::uint8_t>(axis);
        build(first, middle - 1);
        build(middle + 1, last);
    }

private:
    int widest(std::ptrdiff_t first, std::ptrdiff_t last) const
    {
        glm::vec3 low = at(first).place(), high = low;
        for (std::ptrdiff_t i = first + 1; i <= last; ++i) {
            low = glm::min(low, at(i).place());
            high = glm::max(high, at(i).place());
        }
        const glm::vec3 extent = high - low;
        if (extent.x >= extent.y && extent.x >= extent.z) return 0;
        return extent.y >= extent.z ? 1 : 2;
    }

    void select(std::ptrdiff_t left, std::ptrdiff_t right, std::ptrdiff_t middle, int axis)
    {
        const auto value = [&](std::ptrdiff_t i) { return along(at(i), axis); };
        const auto order = [&](std::ptrdiff_t a, std::ptrdiff_t b) {
            if (value(a) > value(b)) swap(a, b);
        };
        while (right > left) {  // of two, the larger may come first, as in POV-Ray
            swap((left + right) / 2, left + 1);
            order(left + 1, right);
            order(left, right);
            order(left + 1, left);
            const float pivot = value(left);
            std::ptrdiff_t j = left + 1, k = right;
            for (;;) {
                do ++j;
                while (j <= right && value(j) < pivot);
                do --k;
                while (k >= left && value(k) > pivot);
                if (j > k) break;
                if (j < k) swap(j, k);
            }
            swap(left, k);
            if (k == middle) return;
            if (k > middle) right = k - 1;
            else left = k + 1;
        }
    }

    const Photon& at(std::ptrdiff_t i) const { return photons_[static_cast<std::size_t>(i)]; }
    void swap(std::ptrdiff_t a, std::ptrdiff_t b)
    {
        std::swap(photons_[static_cast<std::size_t>(a)], photons_[static_cast<std::size_t>(b)]);
    }
    std::vector<Photon>& photons_;
};

}  // namespace

void PhotonMap::build(std::vector<Photon> photons)
{
    TreeBuilder(photons).build(0, static_cast<std::ptrdiff_t>(photons.size()) - 1);
    take(std::move(photons));
}

void PhotonMap::take(std::vector<Photon> photons)
{
    photons_ = std::move(photons);
    rays_.clear();
    rays_.reserve(photons_.size());
    for (const Photon& photon : photons_) rays_.push_back({flux_of(photon), back_of(photon)});
    places_.take(photons_);
    boxes_.take(places_);
}

double PhotonMap::estimated_radius(bool media, LibraryRandom& random) const
{
    constexpr double kEverywhere = 1e7;
    using std::numbers::pi;
    const std::size_t count = std::clamp<std::size_t>(photons_.size() / 20, 100, 1000);
    NearPhotons near;
    const auto density = [&](double radius) {
        const std::size_t which = random.draw() % photons_.size();
        PhotonSearch<false>(places_, boxes_, photons_[which].place(), {}, gather_most).find_in_order(radius, near);
        const auto number = static_cast<double>(near.found.size());
        const double r = std::sqrt(near.radius2);
        return media ? 3.0 * number / (4.0 * pi * r * r * r) : number / (pi * r * r);
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double here = density(kEverywhere);
        sum += near.radius2 > 0.0 ? here : i > 0 ? sum / static_cast<double>(i) : 0.0;
    }
    const double average = sum / static_cast<double>(count);
    const auto most = static_cast<double>(gather_most);
    double radius = media ? numbers::pow(3.0 * most / (4.0 * pi * average), 0.3333) : std::sqrt(most / (average * pi));
    std::size_t sparse = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double here = density(radius);
        sparse += here > 0.05 * average && here < 0.7 * average ? 1 : 0;
    }
    return radius * (1.0 + 20.0 * static_cast<double>(sparse) / static_cast<double>(count));
}

void PhotonMap::find_radius(const scene::PhotonSettings& settings, bool media, LibraryRandom& random)
{
    gather_least = settings.gather_least;
    gather_most = settings.gather_most;
    expand_increase = settings.expand_increase;
    expand_least = settings.expand_least;
    if (empty()) return;
    radius_ = media ? settings.media_radius : settings.radius;
    if (!(radius_ > 0.0)) radius_ = estimated_radius(media, random);
    radius_ *= media ? 2.0 * settings.media_radius_factor : settings.radius_factor;
}

void PhotonMap::find(const glm::dvec3& point, double radius, const glm::dvec3* normal, NearPhotons& out) const
{
    find(point, radius, normal, PhotonReach(boxes_), out);
}

void PhotonMap::find(const glm::dvec3& point, double radius, const glm::dvec3* normal, const PhotonReach& reach,
                     NearPhotons& out) const
{
    if (normal != nullptr) PhotonSearch<true>(places_, boxes_, point, *normal, gather_most).find(radius, reach, out);
    else PhotonSearch<false>(places_, boxes_, point, {}, gather_most).find(radius, reach, out);
}

void PhotonMap::find_among(const NearPhotons& wide, const glm::dvec3& point, const glm::dvec3* normal,
                           NearPhotons& out) const
{
    if (normal != nullptr)
        PhotonSearch<true>(places_, boxes_, point, *normal, gather_most).find_among(wide, radius_, out);
    else PhotonSearch<false>(places_, boxes_, point, {}, gather_most).find_among(wide, radius_, out);
}

void PhotonMap::gather(const glm::dvec3& point, const glm::dvec3* normal, const PhotonReach& reach,
                       NearPhotons& scratch, NearPhotons& out) const
{
    // Where the point before needed the wider search this one should too, and what it finds holds what the other finds:
    // unless it found so many that it left some out.
    const bool wide_first = out.few;
    if (wide_first) find(point, kWider * radius_, normal, reach, scratch);
    if (wide_first && static_cast<int>(scratch.found.size()) < gather_most) find_among(scratch, point, normal, out);
    else find(point, radius_, normal, reach, out);
    out.few = out.found.size() < static_cast<std::size_t>(gather_least);
    if (!out.few) return;
    constexpr double kNone = 1e-16;
    if (!wide_first) find(point, kWider * radius_, normal, reach, scratch);
    const double first = out.found.empty() ? kNone : out.density_per_area();
    const double second = scratch.density_per_area();
    const bool steady = (second - first) / first < expand_increase;
    const bool few = !scratch.found.empty() && static_cast<double>(scratch.found.size()) < expand_least;
    if (!steady && !few) return;
    std::swap(out.found, scratch.found);
    std::swap(out.radius2, scratch.radius2);
}

}  // namespace trace
