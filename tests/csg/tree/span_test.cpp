#include "csg/spans/span_list.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using csg::Crossing;
using csg::Span;
using Spans = csg::FixedSpans<16>;

namespace {

// Ends on a small grid, so that ends of two lists often coincide; closed and open mixed.
Spans random_spans(csg_test::Rng& rng)
{
    Spans made;
    int t = -8 + rng.below(4);
    if (rng.below(6) == 0) {
        made.push(Span::until({.t = static_cast<double>(t), .closed = rng.coin()}));
        t += 1 + rng.below(2);
    }
    while (t < 8 && rng.below(5) != 0) {
        const int end = t + rng.below(4);
        const bool point = end == t;
        made.push({{.t = static_cast<double>(t), .closed = point || rng.coin()},
                   {.t = static_cast<double>(end), .closed = point || rng.coin()}});
        t = end + 1 + rng.below(2);
    }
    if (t < 8 && rng.below(6) == 0) made.push(Span::from({.t = static_cast<double>(t), .closed = rng.coin()}));
    return made;
}

// One parameter in every elementary interval, and every end itself.
std::vector<double> probes()
{
    std::vector<double> all;
    for (int i = -30; i <= 40; ++i) all.push_back(0.5 * i);
    return all;
}

void require_sorted(const csg::SpanList& spans)
{
    for (std::uint32_t i = 0; i < spans.size(); ++i) {
        REQUIRE(spans[i].in.t <= spans[i].out.t);
        if (i > 0) REQUIRE(csg::detail::out_before_in(spans[i - 1].out, spans[i].in));
    }
}

}  // namespace

TEST_CASE("difference keeps exactly the points of a that b does not hold", "[csg][span]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        csg_test::Rng rng(seed);
        const Spans a = random_spans(rng), b = random_spans(rng);
        Spans kept;
        csg::subtract(a, b, kept);
        require_sorted(kept);
        for (const double t : probes()) REQUIRE(kept.contains(t) == (a.contains(t) && !b.contains(t)));
    }
}

TEST_CASE("union and intersection hold exactly the points of either and of both", "[csg][span]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        csg_test::Rng rng(seed);
        const Spans a = random_spans(rng), b = random_spans(rng);
        Spans either, both;
        csg::unite(a, b, either);
        csg::intersect(a, b, both);
        require_sorted(either);
        require_sorted(both);
        for (const double t : probes()) {
            REQUIRE(either.contains(t) == (a.contains(t) || b.contains(t)));
            REQUIRE(both.contains(t) == (a.contains(t) && b.contains(t)));
        }
    }
}

TEST_CASE("complement holds exactly the other points, twice gives the same points", "[csg][span]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        csg_test::Rng rng(seed);
        const Spans a = random_spans(rng);
        Spans other, again;
        csg::complement(a, other);
        csg::complement(other, again);
        require_sorted(other);
        for (const double t : probes()) {
            REQUIRE(other.contains(t) == !a.contains(t));
            REQUIRE(again.contains(t) == a.contains(t));
        }
    }
}

TEST_CASE("De Morgan for spans", "[csg][span]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        csg_test::Rng rng(seed);
        const Spans a = random_spans(rng), b = random_spans(rng);
        Spans both, outside, not_a, not_b, either;
        csg::intersect(a, b, both);
        csg::complement(both, outside);
        csg::complement(a, not_a);
        csg::complement(b, not_b);
        csg::unite(not_a, not_b, either);
        REQUIRE(either.size() == outside.size());
        for (std::uint32_t i = 0; i < either.size(); ++i) {
            CHECK(either[i].in.t == outside[i].in.t);
            CHECK(either[i].in.closed == outside[i].in.closed);
            CHECK(either[i].out.t == outside[i].out.t);
            CHECK(either[i].out.closed == outside[i].out.closed);
        }
    }
}

TEST_CASE("ends remember their surface through every operation", "[csg][span]")
{
    Spans a, b, kept;
    a.push({{.t = 0.0, .part = 1, .face = 5}, {.t = 10.0, .part = 1, .face = 6}});
    b.push({{.t = 4.0, .part = 2, .face = 7}, {.t = 5.0, .part = 2, .face = 8}});
    csg::subtract(a, b, kept);
    REQUIRE(kept.size() == 2);
    CHECK(kept[0].out.part == 2);
    CHECK(kept[0].out.face == 7);
    CHECK(kept[0].out.inverted);
    CHECK(kept[1].in.face == 8);
    CHECK(kept[1].out.face == 6);
    CHECK_FALSE(kept[1].out.inverted);
}

TEST_CASE("NaN and reversed ends never enter a list", "[csg][span]")
{
    Spans list;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    list.push({{.t = nan}, {.t = 1.0}});
    list.push({{.t = 0.0}, {.t = nan}});
    list.push({{.t = 1.0}, {.t = 0.0}});
    CHECK(list.empty());
}
