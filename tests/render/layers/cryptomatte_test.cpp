// Names of objects as channels: render/layers/cryptomatte.h.
#include "render/layers/cryptomatte.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>

TEST_CASE("the hash is MurmurHash3 of 32 bits", "[layers]")
{
    // Values that others publish for seed 0.
    CHECK(layers::murmur3("") == 0u);
    CHECK(layers::murmur3("hello") == 0x248bfa47u);
    CHECK(layers::murmur3("hello, world") == 0x149bbb7fu);
    CHECK(layers::murmur3("The quick brown fox jumps over the lazy dog") == 0x2e4ff723u);
}

TEST_CASE("a name's value is an ordinary number, and another name's another", "[layers]")
{
    for (int i = 0; i < 20000; ++i) CHECK(std::isnormal(layers::id_of("object " + std::to_string(i))));
    CHECK(std::bit_cast<std::uint32_t>(layers::id_of("hello")) == 0x248bfa47u);
    CHECK(layers::id_of("a") != layers::id_of("b"));
}

TEST_CASE("a pixel keeps the names of the largest shares", "[layers]")
{
    std::array<float, layers::kCryptomatteChannels> out{};
    const std::array<float, 8> ids{3, 5, 5, 0, 5, 3, 7, 0};  // 0: nothing
    layers::rank(ids, out.data());
    CHECK(out == std::array<float, layers::kCryptomatteChannels>{5, 3 / 8.f, 3, 2 / 8.f, 7, 1 / 8.f});
    std::array<float, 8> many{1, 2, 3, 4, 5, 6, 7, 7};
    layers::rank(many, out.data());
    CHECK(out[0] == 7);
    CHECK(out[1] == 0.25f);
    CHECK(out[10] == 5);  // the sixth
}

TEST_CASE("the header names the hash and every name once", "[layers]")
{
    const auto says = layers::cryptomatte_attributes({"Pawn", "a \"b\"", "Pawn"});
    REQUIRE(says.size() == 4);
    CHECK(says[0].second == "CryptoObject");
    CHECK(says[1].second == "MurmurHash3_32");
    CHECK(says[3].first == says[0].first.substr(0, says[0].first.size() - 4) + "manifest");
    CHECK(says[3].second.starts_with("{\"Pawn\":\""));
    CHECK(says[3].second.find("\"a \\\"b\\\"\":\"") != std::string::npos);
    CHECK(says[3].second.find("Pawn", 8) == std::string::npos);
    CHECK(layers::cryptomatte_channels()[0] == "CryptoObject00.R");
    CHECK(layers::cryptomatte_channels()[11] == "CryptoObject02.A");
}
