#include "csg/freeform/shared/sort_few.h"
#include "tests/numbers/arguments.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

struct Item {
    double t;
    std::uint64_t place;
};

}  // namespace

TEST_CASE("a few items are put in order, and those that are equal stay as they were", "[csg][sort]")
{
    numbers_test::Rng rng(7);
    const auto some = [&](double count) { return static_cast<std::size_t>(rng.between(0.0, count)); };
    for (int round = 0; round < 20000; ++round) {
        std::vector<Item> items(some(33.0));
        for (std::size_t i = 0; i < items.size(); ++i) {
            double t = rng.between(-2.0, 3.0);
            const double before = items[some(static_cast<double>(i) + 1.0)].t;
            switch (some(12.0)) {
            case 0: t = before; break;
            case 1: t = std::nextafter(before, 9.0); break;
            case 2: t = std::nextafter(before, -9.0); break;
            case 3: t = some(2.0) == 0 ? 0.0 : -0.0; break;
            case 4: t = 1e300; break;
            default: break;
            }
            items[i] = {t, i};
        }
        std::vector<Item> sorted = items;
        std::stable_sort(sorted.begin(), sorted.end(), [](const Item& a, const Item& b) { return a.t < b.t; });
        csg::SortFew<Item>::sort(items.data(), items.size());
        INFO("round " << round);
        for (std::size_t i = 0; i < items.size(); ++i) REQUIRE(items[i].place == sorted[i].place);
    }
}
