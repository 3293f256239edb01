#include "support.h"

#include "csg/freeform/field/isosurface.h"
#include "function/build/builder.h"
#include "function/field/field.h"
#include "function/internal/internal.h"
#include "function/internal/internal_ranges.h"
#include "function/line/along_line.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <random>

namespace {

using function::FunctionField;
using function::FunctionPtr;

double uniform(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A polynomial of x, y and z as text, of no more than this degree.
std::string polynomial_text(std::mt19937& random, int degree, int depth)
{
    const auto pick = random() % (depth == 0 ? 2u : 8u);
    if (degree == 0 || pick == 0) return fmt::format("({:.3f})", uniform(random, -2.0, 2.0));
    const auto other = [&](int most) { return polynomial_text(random, most, depth - 1); };
    switch (pick) {
    case 1: return std::string(1, "xyz"[random() % 3]);
    case 2: return "(" + other(degree) + "+" + other(degree) + ")";
    case 3: return "(" + other(degree) + "-" + other(degree) + ")";
    case 4: return "(-" + other(degree) + ")";
    case 5: return "(" + other(degree) + fmt::format("/{:.3f})", uniform(random, 0.5, 3.0));
    case 6:
        if (degree >= 2) {
            const int exponent = degree >= 6 && random() % 2 != 0 ? 3 : 2;
            return fmt::format("pow({},{})", other(degree / exponent), exponent);
        }
        [[fallthrough]];
    default: {
        const int left = degree / 2;
        return "(" + other(left) + "*" + other(degree - left) + ")";
    }
    }
}

glm::dvec3 point(std::mt19937& random, double range)
{
    return {uniform(random, -range, range), uniform(random, -range, range), uniform(random, -range, range)};
}

/// Whether the polynomial is known; its values against the function's own.
bool check_along(const function::Function& f, std::mt19937& random, double range)
{
    const csg::FieldStretch stretch{point(random, range), point(random, range), glm::dvec3(0.0)};
    csg::FieldPolynomial along;
    if (!function::evaluate_along(f, stretch, along)) return false;
    for (int k = 0; k <= 20; ++k) {
        const double s = k / 20.0;
        double v = 0.0;
        for (int i = along.degree; i >= 0; --i) v = v * s + along.c[static_cast<std::size_t>(i)];
        const glm::dvec3 p = stretch.from + s * stretch.way;
        const double exact = function::evaluate(f, &p.x, function::no_host());
        // Horner's rule and the point itself are rounded too.
        const double room = 4.0 * along.error + 1e-14 * along.size;
        INFO("s " << s << ": " << v << ", " << exact << ", degree " << along.degree);
        if (std::abs(v) < along.limit + room)
            REQUIRE(std::abs(std::clamp(v, -along.limit, along.limit) - exact) <= room);
        else REQUIRE(exact == std::copysign(along.limit, v));
    }
    return true;
}

/// A field that does not say that it is a polynomial.
class Hidden final : public csg::Field {
public:
    explicit Hidden(std::shared_ptr<const csg::Field> of) : of_(std::move(of)) {}
    double value(const glm::dvec3& p) const override { return of_->value(p); }
    void values(const csg::EightPoints& p, csg::Eight& out) const override { of_->values(p, out); }
    void ranges(const csg::EightBoxes& b, csg::EightRanges& out) const override { of_->ranges(b, out); }
    bool ranged() const override { return of_->ranged(); }

private:
    std::shared_ptr<const csg::Field> of_;
};

std::vector<double> crossings(const csg::Isosurface& surface, const csg::Ray& ray, bool first)
{
    csg::IntersectionList list(0.0, numbers::kInfinity, first);
    surface.intersect(ray, list);
    std::vector<double> out;
    list.each_span([&](double in, std::uint32_t, double end, std::uint32_t) {
        out.push_back(in);
        out.push_back(end);
    });
    return out;
}

/// The same crossings to the bit as by ranges; how many there were.
std::size_t check_surface(const FunctionPtr& f, std::mt19937& random, int rays, double threshold)
{
    csg::IsosurfaceTerms terms;
    terms.field = std::make_shared<FunctionField>(f);
    REQUIRE(terms.field->polynomial());
    terms.threshold = threshold;
    terms.max_trace = 5;
    terms.container = csg::Container::box(glm::dvec3(-1.5), glm::dvec3(1.5));
    const csg::Isosurface known(terms);
    terms.field = std::make_shared<Hidden>(terms.field);
    const csg::Isosurface hidden(terms);
    std::size_t count = 0;
    for (int i = 0; i < rays; ++i) {
        const double away = i % 10 == 0 ? 1e7 : i % 3 == 0 ? 0.5 : 5.0;
        const glm::dvec3 way = glm::normalize(point(random, 1.0)), middle = point(random, 1.5);
        const csg::Ray ray{middle - away * way, way};
        const bool first = i % 2 == 0;
        const std::vector<double> wanted = crossings(hidden, ray, first);
        INFO("ray " << i);
        REQUIRE(crossings(known, ray, first) == wanted);
        count += wanted.size();
    }
    return count;
}

FunctionPtr declared(const std::string& body)
{
    return function_test::compiled("#declare F=function(x,y,z){" + body + "}", "F");
}

/// The library's function n at a place, with a strength up to that and any other parameters.
FunctionPtr library(std::uint32_t n, std::mt19937& random, const std::string& place, double strength)
{
    std::string call = "P(" + place + fmt::format(",{:.3f}", uniform(random, -strength, strength));
    for (std::uint32_t i = 1; i < function::internal_parameters(n); ++i)
        call += fmt::format(",{:.3f}", uniform(random, -2.0, 2.0));
    return function_test::compiled(
        fmt::format("#declare P=function{{internal({})}} #declare F=function{{{})}}", n, call), "F");
}

}  // namespace

TEST_CASE("polynomials along a line have the function's values", "[function]")
{
    std::mt19937 random(31);
    int known = 0;
    for (int round = 0; round < 400; ++round) {
        const std::string body = polynomial_text(random, 7, 5);
        INFO(body);
        const FunctionPtr f = declared(body);
        for (int k = 0; k < 3; ++k) known += check_along(*f, random, 2.0) ? 1 : 0;
    }
    CHECK(known == 1200);
}

TEST_CASE("the library's polynomials along a line", "[function]")
{
    std::mt19937 random(32);
    for (std::uint32_t n = 0; n < 79; ++n) {
        if (!function::is_polynomial(n)) continue;
        INFO(n);
        for (int k = 0; k < 20; ++k) CHECK(check_along(*library(n, random, "x,y,z", 1.0), random, 1.0));
    }
}

TEST_CASE("what is no polynomial of a low degree is none along a line", "[function]")
{
    const std::string library = "#declare P=function{internal(35)} #declare G=function(a){a*a} ";
    csg::FieldPolynomial unused;
    const csg::FieldStretch stretch{glm::dvec3(0.1), glm::dvec3(1.0, 0.5, 0.2), glm::dvec3(0.0)};
    const auto known = [&](const std::string& body) {
        const FunctionPtr f = function_test::compiled(library + "#declare F=function(x,y,z){" + body + "}", "F");
        return function::evaluate_along(*f, stretch, unused);
    };
    for (const char* body : {"abs(x)", "sqrt(x*x)", "pow(x,8)", "pow(x,-1)", "pow(x,0.5)", "pow(x,y)", "1/x", "x/(y-y)",
                             "max(x,y)", "select(x,y,z)", "P(x,y,z,1)+x", "sin(x)"})
        CHECK_FALSE(known(body));
    for (const char* body : {"G(x)-G(y)", "P(x,y,z,1)", "pow(x,7)", "x/4", "3", "-P(z,x,y,-1)", "pow(G(x),3)"}) {
        INFO(body);
        CHECK(known(body) == (std::string(body) != "-P(z,x,y,-1)"));  // cut off before its sign is turned
    }
}

TEST_CASE("an isosurface of a polynomial has the crossings that its ranges find", "[function]")
{
    std::mt19937 random(33);
    std::size_t count = 0;
    for (int round = 0; round < 60; ++round) {
        const std::string body = polynomial_text(random, 6, 5);
        INFO(body);
        count += check_surface(declared(body), random, 40, uniform(random, -0.5, 0.5));
    }
    for (const char* body : {"x*x+y*y+z*z-1", "pow(x*x+y*y+z*z-1,2)", "pow(x*x+y*y+z*z-1,2)-1e-6", "x*y*z", "x*x*x-y",
                             "0*x", "pow(x,7)", "pow(x*y,3)", "1e8*(x*x+y*y-0.5)", "1e-8*(x*x+y*y-0.5)",
                             "pow(x,4)-5*x*x+pow(y,4)-5*y*y+pow(z,4)-5*z*z+11.8"}) {
        INFO(body);
        count += check_surface(declared(body), random, 200, 0.0);
    }
    for (const std::uint32_t n : {8u, 13u, 23u, 35u}) {
        INFO(n);
        count += check_surface(library(n, random, "x*2,y*2,z*2", 1.0), random, 200, 0.0);
    }
    CHECK(count > 2000);
}
