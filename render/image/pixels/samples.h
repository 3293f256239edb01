#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace image {

/// Samples of a picture as its file holds them: floats, or levels of 8 or 16 bits of which `most` stands for 1.
struct Samples {
    using Bytes = std::vector<std::uint8_t>;
    using Shorts = std::vector<std::uint16_t>;
    using Floats = std::vector<float>;

    std::variant<Floats, Bytes, Shorts> kept;
    float most = 1.0f;

    Samples() = default;
    Samples(Floats values) : kept(std::move(values)) {}
    template <class Levels>
    Samples(Levels levels, std::uint32_t highest) : kept(std::move(levels)), most(static_cast<float>(highest))
    {}

    std::size_t size() const
    {
        return std::visit([](const auto& of) { return of.size(); }, kept);
    }
    /// What a level stands for; floats are what they are.
    template <class Level>
    float value(Level level) const
    {
        if constexpr (std::is_floating_point_v<Level>) return level;
        else return static_cast<float>(level) / most;
    }
    float operator[](std::size_t i) const
    {
        return std::visit([&](const auto& of) { return value(of[i]); }, kept);
    }
};

}  // namespace image
