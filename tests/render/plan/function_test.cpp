#include "parser/parse.h"
#include "parser/base/queries.h"
#include "render/plan/probe.h"

#include <catch2/catch.hpp>

#include <sstream>
#include <stdexcept>
#include <string>

namespace {

struct Queries final : parser::SceneQueries {
    parser::ObjectHit trace(const ObjectPtr& object, const glm::dvec3& origin, const glm::dvec3& direction,
                            const scene::Description& so_far) override
    {
        const auto answer = plan::ObjectProbe(*object, so_far.global).trace(origin, direction);
        return {answer.hit, answer.point, answer.normal};
    }
    bool inside(const ObjectPtr& object, const glm::dvec3& point, const scene::Description& so_far) override
    {
        return plan::ObjectProbe(*object, so_far.global).inside(point);
    }
    csg::Aabb extent(const ObjectPtr&) override { return {}; }
    glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega) override
    {
        return plan::turbulence(point, octaves, lambda, omega);
    }
    function::Values evaluate(const function::FunctionPtr& called, const double* arguments,
                              const scene::Description& so_far) override
    {
        return plan::FunctionProbe(called, so_far).evaluate(arguments);
    }
    void evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                  std::span<function::Values> values, const scene::Description& so_far) override
    {
        for (std::size_t i = 0; i < points.size(); ++i) values[i] = evaluate(called, &points[i].x, so_far);
    }
};

std::string debug_of(const std::string& text, parser::Options options = {})
{
    Queries queries;
    options.queries = &queries;
    std::string all;
    for (const parser::Message& message : parser::parse_text(text, "test.pov", options).messages)
        if (message.severity == parser::Severity::Debug) all += message.text;
    return all;
}

}  // namespace

// Expected texts are what POV-Ray 3.7.0.10 printed.
TEST_CASE("functions made of patterns", "[plan][function]")
{
    CHECK(debug_of("#declare F=function{pattern{cells}} #debug str(F(.5,.5,.5),0,10)") == "0.7118189153");
    CHECK(debug_of("#declare F=function{pattern{gradient x}} #debug "
                   "concat(str(F(1,0,0),0,6),str(F(2,0,0),0,6),str(F(-.25,0,0),0,6))") == "1.0000000.0000000.750000");
    // lambda and omega are in single precision.
    CHECK(debug_of("#debug vstr(3,vturbulence(2.3,.7,5,<1.3,2.7,3.1>),\" \",0,7)") ==
          "-0.2029233 0.0076947 -0.0360532");
    // However many waves the scene has, functions in the text use 10.
    CHECK(debug_of(
              "global_settings{number_of_waves 3} #declare F=function{pattern{ripples}} #debug str(F(.3,.4,.5),0,9)") ==
          "0.273188179");
}

TEST_CASE("functions made of pigments, alone and within others", "[plan][function]")
{
    CHECK(
        debug_of("#declare F=function{pigment{gradient x color_map{[0 rgb 0][1 rgb <1,.5,.25>]}}} #declare V=F(.5,0,0);"
                 "#debug vstr(5,V,\" \",0,4) #debug concat(\" \",str(F(.5,0,0).green,0,4))") ==
        "0.5000 0.2500 0.1250 0.0000 0.0000 0.2500");
    CHECK(debug_of("#declare F=function{pigment{rgb <.5,.25,1>}} #declare "
                   "G=function{F(x,y,z).red+10*F(x,y,z).y+100*F(z,y,x).blue}"
                   "#debug str(G(1,2,3),0,3)") == "103.000");
}

TEST_CASE("noise follows the generator of the scene", "[plan][function]")
{
    const std::string noise = "#declare N=function{internal(76)} #debug str(N(.5,.25,-.125),0,9)";
    const std::string two = debug_of("global_settings{noise_generator 2}" + noise),
                      three = debug_of("global_settings{noise_generator 3}" + noise);
    CHECK(two == "0.334707373");
    CHECK(three != two);
}

TEST_CASE("the generator of noise asked while the text is read follows #version", "[plan][function]")
{
    const std::string bozo = "#declare B=function{pattern{bozo}} ",
                      print = " #debug concat(str(B(1.3,2.16,.55),0,6),\" \")";
    CHECK(debug_of("#version 3.1;" + bozo + print + "#version 3.7;" + print + "#version 3.1;" + print) ==
          "0.254745 0.395394 0.254745 ");
    CHECK(debug_of("#version 3.1; global_settings{noise_generator 2}" + bozo + print + "#version 3.7;" + print) ==
          "0.395394 0.395394 ");
    CHECK(debug_of("#version 3.1; #declare P=function{pigment{bozo color_map{[0 rgb 0][1 rgb 1]}}} #debug "
                   "str(P(1.3,2.16,.55).red,0,6)") == "0.254745");
    // A version given beside the text does not count until the picture is made.
    parser::Options options;
    options.version = 310;
    CHECK(debug_of(bozo + print, options) == "0.395394 ");
}

