// Pictures by the ends of their names: TIFF, OpenEXR and IFF go to OpenImageIO, and what our own readers leave to it.
// The first byte chooses the end.
#include "tests/fuzz/picture_checks.h"

#include <array>
#include <map>

namespace {

constexpr std::array kEndings = {".tif", ".exr", ".hdr", ".bmp", ".ppm", ".pgm", ".tga", ".iff"};

fuzz::Bytes chosen(std::uint8_t ending, const fuzz::Bytes& bytes)
{
    fuzz::Bytes all{ending};
    all.insert(all.end(), bytes.begin(), bytes.end());
    return all;
}

/// Ten entries of its only directory: 2x2 pixels of three channels, one strip.
fuzz::Bytes tiff()
{
    fuzz::Bytes bytes = {'I', 'I', '*', 0, 8, 0, 0, 0, 10, 0};
    const auto entry = [&](unsigned tag, unsigned type, unsigned count, unsigned value) {
        for (const unsigned part : {tag, tag >> 8, type, 0u, count, 0u, 0u, 0u, value, value >> 8, 0u, 0u})
            bytes.push_back(static_cast<std::uint8_t>(part));
    };
    entry(256, 3, 1, 2);
    entry(257, 3, 1, 2);
    entry(258, 3, 1, 8);
    entry(259, 3, 1, 1);
    entry(262, 3, 1, 2);
    entry(273, 4, 1, 134);
    entry(277, 3, 1, 3);
    entry(278, 3, 1, 2);
    entry(279, 4, 1, 12);
    entry(284, 3, 1, 1);
    bytes.insert(bytes.end(), 4, 0);
    for (std::uint8_t i = 0; i < 12; ++i) bytes.push_back(static_cast<std::uint8_t>(20 * i));
    return bytes;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    if (bytes.empty()) return;
    static const image::Files files;
    static std::map<std::size_t, ScratchFile> scratch;
    const std::size_t ending = bytes[0] % kEndings.size();
    const ScratchFile& file = scratch.try_emplace(ending, kEndings[ending]).first->second;
    try {
        check_picture(files.read(file.holding({bytes.begin() + 1, bytes.end()})));
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    image::Image traced;
    traced.width = 5;
    traced.height = 3;
    for (int i = 0; i < 60; ++i) traced.pixels.push_back(static_cast<float>(i) / 20.0f);
    std::vector<Bytes> all = {chosen(0, tiff())};
    for (const auto& [ending, type] : {std::pair{std::uint8_t{1}, image::FileType::OpenExr},
                                       std::pair{std::uint8_t{2}, image::FileType::RadianceHdr}}) {
        const ScratchFile file(image::extension(type));
        image::FileSettings settings;
        settings.type = type;
        settings.encoding.alpha = true;
        image::Files().write(file.path(), traced, settings);
        all.push_back(chosen(ending, image::bytes_of_file(file.path())));
    }
    all.push_back(chosen(3, written(any_raster(3, 8), image::FileType::Bmp)));
    all.push_back(chosen(4, written(any_raster(3, 8), image::FileType::Ppm)));
    all.push_back(chosen(4, written(any_raster(3, 16), image::FileType::Ppm)));
    all.push_back(chosen(4, bytes_of("P3\n# a remark\n2 2 255\n1 2 3 4 5 6 7 8 9 10 11 12\n")));
    all.push_back(chosen(5, bytes_of("P2 2 2 31\n1 2 3 4\n")));
    all.push_back(chosen(5, bytes_of("P4 9 2\nabcd")));
    all.push_back(chosen(6, written(any_raster(4, 8), image::FileType::TargaRunLength)));
    return all;
}
