#include "support.h"

#include "function/build/builder.h"
#include "function/internal/internal.h"

#include <catch2/catch.hpp>

#include <set>
#include <sstream>

TEST_CASE("the internal functions have the values that POV-Ray prints", "[function]")
{
    std::set<unsigned> seen;
    for (const auto& row : function_test::table("internal_functions.csv")) {
        const auto n = static_cast<std::uint32_t>(std::stoul(row[1]));
        std::vector<double> arguments{std::stod(row[3]), std::stod(row[4]), std::stod(row[5])};
        std::istringstream parameters(row[2]);
        for (double p; parameters >> p;) arguments.push_back(p);
        INFO(row[0] << " (" << row[2] << ") at " << row[3] << " " << row[4] << " " << row[5]);
        const auto f = function::make_internal(n);
        REQUIRE(arguments.size() == f->parameters);
        const double value = function::evaluate(*f, arguments.data(), function_test::NoiseHost{});
        CHECK(value == Approx(std::stod(row[6])).epsilon(1e-13).margin(2e-15));
        seen.insert(n);
    }
    CHECK(seen.size() >= 76);
}

TEST_CASE("internal functions end where the library ends", "[function]")
{
    CHECK(function::make_internal(79));  // that of 3.8, which no text can name by its number
    CHECK_FALSE(function::make_internal(80));
    CHECK(function::evaluate(*function::make_internal(77), std::vector<double>(3, 0.5).data(), function::no_host()) ==
          0);
}
