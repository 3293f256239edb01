#include "render/image/codecs/read/direct_readers.h"

#include "render/files/whole_file.h"
#include "render/image/pixels/passing_failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace image {
namespace {

bool begins(const ByteList& bytes, std::string_view signature)
{
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin(),
                      [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; });
}

}  // namespace

const char* kind_of_file(const std::string& path, const ByteList& bytes)
{
    constexpr std::pair<std::string_view, const char*> kSignatures[] = {
        {"\x89PNG\r\n\x1a\n", "PNG"}, {"GIF8", "GIF"},        {"\xff\xd8\xff", "JPEG"},
        {{"II*\0", 4}, "TIFF"},       {{"MM\0*", 4}, "TIFF"}, {"\x76\x2f\x31\x01", "OpenEXR"},
        {"#?", "Radiance"},           {"BM", "BMP"},          {"FORM", "IFF"},
    };
    for (const auto& [signature, kind] : kSignatures)
        if (begins(bytes, signature)) return kind;
    if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7') return "PPM";
    return path.ends_with(".tga") || path.ends_with(".TGA") ? "Targa" : nullptr;
}

std::optional<Picture> decode_directly(const std::string& path, const ByteList& bytes)
{
    if (begins(bytes, "\x89PNG\r\n\x1a\n")) return decode_png(bytes);
    if (begins(bytes, "GIF8")) return decode_gif(bytes);
    if (begins(bytes, "\xff\xd8\xff")) return decode_jpeg(bytes);
    if (begins(bytes, "BM")) return decode_bmp(bytes);
    if (is_plain_pnm(bytes)) return decode_pnm(bytes);
    if (begins(bytes, "#?")) return decode_hdr(bytes);
    if (is_plain_targa(path, bytes)) return decode_targa(bytes);
    return std::nullopt;
}

ByteList bytes_of_file(const std::string& path)
{
    try {
        const std::string bytes = files::whole_file(path);
        if (bytes.empty()) throw FileError("it is empty");
        return {bytes.begin(), bytes.end()};
    } catch (const std::system_error& error) {
        const int number = error.code().value();
        if (number == EISDIR) throw FileError("it is a folder");
        if (number == ENOENT) throw PassingFailure(std::strerror(number));  // it was there when it was looked for
        fail_by_system(number);
    }
}

}  // namespace image
