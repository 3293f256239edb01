#include "render/texture/fresnel.h"
#include "numbers/float_mask.h"
#include "render/kernel/tile/tile_parts.h"
#include "numbers/random_lanes.h"
#include "render/kernel/interior/dispersion.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <memory>
#include <random>

// Built for several instruction sets: each has a way of its own.
using namespace trace;
using numbers::FloatMask;
using numbers::lanes::FloatPart;

TEST_CASE("random numbers of many points are those of each alone", "[lanes][random]")
{
    std::mt19937_64 draw(1);
    std::uniform_real_distribution<double> number(-100.0, 100.0);
    for (int round = 0; round < 2000; ++round) {
        INFO("round " << round);
        alignas(64) std::array<double, 64> x, y, z, found;
        std::array<std::uint64_t, 64> purpose;
        for (std::size_t i = 0; i < 64; ++i) {
            x[i] = number(draw), y[i] = number(draw), z[i] = number(draw);
            purpose[i] = draw() >> 33;
        }
        const auto next = static_cast<std::uint32_t>(round % 3);
        const std::size_t count = 8 * (1 + static_cast<std::size_t>(round) % 8);
        numbers::random_at(x.data(), y.data(), z.data(), purpose.data(), next, count, found.data());
        for (std::size_t i = 0; i < count; ++i) {
            const double alone = numbers::random_at({x[i], y[i], z[i]}, static_cast<std::uint32_t>(purpose[i]) + next);
            REQUIRE(std::bit_cast<std::uint64_t>(alone) == std::bit_cast<std::uint64_t>(found[i]));
        }
    }
}

TEST_CASE("Fresnel shares of many rays are those of each alone", "[lanes][fresnel]")
{
    using numbers::lanes::Double;
    std::mt19937_64 draw(3);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    int beyond = 0;
    for (int round = 0; round < 20000; ++round) {
        alignas(64) std::array<double, numbers::lanes::kDoubles> eta, cosine, found;
        for (std::size_t i = 0; i < eta.size(); ++i) {
            eta[i] = round % 7 == 0 ? 1.0 : 0.3 + 2.0 * number(draw);
            cosine[i] = round % 5 == 0 ? 0.0 : round % 11 == 0 ? 1.0 : 1.1 * number(draw) - 0.05;
        }
        texture::fresnel_share(Double::load_aligned(eta.data()), Double::load_aligned(cosine.data()))
            .store_aligned(found.data());
        for (std::size_t i = 0; i < eta.size(); ++i) {
            INFO("eta " << eta[i] << ", cosine " << cosine[i]);
            const double alone = texture::fresnel_share(eta[i], cosine[i]);
            REQUIRE(std::bit_cast<std::uint64_t>(alone) == std::bit_cast<std::uint64_t>(found[i]));
            beyond += alone == 1.0 ? 1 : 0;
        }
    }
    CHECK(beyond > 1000);
}

TEST_CASE("powers of the spectrum that were looked up are those of the library", "[dispersion]")
{
    std::mt19937_64 draw(4);
    const auto powers = std::make_unique<SpectrumPowers>();
    for (int round = 0; round < 20000; ++round) {
        const int samples = 2 + static_cast<int>(draw() % 30);
        const float nm = wavelength(static_cast<int>(draw() % static_cast<unsigned>(samples)), samples);
        // More than there is room for, and the same again.
        const double dispersion = 0.9 + 0.001 * static_cast<double>(draw() % 200), ratio = 1.5;
        REQUIRE(powers->ratio_at(ratio, dispersion, nm) == ratio_at(ratio, dispersion, nm));
        REQUIRE(powers->ratio_at(ratio, dispersion, nm) == ratio_at(ratio, dispersion, nm));
    }
}

TEST_CASE("a mask keeps and chooses lanes by its bits", "[lanes][mask]")
{
    std::mt19937_64 draw(2);
    for (int round = 0; round < 2000; ++round) {
        INFO("round " << round);
        const HitMask mask = draw() & draw();
        alignas(64) std::array<float, 64> a, b, kept{}, chosen{};
        for (std::size_t i = 0; i < 64; ++i) {
            a[i] = static_cast<float>(draw() % 1000) + 1.0f;
            b[i] = -static_cast<float>(draw() % 1000) - 1.0f;
        }
        each_part(mask, [&](std::size_t first) {
            const FloatMask lanes(mask >> first);
            const FloatPart of_a = FloatPart::load_aligned(a.data() + first);
            lanes.kept(of_a).store_aligned(kept.data() + first);
            lanes.chosen(of_a, FloatPart::load_aligned(b.data() + first)).store_aligned(chosen.data() + first);
        });
        for (std::size_t i = 0; i < 64; ++i) {
            REQUIRE(kept[i] == (has(mask, i) ? a[i] : 0.0f));
            if (has(mask, i)) REQUIRE(chosen[i] == a[i]);
            else REQUIRE((chosen[i] == b[i] || chosen[i] == 0.0f));  // 0: a register without any of them
        }
    }
}

TEST_CASE("deposited bits lie at the hits of a mask, in order", "[lanes][mask]")
{
    std::mt19937_64 draw(3);
    for (int round = 0; round < 2000; ++round) {
        const HitMask bits = draw(), mask = round == 0 ? ~HitMask{0} : round == 1 ? 0 : draw() & draw();
        HitMask expected = 0;
        std::size_t next = 0;
        for_each_hit(mask, [&](std::size_t k) { expected |= (bits >> next++ & 1) << k; });
        CHECK(deposited(bits, mask) == expected);
    }
}
