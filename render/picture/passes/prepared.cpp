#include "render/picture/passes/prepared.h"

#include "render/kernel/gather/indirect_light.h"

#include <cstring>
#include <type_traits>

namespace trace {
namespace {

template <class Thing>
void put(std::string& bytes, const std::vector<Thing>& things)
{
    static_assert(std::is_trivially_copyable_v<Thing>);
    const std::uint64_t count = things.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(things.data()), things.size() * sizeof(Thing));
}

/// False: there are not so many.
template <class Thing>
bool take(std::string_view& bytes, std::vector<Thing>& things)
{
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count) return false;
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(Thing)) return false;
    things.resize(count);
    if (count > 0) std::memcpy(things.data(), bytes.data(), count * sizeof(Thing));
    bytes.remove_prefix(count * sizeof(Thing));
    return true;
}

}  // namespace

Prepared::Prepared(const IndirectLight* light, std::vector<double> of_places) : costs(std::move(of_places))
{
    if (light == nullptr) return;
    photons = {light->photons.photons(), light->media_photons.photons()};
    if (!light->radiosity) return;
    for (std::size_t bounce = 0; bounce < light->radiosity->samples.size(); ++bounce)
        for (const radiosity::Sample& sample : light->radiosity->samples[bounce].samples())
            samples.push_back({static_cast<int>(bounce), sample});
}

std::string bytes_of(const Prepared& prepared)
{
    std::string bytes;
    put(bytes, prepared.photons.surface);
    put(bytes, prepared.photons.media);
    put(bytes, prepared.samples);
    put(bytes, prepared.costs);
    return bytes;
}

std::optional<Prepared> prepared_of(std::string_view bytes)
{
    Prepared out;
    if (!take(bytes, out.photons.surface) || !take(bytes, out.photons.media) || !take(bytes, out.samples) ||
        !take(bytes, out.costs) || !bytes.empty())
        return std::nullopt;
    return out;
}

}  // namespace trace
