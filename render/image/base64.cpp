#include "render/image/base64.h"

#include <array>
#include <cstdint>

namespace image {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNone = 0xff;

constexpr std::array<std::uint8_t, 256> values_of_digits()
{
    std::array<std::uint8_t, 256> values{};
    values.fill(kNone);
    for (std::size_t i = 0; i < kDigits.size(); ++i)
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    return values;
}

}  // namespace

std::string base64(std::string_view bytes)
{
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        const std::size_t digits = bytes.size() - i == 1 ? 2 : bytes.size() - i == 2 ? 3 : 4;
        for (std::size_t k = 0; k < 4; ++k) out += k < digits ? kDigits[three >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::optional<std::string> from_base64(std::string_view text)
{
    static constexpr std::array<std::uint8_t, 256> kValues = values_of_digits();
    if (text.size() % 4 != 0) return std::nullopt;
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
    std::string out;
    out.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        std::uint32_t three = 0;
        for (std::size_t k = i; k < i + 4; ++k) {
            const bool filler = k >= text.size() - padding;
            const std::uint8_t value = filler ? std::uint8_t{0} : kValues[static_cast<unsigned char>(text[k])];
            if (value == kNone) return std::nullopt;
            three = three << 6 | value;
        }
        for (int shift = 16; shift >= 0; shift -= 8) out += static_cast<char>(three >> shift & 0xff);
    }
    out.resize(out.size() - padding);
    return out;
}

}  // namespace image
