#include "support.h"

#include "function/build/builder.h"
#include "render/texture/function_host.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <random>

using function::kLanes;

namespace {

/// Every lane against the single point, by bits.
void check_lanes(const function::Function& f, std::mt19937& random, double range)
{
    std::uniform_real_distribution<double> any(-range, range);
    constexpr std::size_t kPoints = 2 * kLanes;
    double arguments[64][kPoints], out[std::tuple_size_v<function::Values>][kPoints];
    const double* from[64];
    for (std::uint32_t i = 0; i < f.parameters; ++i) {
        for (double& a : arguments[i]) a = any(random);
        from[i] = arguments[i];
    }
    double* const to[] = {out[0], out[1], out[2], out[3], out[4]};
    const function_test::NoiseHost host;
    function::evaluate_lanes(f, from, kPoints, host, f.components, to);
    for (std::size_t lane = 0; lane < kPoints; ++lane) {
        std::vector<double> one;
        for (std::uint32_t i = 0; i < f.parameters; ++i) one.push_back(arguments[i][lane]);
        const function::Values all = function::evaluate_all(f, one.data(), host);
        REQUIRE((all[0] == function::evaluate(f, one.data(), host) || all[0] != all[0]));
        for (std::size_t k = 0; k < f.components; ++k) {
            const bool same = std::memcmp(&all[k], &out[k][lane], sizeof(double)) == 0 ||
                              (all[k] != all[k] && out[k][lane] != out[k][lane]);
            INFO("lane " << lane << ", component " << k << ": " << out[k][lane] << ", alone " << all[k]);
            REQUIRE(same);
        }
    }
}

}  // namespace

TEST_CASE("eight points in lanes have the bits of eight single points", "[function]")
{
    const std::string auxiliary = "#declare F1=function(q){q*2+1} #declare F2=function(x,y,z){x-y*z} "
                                  "#declare VT=function{transform{translate <1,2,3> scale 2}} "
                                  "#declare SP=function{spline{linear_spline 0,<1,2> 1,<3,5>}} ";
    std::mt19937 random(7);
    for (const auto& row : function_test::table("expressions.csv")) {
        INFO(row[0]);
        check_lanes(*function_test::compiled(auxiliary + "#declare F=function(x,y,z,a,b){" + row[0] + "}", "F"), random,
                    4.0);
    }
    for (const char* body : {"select(x,sin(y),select(z,x*y,exp(z)))", "sum(i,x,y+3,prod(j,0,i,z+j))",
                             "select(x-1,sum(i,0,4,x*i),y)", "sum(i,0,3,select(i-x,i*y,z))"}) {
        INFO(body);
        const auto f = function_test::compiled(std::string("#declare F=function{") + body + "}", "F");
        for (int round = 0; round < 100; ++round) check_lanes(*f, random, 4.0);
    }
}

TEST_CASE("internal functions in lanes", "[function]")
{
    std::mt19937 random(8);
    for (std::uint32_t n = 0; n < 79; ++n) {
        INFO("internal " << n);
        check_lanes(*function::make_internal(n), random, 2.0);
    }
}

TEST_CASE("octaves of f_ridged_mf with constant parameters", "[function]")
{
    std::mt19937 random(9);
    for (const char* parameters :
         {"0.4,2.1,6.5,0.9,1.3,2", "0.1,3,7,0.7,0.7,1", "1,2,1,1,2,3", "-0.5,0.5,4,1,1,x", "0.5,y,3,1,1,2"}) {
        INFO(parameters);
        const std::string body = std::string("R(x,y,z,") + parameters + ")";
        const auto f =
            function_test::compiled("#declare R=function{internal(59)} #declare F=function{" + body + "}", "F");
        for (int round = 0; round < 20; ++round) check_lanes(*f, random, 4.0);
        // Against weights worked out call by call.
        const auto plain = function::make_internal(59);
        const double p[] = {0.3, -1.2, 0.7};
        const std::vector<double> all = parameters == std::string("0.4,2.1,6.5,0.9,1.3,2")
                                            ? std::vector<double>{0.3, -1.2, 0.7, 0.4, 2.1, 6.5, 0.9, 1.3, 2}
                                            : std::vector<double>{};
        if (!all.empty())
            CHECK(function::evaluate(*f, p, function_test::NoiseHost()) ==
                  function::evaluate(*plain, all.data(), function_test::NoiseHost()));
    }
}

TEST_CASE("f_hetero_mf with constant parameters in lanes", "[function]")
{
    std::mt19937 random(12);
    for (const char* parameters : {"1,2,5,0.5,2,2", "0.4,2.1,6.5,0.9,1,3", "0.1,3,7,0.7,0,1", "1,2,1,1,3,2",
                                   "-0.5,0.5,0.3,1,2.7,0", "0.5,2,3.25,-0.2,-1,2", "0.5,y,3,1,1,2", "0.5,2,3,z,1,2"}) {
        INFO(parameters);
        const auto f = function_test::compiled(
            std::string("#declare H=function{internal(29)} #declare F=function{H(x,y,z,") + parameters + ")}", "F");
        for (int round = 0; round < 50; ++round) check_lanes(*f, random, 4.0);
    }
}

TEST_CASE("noise of eight points is that of each", "[function]")
{
    std::mt19937 random(10);
    std::uniform_real_distribution<double> any(-50.0, 50.0);
    const texture::TextureSet set;
    const texture::FunctionHost host(set);
    for (int generator = 0; generator < 4; ++generator)
        for (int round = 0; round < 200; ++round) {
            double x[kLanes], y[kLanes], z[kLanes], out[kLanes];
            for (int i = 0; i < kLanes; ++i) x[i] = any(random), y[i] = any(random), z[i] = any(random);
            host.noises(x, y, z, generator, out);
            for (int i = 0; i < kLanes; ++i) CHECK(out[i] == host.noise({x[i], y[i], z[i]}, generator));
        }
}
