#include "support.h"

#include "function/build/builder.h"
#include "function/intervals/interval.h"
#include "tests/support/share.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using function::Interval;

namespace {

/// Eight boxes at once, the box cut into slices along its first side, hold what each slice holds.
void check_eight(const function::Function& f, const std::vector<Interval>& box, const function::Host& host)
{
    constexpr std::size_t kMost = 16;
    double low[kMost][8], high[kMost][8], out_low[8], out_high[8];
    const double width = (box[0].high - box[0].low) / 8;
    for (std::size_t lane = 0; lane < 8; ++lane)
        for (std::size_t i = 0; i < box.size(); ++i) {
            low[i][lane] = i == 0 ? box[0].low + static_cast<double>(lane) * width : box[i].low;
            high[i][lane] = i == 0 ? box[0].low + static_cast<double>(lane + 1) * width : box[i].high;
        }
    function::evaluate_intervals(f, low, high, host, out_low, out_high);
    for (std::size_t lane = 0; lane < 8; ++lane) {
        std::vector<double> middle;
        for (std::size_t i = 0; i < box.size(); ++i)
            middle.push_back(
                std::clamp(low[i][lane] + 0.5 * (high[i][lane] - low[i][lane]), low[i][lane], high[i][lane]));
        const double v = function::evaluate(f, middle.data(), host);
        INFO("value " << v << " in slice [" << out_low[lane] << ", " << out_high[lane] << "]");
        REQUIRE((std::isnan(v) || (out_low[lane] <= v && v <= out_high[lane])));
    }
}

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
        check_eight(f, box, host);
        for (int i = 0; i < 40; ++i) {
            std::vector<double> point;
            for (const Interval& side : box)
                point.push_back(i == 0   ? side.low
                                : i == 1 ? side.high
                                         : std::min(side.high, side.low + (side.high - side.low) * unit(random)));
            const double v = function::evaluate(f, point.data(), host);
            INFO("value " << v << " in [" << all.low << ", " << all.high << "], box of size " << size);
            REQUIRE((std::isnan(v) || all.contains(v)));
        }
    }
}

Interval over(const std::string& body, const Interval& x)
{
    const Interval box[] = {x, 0.0, 0.0};
    return function::evaluate_interval(*function_test::compiled("#declare F=function{" + body + "}", "F"), box,
                                       function::no_host());
}

}  // namespace