TEST_CASE("so does an isosurface made of noise", "[plan][function]")
{
    const std::string surface = "#declare N=function{internal(76)} #declare I=isosurface{function{y-N(x,0,z)} "
                                "contained_by{box{-2,2}} max_gradient 4}";
    const std::string print =
        "#debug concat(str(trace(I,<.3,3,.4>,-y).y,0,2),\" \",str(inside(I,<.3,.45,.4>),0,0),\"; \")";
    CHECK(debug_of(surface + print + "#version 3.1;" + print + "global_settings{noise_generator 3}" + print) ==
          "0.49 1; 0.44 0; 0.69 1; ");
}

// In a loop they are compiled at the second pass: written out pass by pass they are not.
TEST_CASE("trace and inside answer in a loop as outside of one", "[plan][function]")
{
    const std::string head = "#version 3.7; #declare S=sphere{0,1} #declare B=box{-1,<1,1,.5>} #declare O=object{S} "
                             "#declare N=<9,9,9>; #declare I=0;";
    for (const std::string body : {
             "#declare P=trace(O,<.1*I,.2,-3>,z,N); #debug concat(vstr(3,P,\" \",0,9),\"/\",vstr(3,N,\" \",0,9),\";\")",
             "#declare P=trace(O,<.1*I,.2,-3>,z).z+I; #debug str(P.x,0,9)",
             "#declare P=trace(O,<.1*I,.2,-3>,<.1,0,1>,N)+N; #debug vstr(3,P,\" \",0,9)",
             "#declare P=trace(O,<.7*I,.2,-3>,z,N); #debug concat(str(P.z,0,9),str(vlength(N),0,3),\";\") #if (I=1) "
             "#declare O=object{B} #end",
             "#if (inside(O,<.35*I,.5,.5>)) #debug \"in \" #else #debug \"out \" #end #if (I=1) #declare O=object{B "
             "rotate 20*y} #end",
             "#local P=trace(O,<.1*I,.2,-3>,z,N); #debug vstr(3,P+N,\" \",0,9) #if (I=2) #undef N #declare N=<1,2,3>; "
             "#end",
         }) {
        INFO(body);
        std::string unrolled = head;
        for (int pass = 0; pass < 4; ++pass) unrolled += body + " #declare I=I+1; ";
        const std::string told = debug_of(unrolled);
        CHECK(told.size() > 8);
        CHECK(debug_of(head + "#while (I<4) " + body + " #declare I=I+1; #end") == told);
    }
}

// The last bit of a ray tells whether its first look, on the sphere around the set, is within: the steps begin
// otherwise.
TEST_CASE("a julia's steps begin where POV-Ray's do", "[plan][julia]")
{
    const struct {
        std::string function, moved, ray;
        glm::dvec3 met37, met38;
    } rows[] = {
        {"sqr",
         "",
         "<.764,-3.736,-4.632>,<-.692,3.651,4.299>",
         {0.12022783796694822, -0.339450630660879, -0.6326119586992917},
         {0.12022783796694822, -0.339450630660879, -0.6326119586992917}},
        {"sqr",
         "",
         "<-2.788,.474,5.292>,<1.847,.122,-4.578>",
         {-0.7019702500599037, 0.6117886461790426, 0.12153752288805594},
         {-0.7019702415569067, 0.6117886467406913, 0.12153750181240867}},
        {"sqr",
         "rotate <10,95,-53>",
         "<-.23,-5.961,-.644>,<-.677,6.253,.508>",
         {-0.8255692911628629, -0.4601214510467097, -0.19710310205209144},
         {-0.8255692911628629, -0.4601214510467097, -0.19710310205209144}},
    };
    for (const auto& row : rows) {
        INFO(row.function << ' ' << row.moved << ' ' << row.ray);
        for (const scene::PovRay version : {scene::PovRay::V37, scene::PovRay::V38}) {
            parser::Options options;
            options.povray = version;
            const std::string told = debug_of("#declare J=julia_fractal{<-.2,.3,-.2,.1> hypercomplex " + row.function +
                                                  " max_iteration 6 precision 23 " + row.moved +
                                                  "} #declare P=trace(J," + row.ray + "); #debug vstr(3,P,\" \",0,15)",
                                              options);
            std::istringstream from(told);
            glm::dvec3 met(0.0);
            from >> met.x >> met.y >> met.z;
            CHECK(glm::distance(met, version == scene::PovRay::V37 ? row.met37 : row.met38) < 1e-11);
        }
    }
}

TEST_CASE("a julia is turned inside out from POV-Ray 3.8 on", "[plan][julia]")
{
    for (const scene::PovRay version : {scene::PovRay::V37, scene::PovRay::V38}) {
        parser::Options options;
        options.povray = version;
        CHECK(debug_of("#declare J=julia_fractal{<-.2,.3,-.2,.1> hypercomplex sqr max_iteration 6 inverse} #debug "
                       "concat(str(inside(J,0),0,0),str(inside(J,1.5*x),0,0))",
                       options) == (version == scene::PovRay::V37 ? "10" : "01"));
    }
}
