// TrueType fonts: the outlines of a text. Seeds are the fonts of the package povray-includes.
#include "render/font/font.h"
#include "render/image/codecs/read/direct_readers.h"
#include "tests/fuzz/scratch_file.h"

#include <stdexcept>

void fuzz::one(const Bytes& bytes)
{
    static const ScratchFile file(".ttf");
    try {
        for (const bool unicode : {false, true})
            for (const font::Glyph& glyph :
                 font::lay_out(file.holding(bytes), u"Ag. &\u00e9\u0416", {0.1, 0.0}, unicode))
                require(!glyph.outline->empty(), "an empty outline");
    } catch (const std::runtime_error&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all;
    for (const char* name : {"povlogo", "cyrvetic", "timrom", "crystal"}) {
        const std::string path = std::string("/usr/share/povray-3.7/include/") + name + ".ttf";
        if (std::filesystem::exists(path)) all.push_back(image::bytes_of_file(path));
    }
    return all;
}