TEST_CASE("no value of an expression lies outside of its interval", "[function]")
{
    const std::string auxiliary = "#declare F1=function(q){q*2+1} #declare F2=function(x,y,z){x-y*z} "
                                  "#declare VT=function{transform{translate <1,2,3> scale 2}} "
                                  "#declare SP=function{spline{linear_spline 0,<1,2> 1,<3,5>}} ";
    std::mt19937 random(11);
    for (const auto& row : function_test::table("expressions.csv")) {
        INFO(row[0]);
        const auto f = function_test::compiled(auxiliary + "#declare F=function(x,y,z,a,b){" + row[0] + "}", "F");
        check_boxes(*f, {0.7, -1.3, 2.2, 0.4, -3.1}, random);
    }
    for (const char* body : {"sum(i,1,x+3,i*y)", "prod(i,0,z+2,y+i)", "select(x,y,select(y,z,x))", "tan(x)+atan2(y,z)",
                             "mod(x,0.3)-mod(y,-2)", "pow(x,z)+pow(y,3)-pow(z,9)", "int(x*2)+div(y,z)+floor(z)-ceil(x)",
                             "acos(x)+asin(y)+acosh(z)+atanh(x)+ln(y)+log(z)"}) {
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

TEST_CASE("a function that is one call of the library is answered as the call", "[function]")
{
    const function_test::NoiseHost host;
    std::mt19937 random(14);
    std::uniform_real_distribution<double> any(-1.5, 1.5);
    const auto lone = function_test::compiled(
                   "#declare B=function{internal(60)} #declare F=function{B(z,x,y,0.05,0.5,0.75,0.25)}", "F"),
               nested = function_test::compiled(
                   "#declare B=function{internal(60)} #declare F=function{0+1*B(z,x,y,0.05,0.5,0.75,0.25)}", "F"),
               all = function::make_internal(60);
    for (int round = 0; round < 200; ++round) {
        const double p[] = {any(random), any(random), any(random)}, q[] = {p[2], p[0], p[1], 0.05, 0.5, 0.75, 0.25};
        const double v = function::evaluate(*lone, p, host);
        REQUIRE(v == function::evaluate(*all, q, host));
        REQUIRE(v == function::evaluate(*nested, p, host));
        check_boxes(*lone, {p[0], p[1], p[2]}, random);
        // A point alone has its own value: no other is as near.
        double low[3][8], high[3][8], out_low[8], out_high[8];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t lane = 0; lane < 8; ++lane) low[i][lane] = high[i][lane] = p[i];
        function::evaluate_intervals(*lone, low, high, host, out_low, out_high);
        REQUIRE((out_low[3] == v && out_high[3] == v));
    }
    // What is no number may be anything.
    double low[3][8] = {}, high[3][8] = {}, out_low[8], out_high[8];
    low[1][2] = high[1][2] = std::nan("");
    function::evaluate_intervals(*lone, low, high, host, out_low, out_high);
    REQUIRE((std::isinf(out_low[2]) && std::isinf(out_high[2])));
}

TEST_CASE("eight intervals of angles are hardly wider than one", "[function]")
{
    std::mt19937 random(13);
    std::uniform_real_distribution<double> any(-4.0, 4.0), size(0.0, 3.0);
    for (const char* body : {"sin(x)", "cos(x)", "atan2(x,y)", "sin(1000*x)", "cos(3e5*x)"}) {
        INFO(body);
        const auto f = function_test::compiled(std::string("#declare F=function(x,y){") + body + "}", "F");
        for (int round = 0; round < 500; ++round) {
            double low[2][8], high[2][8], out_low[8], out_high[8];
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    low[i][lane] = any(random);
                    high[i][lane] = low[i][lane] + (round % 2 == 0 ? size(random) : 1e-5);
                }
            function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const Interval box[] = {{low[0][lane], high[0][lane]}, {low[1][lane], high[1][lane]}};
                const Interval one = function::evaluate_interval(*f, box, function::no_host());
                INFO(low[0][lane] << " to " << high[0][lane] << ", " << low[1][lane] << " to " << high[1][lane]);
                REQUIRE(out_low[lane] == Approx(one.low).margin(2e-8));
                REQUIRE(out_high[lane] == Approx(one.high).margin(2e-8));
            }
        }
    }
}

TEST_CASE("eight remainders of a constant divisor hold every remainder and are as narrow as one's", "[function]")
{
    std::mt19937 random(19);
    std::uniform_real_distribution<double> any(-3.0, 3.0), unit(0.0, 1.0);
    for (const char* divisor : {"1", "0.5", "-0.3", "2.7", "0.1", "1e-3", "100"}) {
        INFO(divisor);
        const auto f = function_test::compiled(std::string("#declare F=function(x){mod(x,") + divisor + ")}", "F");
        const double b = std::stod(divisor);
        for (int round = 0; round < 300; ++round) {
            double low[1][8], high[1][8], out_low[8], out_high[8];
            for (std::size_t lane = 0; lane < 8; ++lane) {
                low[0][lane] = round % 3 == 0 ? std::round(10.0 * any(random)) * b : any(random);
                if (round % 5 == 0) low[0][lane] = std::nextafter(low[0][lane], any(random));
                high[0][lane] = low[0][lane] + (round % 2 == 0 ? unit(random) * std::abs(b) : 1e-6);
            }
            function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const Interval box[] = {{low[0][lane], high[0][lane]}};
                const Interval one = function::evaluate_interval(*f, box, function::no_host());
                INFO(low[0][lane] << " to " << high[0][lane] << ": " << out_low[lane] << " to " << out_high[lane]);
                const double room = 1e-14 * std::max(1.0, std::abs(b));
                // But next to a whole number of divisors, where one interval is told by exact remainders.
                const double turns = low[0][lane] / b, end = high[0][lane] / b;
                if (std::abs(turns - std::round(turns)) > 1e-12 && std::abs(end - std::round(end)) > 1e-12) {
                    REQUIRE(out_low[lane] >= one.low - room);
                    REQUIRE(out_high[lane] <= one.high + room);
                }
                for (int k = 0; k < 20; ++k) {
                    const double x = k == 0   ? low[0][lane]
                                     : k == 1 ? high[0][lane]
                                              : low[0][lane] + unit(random) * (high[0][lane] - low[0][lane]),
                                 v = function::evaluate(*f, &x, function::no_host());
                    REQUIRE((out_low[lane] <= v && v <= out_high[lane]));
                }
            }
        }
    }
}

