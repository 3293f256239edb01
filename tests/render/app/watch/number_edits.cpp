#include "render/app/watch/place/number_edits.h"

#include <catch2/catch.hpp>

#include <random>

using namespace app;

TEST_CASE("a number is written with six digits at most", "[app][watch]")
{
    CHECK(number_text(0.7) == "0.7");
    CHECK(number_text(-1.0 / 3.0) == "-0.333333");
    CHECK(number_text(2.0) == "2");
}

TEST_CASE("a place outside of set numbers holds the same character in both texts, and one leads to the other",
          "[app][watch]")
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        std::mt19937 rng(seed);
        // Letters that tell places apart, and numbers of one to three characters between them, some of which are set.
        std::string text;
        NumberEdits edits;
        std::vector<bool> in_number;
        for (unsigned part = 0; part < 12; ++part) {
            text += static_cast<char>('a' + part);
            if (rng() % 4 != 0) text += static_cast<char>('A' + part);
            in_number.resize(text.size(), false);
            const auto begin = static_cast<std::uint32_t>(text.size());
            text.append(1 + rng() % 3, '7');
            if (rng() % 2 != 0) {
                edits.numbers[begin] = {static_cast<std::uint32_t>(text.size()),
                                        static_cast<int>(rng() % 20000) / 100.0 - 50.0};
                in_number.resize(text.size(), true);
            } else {
                in_number.resize(text.size(), false);
            }
        }
        const std::string now = edited(text, edits);
        for (std::uint32_t at = 0; at < text.size(); ++at) {
            INFO("byte " << at << " of " << text << ", " << now);
            if (in_number[at]) continue;
            const std::uint32_t there = edited_place(at, edits);
            REQUIRE(there < now.size());
            CHECK(now[there] == text[at]);
            CHECK(written_place(there, edits) == at);
        }
        for (const auto& [begin, number] : edits.numbers) {
            const std::uint32_t first = edited_place(begin, edits);
            CHECK(now.substr(first, number_text(number.value).size()) == number_text(number.value));
            for (std::uint32_t at = 0; at < number_text(number.value).size(); ++at)
                CHECK(written_place(first + at, edits) == begin);
        }
    }
}
