#include "render/layers/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <set>

namespace layers {
namespace {

constexpr const char* kName = "CryptoObject";

std::uint32_t normal_number(std::uint32_t hash)
{
    const std::uint32_t exponent = hash >> 23 & 255u;
    return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

/// A text between quotation marks of JSON.
std::string json_text(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else out += c;
    }
    return out + "\"";
}

}  // namespace

std::uint32_t murmur3(std::string_view text)
{
    constexpr std::uint32_t kFirst = 0xcc9e2d51u, kSecond = 0x1b873593u;
    std::uint32_t hash = 0;
    const auto mixed = [](std::uint32_t k) { return std::rotl(k * kFirst, 15) * kSecond; };
    std::size_t at = 0;
    for (; at + 4 <= text.size(); at += 4) {
        std::uint32_t k = 0;
        std::memcpy(&k, text.data() + at, 4);
        hash = std::rotl(hash ^ mixed(k), 13) * 5u + 0xe6546b64u;
    }
    std::uint32_t rest = 0;
    for (std::size_t i = text.size(); i-- > at;) rest = rest << 8 | static_cast<unsigned char>(text[i]);
    hash ^= mixed(rest);
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

float id_of(std::string_view name) { return std::bit_cast<float>(normal_number(murmur3(name))); }

void rank(std::span<const float> ids, float* out)
{
    std::vector<std::pair<float, std::size_t>> counts;  // few: a pixel shows one or two
    for (const float id : ids) {
        if (id == 0.0f) continue;
        const auto known = std::find_if(counts.begin(), counts.end(), [id](const auto& c) { return c.first == id; });
        if (known == counts.end()) counts.emplace_back(id, 1);
        else ++known->second;
    }
    std::stable_sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::fill_n(out, kCryptomatteChannels, 0.0f);
    for (std::size_t i = 0; i < std::min(counts.size(), kRanks); ++i) {
        out[2 * i] = counts[i].first;
        out[2 * i + 1] = static_cast<float>(counts[i].second) / static_cast<float>(ids.size());
    }
}

std::vector<std::string> cryptomatte_channels()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kCryptomatteChannels; ++i)
        names.push_back(fmt::format("{}{:02}.{}", kName, i / 4, "RGBA"[i % 4]));
    return names;
}

std::vector<std::pair<std::string, std::string>> cryptomatte_attributes(const std::vector<std::string>& names)
{
    std::string manifest;
    std::set<std::string_view> told;
    for (const std::string& name : names)
        if (told.insert(name).second)
            manifest += fmt::format("{}{}:\"{:08x}\"", manifest.empty() ? "{" : ",", json_text(name),
                                    normal_number(murmur3(name)));
    manifest += manifest.empty() ? "{}" : "}";
    const std::string key = fmt::format("cryptomatte/{:07x}/", murmur3(kName) >> 4);
    return {{key + "name", kName},
            {key + "hash", "MurmurHash3_32"},
            {key + "conversion", "uint32_to_float32"},
            {key + "manifest", manifest}};
}

}  // namespace layers
