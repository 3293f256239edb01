#include "tests/fuzz/picture_checks.h"

#include <string_view>

void fuzz::one(const Bytes& bytes)
{
    try {
        if (image::is_plain_pnm(bytes)) check_picture(image::decode_pnm(bytes));
        else check_picture(image::decode_hdr(bytes));
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    using namespace std::string_view_literals;
    const auto bytes = [](std::string_view text) { return Bytes(text.begin(), text.end()); };
    return {bytes("P3 # a\n2 2\n100\n1 2 3 4 5 6 7 8 9 10 11 12"),
            bytes("P2 3 1 900 1 2 900"),
            bytes("P6 1 1 255 abc"),
            bytes("P5 2 1 300 abcd"),
            bytes("#?RADIANCE\nEXPOSURE=1\n\n-Y 1 +X 3\nabcd\1\1\1\1efgh"),
            bytes("#?RGBE\n\n-Y 1 +X 8\n\2\2\0\10\210a\4bcde\204f\210g\210h"sv)};
}
