#include "render/picture/passes/photon_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

static_assert(std::endian::native == std::endian::little, "records are copied as they are");

namespace trace {
namespace {

constexpr std::size_t kRecord = sizeof(Photon);

std::vector<Photon> take_photons(const std::vector<char>& bytes, std::size_t& at, const std::string& path)
{
    std::int32_t count = 0;
    if (bytes.size() - at < sizeof(count))
        throw std::runtime_error(fmt::format("the photon map '{}' ends too early", path));
    std::memcpy(&count, bytes.data() + at, sizeof(count));
    at += sizeof(count);
    if (count < 0 || static_cast<std::size_t>(count) > (bytes.size() - at) / kRecord)
        throw std::runtime_error(fmt::format("the photon map '{}' says that it holds {} photons and is too short for "
                                             "them",
                                             path, count));
    std::vector<Photon> photons(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(photons.data(), bytes.data() + at, photons.size() * kRecord);
    at += photons.size() * kRecord;
    for (Photon& photon : photons) {
        if (photon.axis > 2)
            throw std::runtime_error(fmt::format("'{}' is no photon map: a photon has no axis {}", path, photon.axis));
        if (!std::isfinite(photon.x) || !std::isfinite(photon.y) || !std::isfinite(photon.z))
            throw std::runtime_error(fmt::format("'{}' is no photon map: a photon is nowhere", path));
    }
    return photons;
}

void put_photons(std::ofstream& out, const std::vector<Photon>& photons)
{
    const auto count = static_cast<std::int32_t>(photons.size());
    out.write(reinterpret_cast<const char*>(&count), sizeof(count));
    out.write(reinterpret_cast<const char*>(photons.data()), static_cast<std::streamsize>(photons.size() * kRecord));
}

}  // namespace

PhotonFile decode_photons(const std::vector<char>& bytes, const std::string& path)
{
    PhotonFile out;
    std::size_t at = 0;
    out.surface = take_photons(bytes, at, path);
    out.media = take_photons(bytes, at, path);
    return out;
}

PhotonFile read_photon_file(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(fmt::format("cannot read the photon map '{}': {}", path, std::strerror(errno)));
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return decode_photons(bytes, path);
}

void write_photon_file(const std::string& path, const std::vector<Photon>& surface, const std::vector<Photon>& media)
{
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    put_photons(out, surface);
    put_photons(out, media);
    out.close();
    if (!out) throw std::runtime_error(fmt::format("cannot write the photon map '{}'", path));
}

}  // namespace trace