TEST_CASE("eight powers of a constant exponent hold every power and are nearly as narrow as one's", "[function]")
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> any(-3.0, 3.0), unit(0.0, 1.0);
    for (const char* exponent : {"2", "3", "0", "-1", "-2", "0.5", "2.5", "-0.5", "1/3", "7", "40.5"}) {
        INFO(exponent);
        const auto f = function_test::compiled(std::string("#declare F=function(x){pow(x,") + exponent + ")}", "F");
        for (int round = 0; round < 300; ++round) {
            double low[1][8], high[1][8], out_low[8], out_high[8];
            for (std::size_t lane = 0; lane < 8; ++lane) {
                low[0][lane] = round % 3 == 0 ? 0.0 : any(random);
                high[0][lane] = low[0][lane] + (round % 2 == 0 ? unit(random) : 1e-6);
            }
            function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const Interval box[] = {{low[0][lane], high[0][lane]}};
                const Interval one = function::evaluate_interval(*f, box, function::no_host());
                INFO(low[0][lane] << " to " << high[0][lane] << ": " << out_low[lane] << " to " << out_high[lane]);
                // Series end early, with that much room (function/intervals/ends.h): 2.7e-9 at most for 40.5, measured.
                const double room = 3e-9 * std::max(std::abs(one.low), std::abs(one.high));
                REQUIRE(out_low[lane] >= one.low - room - 1e-290);
                REQUIRE(out_high[lane] <= one.high + room + 1e-290);
                for (int k = 0; k < 20; ++k) {
                    const double x = k == 0   ? low[0][lane]
                                     : k == 1 ? high[0][lane]
                                              : low[0][lane] + unit(random) * (high[0][lane] - low[0][lane]),
                                 v = function::evaluate(*f, &x, function::no_host());
                    REQUIRE((std::isnan(v) || (out_low[lane] <= v && v <= out_high[lane])));
                }
            }
        }
    }
}

TEST_CASE("ranges of the library's shapes hold every value and shrink with the box", "[function]")
{
    std::mt19937 random(18);
    std::uniform_real_distribution<double> any(-1.2, 1.2), unit(0.0, 1.0);
    for (const auto& [n, parameters] :
         std::vector<std::pair<std::uint32_t, std::vector<double>>>{{6, {.8, 1, 1, .7, 1.3}},
                                                                    {7, {.5, 3, 1, .4}},
                                                                    {9, {.7}},
                                                                    {10, {.5, 3, 1, .2}},
                                                                    {19, {.5, 3, 1, .2}},
                                                                    {25, {2, 8, .15, .6, 1, .4, 0}},
                                                                    {25, {3, 5, .15, .6, 1, .4, 30}},
                                                                    {25, {1, 5, .15, .6, 1, 1, 30}},
                                                                    {26, {0, 7, .2, .5, 1, .5, 20}},
                                                                    {32, {.5, 3, 1, .2}},
                                                                    {40, {.4, .3, 1, .06, 1}},
                                                                    {51, {.2, .3, .1, -.2, .1}},
                                                                    {52, {5, .8, .1, .3, .1, .2}},
                                                                    {53, {0}},
                                                                    {62, {.5, 3, 1, 2, .3}},
                                                                    {63, {.4, 5, 4, 2}},
                                                                    {68, {.5, .4}},
                                                                    {68, {1.5, 1.2}}}) {
        const auto f = function::make_internal(n);
        INFO("internal " << n);
        REQUIRE(f->parameters == 3 + parameters.size());
        REQUIRE(function::narrows(*f));
        for (int round = 0; round < test::share(400); ++round) {
            const double size = round % 4 == 0 ? 1.0 : round % 4 == 1 ? 0.1 : round % 4 == 2 ? 1e-3 : 1e-7;
            double low[16][8], high[16][8], out_low[8], out_high[8];
            for (std::size_t i = 0; i < f->parameters; ++i)
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    low[i][lane] = i < 3 ? any(random) : parameters[i - 3];
                    high[i][lane] = i < 3 ? low[i][lane] + size * unit(random) : parameters[i - 3];
                }
            function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
            for (std::size_t lane = 0; lane < 8; ++lane) {
                // Slopes of powers reach some hundreds here; seams of angles are rare in boxes so small.
                if (size < 1e-6) REQUIRE(out_high[lane] - out_low[lane] < 1e-4);
                for (int k = 0; k < 30; ++k) {
                    double at[16];
                    for (std::size_t i = 0; i < f->parameters; ++i)
                        at[i] = low[i][lane] +
                                (k < 8 && i < 3 ? (k >> i & 1) : unit(random)) * (high[i][lane] - low[i][lane]);
                    const double v = function::evaluate(*f, at, function::no_host());
                    INFO(at[0] << " " << at[1] << " " << at[2] << ": " << v << " of " << out_low[lane] << " to "
                               << out_high[lane]);
                    REQUIRE((std::isnan(v) || (out_low[lane] <= v && v <= out_high[lane])));
                }
            }
        }
    }
}

