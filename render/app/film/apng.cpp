#include "render/app/film/film.h"

#include "render/files/whole_file.h"
#include "render/image/picture_writer.h"
#include "render/image/pixels/passing_failure.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

// PNG and its animated form (W3C, Portable Network Graphics, third edition, 11.3.6). The frames' packed rows are
// copied: what a frame's fdAT holds is what its file's IDAT held.

namespace app {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kHeader = 13, kFrame = 12;  // bytes of IHDR; of a chunk besides its data

std::uint32_t number_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

std::string big_endian(std::uint32_t number, int bytes = 4)
{
    std::string out;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xffu);
    return out;
}

struct PngParts {
    std::string header, about, rows;  ///< IHDR's data; whole chunks before the rows; the data of all IDAT
};

std::string bytes_of(const std::string& path)
{
    try {
        return files::whole_file(path);
    } catch (const std::system_error& error) {
        image::fail_by_system(error.code().value(), "cannot read '" + path + "': " + error.code().message());
    }
}

PngParts parts_of(const std::string& path)
{
    const std::string bytes = bytes_of(path);
    const std::string_view all(bytes);
    const auto fail = [&](const char* why) { throw image::FileError("'" + path + "' " + why); };
    if (!all.starts_with(kSignature)) fail("is no PNG, as frames of an animated PNG have to be");
    PngParts out;
    bool ended = false;
    for (std::size_t at = kSignature.size(); at + kFrame <= all.size() && !ended;) {
        const std::size_t size = number_at(all, at);
        if (size > all.size() - at - kFrame) break;
        const std::string_view name = all.substr(at + 4, 4), data = all.substr(at + 8, size);
        const auto* checked = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        if (crc32(crc32(0, nullptr, 0), checked, static_cast<uInt>(size + 4)) != number_at(all, at + 8 + size))
            fail("is damaged");
        if (name == "IHDR") out.header = data;
        else if (name == "IDAT") out.rows += data;
        else if (name == "IEND") ended = true;
        else if (name != "tEXt" && name != "tIME" && out.rows.empty()) out.about += all.substr(at, size + kFrame);
        at += size + kFrame;
    }
    if (!ended || out.header.size() != kHeader || out.rows.empty()) fail("ends too early");
    return out;
}

class ApngFile {
public:
    explicit ApngFile(const std::string& path) : file_(std::fopen(path.c_str(), "wb"), std::fclose)
    {
        if (!file_) image::fail_by_system(errno);
    }
    void put(std::string_view bytes)
    {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) image::fail_by_system(errno);
    }
    void chunk(const char* name, const std::string& data)
    {
        const std::string body = name + data;
        put(big_endian(static_cast<std::uint32_t>(data.size())));
        put(body);
        put(big_endian(static_cast<std::uint32_t>(
            crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())))));
    }
    void finish()
    {
        if (std::fflush(file_.get()) != 0) image::fail_by_system(errno);
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// How long a frame is shown, as a fraction whose parts are numbers of 16 bits.
std::string delay_of(double rate)
{
    const bool slow = rate < 1.0;
    const double least = slow ? 100.0 : 100.0 * rate;
    return big_endian(slow ? static_cast<std::uint32_t>(std::min(65535.0, std::round(100.0 / rate))) : 100u, 2) +
           big_endian(static_cast<std::uint32_t>(std::min(65535.0, std::round(least))), 2);
}

void write_chunks(ApngFile& file, const Film& film)
{
    std::uint32_t sequence = 0;
    std::string header;
    for (const std::string& path : film.frames) {
        const PngParts frame = parts_of(path);
        if (sequence == 0) {
            header = frame.header;
            file.put(kSignature);
            file.chunk("IHDR", header);
            file.chunk("acTL", big_endian(static_cast<std::uint32_t>(film.frames.size())) + big_endian(0));
            file.put(frame.about);
        }
        if (frame.header != header)
            throw image::FileError("'" + path + "' has another size, depth or kind of colours than the first frame");
        const bool first = sequence == 0;
        file.chunk("fcTL", big_endian(sequence++) + header.substr(0, 8) + big_endian(0) + big_endian(0) +
                               delay_of(film.rate) + std::string(2, '\0'));
        if (first) file.chunk("IDAT", frame.rows);
        else file.chunk("fdAT", big_endian(sequence++) + frame.rows);
    }
    file.chunk("IEND", {});
    file.finish();
}

}  // namespace

void write_apng(const Film& film)
{
    image::Replacement replacement(film.out);
    try {
        ApngFile file(replacement.temporary());
        write_chunks(file, film);
    } catch (const image::FileError& error) {
        image::fail_named("cannot write '" + film.out + "': ", error);
    }
    replacement.put_in_place();
}

}  // namespace app
