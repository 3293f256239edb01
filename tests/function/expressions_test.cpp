#include "support.h"

#include "function/build/listing.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using function_test::compiled;

namespace {

constexpr double kArguments[] = {0.7, -1.3, 2.2, 0.4, -3.1};
const std::string kAuxiliary = "#declare F1=function(q){q*2+1} #declare F2=function(x,y,z){x-y*z} "
                               "#declare VT=function{transform{translate <1,2,3> scale 2}} "
                               "#declare SP=function{spline{linear_spline 0,<1,2> 1,<3,5>}} ";

double value_of(const std::string& body, std::vector<double> arguments = {})
{
    const auto f = compiled("#declare F=function(x,y,z){" + body + "}", "F");
    arguments.resize(3);
    return function::evaluate(*f, arguments.data(), function::no_host());
}

std::string error_of(const std::string& text)
{
    try {
        compiled(text, "F");
    } catch (const parser::Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("random expressions have the values that POV-Ray prints", "[function]")
{
    int checked = 0;
    for (const auto& row : function_test::table("expressions.csv")) {
        INFO(row[0]);
        const auto f = compiled(kAuxiliary + "#declare F=function(x,y,z,a,b){" + row[0] + "}", "F");
        const double value = function::evaluate(*f, kArguments, function::no_host()), printed = std::stod(row[6]);
        if (std::isnan(printed) || std::isinf(printed)) {
            CHECK((std::isnan(printed) ? std::isnan(value) : value == printed));
        } else {
            CHECK(value == Approx(printed).epsilon(1e-14).margin(6e-16));  // 15 decimals are printed
        }
        ++checked;
    }
    CHECK(checked > 100);
}

TEST_CASE("rounding follows POV-Ray's folding", "[function]")
{
    // Values printed with 17 decimals.
    CHECK(value_of("x*3*7", {0.7}) == 14.69999999999999751);
    CHECK(value_of("x+0.1+0.2", {3.5}) == 3.79999999999999982);
    CHECK(value_of("(x+0.1)+0.2", {3.5}) == 3.80000000000000027);
    CHECK(value_of("x/3", {5}) == 1.66666666666666652);
    CHECK(value_of("x+1+1", {1e16}) == 10000000000000002.0);
    CHECK(value_of("pow(x,5)", {1.1}) == 1.1 * 1.1 * (1.1 * 1.1) * 1.1);
}

TEST_CASE("precedence, signs and calls", "[function]")
{
    CHECK(value_of("x-y-1-2*3/4/2", {10, 3}) == 5.25);
    CHECK(value_of("2*-x", {3}) == -6);
    CHECK(value_of("-x*x", {3}) == -9);
    CHECK(value_of("x|y&0", {1, 1}) == 1);
    CHECK(value_of("x<y<z", {3, 2, 1}) == 1);
    CHECK(value_of("int(3e9*x)", {1}) == -2147483648.0);
    CHECK(value_of("div(x,2)+mod(-5,3)", {-7}) == -5);
    CHECK(value_of("sum(i,0.5,2.6,i)+prod(i,1,0,x)", {9}) == 5.5);
    CHECK(value_of("sum(i,1,3,sum(j,1,i,x*j))", {2}) == 2 * (1 + 3 + 6));
    CHECK(value_of("select(x,1,2)+select(x,10,20,30)", {0}) == 22);
    CHECK(value_of("select(x,1,2)+select(x,10,20,30)", {-1}) == 11);
    CHECK(value_of("select(x,select(y,1,2,3),select(z,4,5,6),7)", {0, 0, 5}) == 6);
}

TEST_CASE("what is no number stays silent and compares as POV-Ray's", "[function]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    CHECK(value_of("1/x", {0}) == infinity);
    CHECK(value_of("ln(x)", {0}) == -infinity);
    CHECK(std::isnan(value_of("sqrt(x)", {-1})));
    CHECK(value_of("min(x,1)", {nan}) == 1);
    CHECK(std::isnan(value_of("min(1,x)", {nan})));
    const auto negative = [](const char* text, double x) { return std::signbit(value_of(text, {x})); };
    CHECK(!negative("min(x,-x)", 0.0));  // of equals the first
    CHECK(negative("min(-x,x)", 0.0));
    CHECK(negative("ceil(x)", -0.4));
    CHECK(!negative("int(x)", -0.4));  // through an integer
    CHECK(!negative("div(x,1)", -0.4));
    CHECK(std::isnan(value_of("max(x,1)", {nan})));
    CHECK(value_of("max(1,x)", {nan}) == 1);
    CHECK(value_of("(x>1)+(x>=1)*2+(x!=1)*4+(x<1)*8+(x<=1)*16+(x=1)*32", {nan}) == 7);
    CHECK(value_of("select(x,1,2,3)", {nan}) == 3);
}

TEST_CASE("parameters: x and u are one, what is none of them is 0", "[function]")
{
    const auto of = [](const std::string& head, const std::string& body, std::vector<double> a) {
        return function::evaluate(*compiled("#declare F=function(" + head + "){" + body + "}", "F"), a.data(),
                                  function::no_host());
    };
    CHECK(of("x,y,z,u", "x", {1, 2, 3, 4}) == 4);
    CHECK(of("a", "x+a", {5}) == 5);
    CHECK(of("u,v", "x+10*y", {1, 2}) == 21);
    CHECK(error_of("#declare F=function(t){1}").find("expected a parameter's name") != std::string::npos);
    CHECK(error_of("#declare a=1; #declare F=function(a){1}").find("cannot be called 'a'") != std::string::npos);
}

TEST_CASE("what POV-Ray refuses is refused", "[function]")
{
    for (const char* body :
         {"x*--y", "!x", "sqr(x)", "<1,2,3>", "x?1:2", "1/0", "min(x)", "sin(x,y)", "vlength(x)", "F(x)", ""}) {
        INFO(body);
        CHECK(error_of(std::string("#declare F=function{") + body + "}") != "no error");
    }
    CHECK(error_of("#declare F=function{x} #declare F=function{y}").find("#undef it first") != std::string::npos);
    CHECK(error_of("#declare F=function{internal(79)}").find("no internal function 79") != std::string::npos);
}

TEST_CASE("equal terms are computed once, constants before the run", "[function]")
{
    CHECK(compiled("#declare F=function{sin(x+y)+sin(x+y)*cos(2)}", "F")->code.size() == 4);
    CHECK(compiled("#declare G=function(a,b){a*b+sin(a)} #declare F=function{G(x,2)+G(x,2)}", "F")->code.size() == 4);
    CHECK(compiled("#declare F=function{sin(1)+2*3}", "F")->code.empty());
}

TEST_CASE("a long chain of functions is called, not copied, and has an end", "[function]")
{
    const std::string chain =
        "#declare A=array[500]; #declare A[0]=function(x,y,z){x*2+sin(y)} #local I=1; #while(I<500) "
        "#declare A[I]=function(x,y,z){A[I-1](y,x,z)+pow(x-I,2)*0.001} #local I=I+1; #end #declare "
        "F=function{A[N](x,y,z)} ";
    const double at[] = {0.5, -0.25, 1.0};
    double expected = 0;
    for (int n = 499; n >= 1; --n) expected += std::pow(((499 - n) % 2 == 0 ? 0.5 : -0.25) - n, 2) * 0.001;
    expected += 2 * -0.25 + std::sin(0.5);
    const auto f = compiled("#declare N=499; " + chain, "F");
    CHECK(function::evaluate(*f, at, function::no_host()) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("what nests too deeply is told", "[function]")
{
    const auto nested = [](std::size_t n) {
        return "#declare F=function{" + std::string(n, '(') + "x" + std::string(n, ')') + "}";
    };
    CHECK(error_of(nested(200)) == "no error");
    CHECK(error_of(nested(20'000)).find("nested too deeply") != std::string::npos);
}

TEST_CASE("a program can be read", "[function]")
{
    using Lines = std::vector<std::string>;
    CHECK(function::listing(*compiled("#declare F=function{x*2+sin(y)}", "F")) ==
          Lines{"r0 = multiply p0 2", "r1 = sin p1", "r2 = add r0 r1", "result r2"});
    CHECK(function::listing(*compiled("#declare F=function{select(x,-y,sum(i,1,z,i*x))}", "F")) ==
          Lines{"r0 = select p0 [1, 2) r1 [2, 4) r3", "r1 = negate p1", "r3 = loop sum r2 from 1 to p2 [3, 4) r4",
                "r4 = multiply p0 r2", "result r0"});
}
