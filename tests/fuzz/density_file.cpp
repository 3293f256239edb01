// df3 files of density patterns.
#include "parser/grammar/textures/density_file.h"
#include "tests/fuzz/target.h"

void fuzz::one(const Bytes& bytes)
{
    const auto volume = parser::decode_density_file({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!volume) return;
    require(volume->samples.size() == std::size_t{volume->size[0]} * volume->size[1] * volume->size[2] &&
                !volume->samples.empty(),
            "samples do not fit the sizes");
    for (const std::uint32_t sample : volume->samples)
        require(static_cast<double>(sample) <= volume->most, "a sample above the largest");
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all;
    for (const std::size_t width : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
        all.push_back({0, 2, 0, 3, 0, 1});
        for (std::size_t i = 0; i < 6 * width; ++i) all.back().push_back(static_cast<std::uint8_t>(i * 41));
    }
    return all;
}
