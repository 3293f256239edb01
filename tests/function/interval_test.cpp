#include "support.h"

#include "function/builder.h"
#include "function/interval.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using function::Interval;

namespace {

/// Random boxes of several sizes about `centre`; every value at points inside lies in the interval.
void check_boxes(const function::Function& f, const std::vector<double>& centre, std::mt19937& random)
{
    const function_test::NoiseHost host;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const double size : {0.0, 1e-6, 0.1, 2.0}) {
        std::vector<Interval> box;
        for (const double c : centre) {
            const double low = c - size * unit(random), high = c + size * unit(random);
            box.emplace_back(low, high);
        }
        const Interval all = function::evaluate_interval(f, box.data(), host);
        REQUIRE(all.low <= all.high);
        for (int i = 0; i < 40; ++i) {
            std::vector<double> point;
            for (const Interval& side : box) point.push_back(i == 0 ? side.low : i == 1 ? side.high : std::min(side.high, side.low + (side.high - side.low) * unit(random)));
            const double v = function::evaluate(f, point.data(), host);
            INFO("value " << v << " in [" << all.low << ", " << all.high << "], box of size " << size);
            REQUIRE((std::isnan(v) || all.contains(v)));
        }
    }
}

Interval over(const std::string& body, const Interval& x)
{
    const Interval box[] = {x, 0.0, 0.0};
    return function::evaluate_interval(*function_test::compiled("#declare F=function{" + body + "}", "F"), box, function::no_host());
}

}  // namespace

TEST_CASE("no value of an expression lies outside of its interval", "[function]")
{
    const std::string auxiliary =
        "#declare F1=function(q){q*2+1} #declare F2=function(x,y,z){x-y*z} "
        "#declare VT=function{transform{translate <1,2,3> scale 2}} "
        "#declare SP=function{spline{linear_spline 0,<1,2> 1,<3,5>}} ";
    std::mt19937 random(11);
    for (const auto& row : function_test::table("expressions.csv")) {
        INFO(row[0]);
        const auto f = function_test::compiled(auxiliary + "#declare F=function(x,y,z,a,b){" + row[0] + "}", "F");
        check_boxes(*f, {0.7, -1.3, 2.2, 0.4, -3.1}, random);
    }
    for (const char* body : {"sum(i,1,x+3,i*y)", "prod(i,0,z+2,y+i)", "select(x,y,select(y,z,x))", "tan(x)+atan2(y,z)", "mod(x,0.3)-mod(y,-2)",
                             "pow(x,z)+pow(y,3)-pow(z,9)", "int(x*2)+div(y,z)+floor(z)-ceil(x)", "acos(x)+asin(y)+acosh(z)+atanh(x)+ln(y)+log(z)"}) {
        INFO(body);
        const auto f = function_test::compiled(std::string("#declare F=function{") + body + "}", "F");
        for (int round = 0; round < 50; ++round) {
            std::uniform_real_distribution<double> any(-3.0, 3.0);
            check_boxes(*f, {any(random), any(random), any(random)}, random);
        }
    }
}

TEST_CASE("no value of an internal function lies outside of its interval", "[function]")
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> any(-1.5, 1.5);
    for (std::uint32_t n = 0; n < 79; ++n) {
        INFO("internal " << n);
        const auto f = function::make_internal(n);
        for (int round = 0; round < 20; ++round) {
            std::vector<double> centre;
            for (std::uint32_t i = 0; i < f->parameters; ++i) centre.push_back(any(random));
            check_boxes(*f, centre, random);
        }
    }
}

TEST_CASE("intervals are narrow where they can be", "[function]")
{
    const auto near = [](const Interval& v, double low, double high) { return std::abs(v.low - low) < 1e-8 && std::abs(v.high - high) < 1e-8; };
    CHECK(near(over("x*x+1", {1, 2}), 2, 5));
    CHECK(near(over("sin(x)", {0, 3.1}), 0, 1));
    CHECK(near(over("cos(x)", {-0.5, 0.5}), std::cos(0.5), 1));
    CHECK(near(over("abs(x)", {-1, 2}), 0, 2));
    CHECK(near(over("select(x,1,2)", {0.5, 1}), 2, 2));
    CHECK(near(over("select(x,1,2)", {-1, 1}), 1, 2));
    CHECK(near(over("sum(i,1,3,x)", {1, 2}), 3, 6));
}
