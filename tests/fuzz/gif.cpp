#include "tests/fuzz/picture_checks.h"

namespace {

/// 4x5 pixels of four colours in one block of codes of three bits, none longer than a pixel: a clear code stands before
/// each pair.
fuzz::Bytes small_gif(std::uint8_t flags, bool control)
{
    fuzz::Bytes bytes = fuzz::bytes_of("GIF89a");
    bytes.insert(bytes.end(), {4, 0, 5, 0, 0x91, 0, 0, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255});
    if (control) bytes.insert(bytes.end(), {0x21, 0xf9, 4, 1, 0, 0, 2, 0, 0x21, 0xfe, 2, 'h', 'i', 0});
    bytes.insert(bytes.end(), {0x2c, 0, 0, 0, 0, 4, 0, 5, 0, flags});
    if (flags & 0x80) bytes.insert(bytes.end(), {9, 9, 9, 8, 8, 8, 7, 7, 7, 6, 6, 6});
    std::vector<int> codes;
    for (int i = 0; i < 20; ++i) {
        if (i % 2 == 0) codes.push_back(4);
        codes.push_back(i % 4);
    }
    codes.push_back(5);
    fuzz::Bytes packed(1, 0);
    std::size_t bit = 0;
    for (const int code : codes)
        for (int b = 0; b < 3; ++b, ++bit) {
            if (bit / 8 >= packed.size()) packed.push_back(0);
            packed[bit / 8] = static_cast<std::uint8_t>(packed[bit / 8] | ((code >> b & 1) << bit % 8));
        }
    bytes.push_back(2);
    bytes.push_back(static_cast<std::uint8_t>(packed.size()));
    bytes.insert(bytes.end(), packed.begin(), packed.end());
    bytes.insert(bytes.end(), {0, 0x3b});
    return bytes;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    try {
        check_picture(image::decode_gif(bytes));
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds() { return {small_gif(0, false), small_gif(0x40, true), small_gif(0x81, true)}; }