TEST_CASE("intervals are narrow where they can be", "[function]")
{
    const auto near = [](const Interval& v, double low, double high) {
        return std::abs(v.low - low) < 1e-8 && std::abs(v.high - high) < 1e-8;
    };
    CHECK(near(over("x*x+1", {1, 2}), 2, 5));
    CHECK(near(over("sin(x)", {0, 3.1}), 0, 1));
    CHECK(near(over("cos(x)", {-0.5, 0.5}), std::cos(0.5), 1));
    CHECK(near(over("abs(x)", {-1, 2}), 0, 2));
    CHECK(near(over("select(x,1,2)", {0.5, 1}), 2, 2));
    CHECK(near(over("select(x,1,2)", {-1, 1}), 1, 2));
    CHECK(near(over("sum(i,1,3,x)", {1, 2}), 3, 6));
}

TEST_CASE("eight intervals are as narrow as one", "[function]")
{
    const auto f = function_test::compiled("#declare F=function{x*x+sqrt(y)*abs(z)-min(x,2)/(y+3)+select(z,x,y)}", "F");
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.5, 3.0);
    for (int round = 0; round < 200; ++round) {
        double low[3][8], high[3][8], out_low[8], out_high[8];
        for (auto& side : low)
            for (double& v : side) v = any(random);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t lane = 0; lane < 8; ++lane) high[i][lane] = low[i][lane] + 0.1 * any(random);
        function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const Interval box[] = {
                {low[0][lane], high[0][lane]}, {low[1][lane], high[1][lane]}, {low[2][lane], high[2][lane]}};
            const Interval one = function::evaluate_interval(*f, box, function::no_host());
            CHECK(out_low[lane] >= one.low - 1e-12);
            CHECK(out_high[lane] <= one.high + 1e-12);
        }
    }
}

TEST_CASE("eight intervals of functions that grow are those of one to the bit", "[function]")
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    for (const char* body : {"acosh(x)", "asin(x)", "asinh(x)", "atan(x)", "atanh(x)", "cosh(x)", "ln(x)", "log(x)",
                             "sinh(x)", "tanh(x)"}) {
        INFO(body);
        const auto f = function_test::compiled(std::string("#declare F=function(x){") + body + "}", "F");
        for (const double scale : {1e-3, 1.0, 400.0, 1e6})
            for (int round = 0; round < 40; ++round) {
                double low[1][8], high[1][8], out_low[8], out_high[8];
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    const double a = scale * any(random), b = scale * any(random);
                    low[0][lane] = lane == 7 ? -INFINITY : std::min(a, b);
                    high[0][lane] = lane == 6 ? INFINITY : lane == 5 ? low[0][lane] : std::max(a, b);
                }
                function::evaluate_intervals(*f, low, high, function::no_host(), out_low, out_high);
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    const Interval box[] = {{low[0][lane], high[0][lane]}};
                    const Interval one = function::evaluate_interval(*f, box, function::no_host());
                    INFO(low[0][lane] << " to " << high[0][lane]);
                    REQUIRE(out_low[lane] == one.low);
                    REQUIRE(out_high[lane] == one.high);
                }
            }
    }
}

TEST_CASE("what does not narrow is known", "[function]")
{
    const auto narrows = [](const std::string& body) {
        return function::narrows(*function_test::compiled("#declare F=function{" + body + "}", "F"));
    };
    CHECK(narrows("sin(x)+select(y,1,z)*pow(x,2)"));
    CHECK_FALSE(function::narrows(*function::make_internal(76)));
    CHECK(function::narrows(*function::make_internal(61)));
    CHECK(function::narrows(*function::make_internal(62)));
    CHECK_FALSE(function::narrows(*function::make_internal(24)));
}
