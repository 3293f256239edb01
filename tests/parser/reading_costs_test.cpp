#include "parser/stream/reading_profile.h"
#include "render/scene/base/shared.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <algorithm>

TEST_CASE("macros, loops and files that time went to are named", "[parser][profile]")
{
    const parser::Result result =
        parser::parse_text("#version 3.7;\n"
                           "#macro Dear(N) #local S = 0; #for (I, 1, N) #local S = S + sin(I); #end S #end\n"
                           "#macro Cheap() 1 #end\n"
                           "#declare T = 0;\n"
                           "#while (T < 1e9) #declare T = T + 1e6 + abs(Dear(100)); #end\n"
                           "sphere { Cheap(), 1 }\n",
                           "test.pov", {});
    const std::vector<parser::ReadingCost>& costs = result.statistics.costs;
    REQUIRE(costs.size() >= 3);
    CHECK(costs.size() <= 10);
    CHECK((costs[0].what == "file" && costs[0].name == "test.pov"));
    const auto named = [&](const std::string& what, const std::string& place) {
        return std::find_if(costs.begin(), costs.end(),
                            [&](const parser::ReadingCost& c) { return c.what == what && c.place == place; });
    };
    const auto loop = named("loop", "test.pov:5:1");
    REQUIRE(loop != costs.end());
    CHECK(loop->name == "#while");
    const auto macro = std::find_if(costs.begin(), costs.end(), [](const auto& c) { return c.name == "Dear"; });
    REQUIRE(macro != costs.end());
    CHECK((macro->what == "macro" && macro->place.starts_with("test.pov:2:")));
    for (const parser::ReadingCost& cost : costs) {
        CHECK(cost.own_seconds <= cost.seconds);
        CHECK(cost.seconds <= costs[0].seconds);
    }
}

TEST_CASE("time goes to what is open once, however often it is open", "[parser][profile]")
{
    using parser::ReadingProfile;
    ReadingProfile profile;
    const ReadingProfile::Place file{ReadingProfile::What::File, 0, 0}, macro{ReadingProfile::What::Macro, 0, 7};
    profile.spend(std::vector{file, macro, macro, macro});
    profile.spend(std::vector{file});
    const std::vector<ReadingProfile::Cost> costs = profile.costs(10);
    REQUIRE(costs.size() == 2);
    CHECK(costs[0].place == file);
    CHECK(costs[0].seconds == profile.total());
    CHECK(costs[1].seconds == costs[1].own_seconds);
    CHECK(std::abs(costs[0].own_seconds + costs[1].own_seconds - profile.total()) <= 1e-9);
    CHECK(profile.costs(1).size() == 1);
}

TEST_CASE("copies share until one is changed", "[scene][shared]")
{
    scene::Shared<std::string> a, b = std::string("one");
    CHECK((!a.given() && a->empty() && b.given()));
    scene::Shared<std::string> c = b;
    CHECK(c.same(b));
    c.edit() += " more";
    CHECK((*b == "one" && *c == "one more" && !c.same(b)));
    const std::string* const place = &*c;
    c.edit() += "!";
    CHECK(&*c == place);  // alone: no copy
    a.edit() = "two";
    a = std::move(b);
    CHECK(*a == "one");
}

TEST_CASE("a small object shares what its copies have in common", "[scene][shared]")
{
    const scene::Description d =
        grammar_test::parsed("#declare A = sphere { 0, 1 texture { pigment { rgb 1 } } scale 2 }\n"
                             "object { A } object { A } object { A translate x }");
    REQUIRE(d.objects.size() == 3);
    CHECK(d.objects[0].transform.same(d.objects[1].transform));
    CHECK(d.objects[0].texture == d.objects[1].texture);
    CHECK(d.objects[2].texture == d.objects[1].texture);  // alike everywhere: moving changes nothing
    CHECK_FALSE(d.objects[2].transform.same(d.objects[1].transform));
}
