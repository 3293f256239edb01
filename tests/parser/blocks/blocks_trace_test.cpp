#include "parser/base/queries.h"
#include "tests/parser/blocks/said.h"

#include <catch2/catch.hpp>

#include <string>

// trace() in compiled blocks: the normal is stored on the way, before the statement around it is done.
namespace {

/// Every ray that goes down hits two units on; the normal tells which ray it was.
class Ground final : public parser::SceneQueries {
public:
    parser::ObjectHit trace(const ObjectPtr&, const glm::dvec3& origin, const glm::dvec3& direction,
                            const scene::Description&) override
    {
        if (!(direction.y < 0.0)) return {};
        return {true, origin + 2.0 * direction, -direction};
    }
    bool inside(const ObjectPtr&, const glm::dvec3& point, const scene::Description&) override { return point.y < 0.0; }
    glm::dvec3 turbulence(const glm::dvec3&, int, double, double) override { return glm::dvec3(0.0); }
    csg::Aabb extent(const ObjectPtr&) override { return {glm::dvec3(0.0), glm::dvec3(1.0)}; }
    function::Values evaluate(const function::FunctionPtr&, const double*, const scene::Description&) override
    {
        return {};
    }
    void evaluate(const function::FunctionPtr&, std::span<const glm::dvec3>, std::span<function::Values>,
                  const scene::Description&) override
    {}
};

std::string rays_said(const std::string& text, bool blocks)
{
    Ground ground;
    parser::Options options;
    options.blocks = blocks;
    options.queries = &ground;
    return said::in_full(text, options);
}

/// What is said both ways; `loop` shows P, N and K.
std::string rays_both_ways(const std::string& loop)
{
    const std::string text = "#version 3.7;\n#declare O = sphere { 0, 1 } #declare R = seed(5);\n"
                             "#declare P = <9, 9, 9>; #declare N = <8, 8, 8>; #declare K = 0;\n"
                             "#macro Show() #debug concat(vstr(3, P, \",\", 0, 4), \" \", vstr(3, N, \",\", 0, 4), "
                             "\" \", str(K, 0, 4), \"|\") #end\n" +
                             loop;
    const std::string compiled = rays_said(text, true);
    CHECK(compiled == rays_said(text, false));
    return compiled;
}

}  // namespace

TEST_CASE("a block gives the normal of trace() to its variable", "[parser][blocks]")
{
    const std::string hits = rays_both_ways(
        "#for (I, 0, 9) #declare P = trace(O, <I, 3, rand(R)>, <0, I - 5, 1>, N); #declare K = K + vlength(N); "
        "Show() #end\n");
    CHECK(hits.find("0.0000,0.0000,0.0000 0.0000,0.0000,0.0000") != std::string::npos);  // no hit
    // The same variable on both sides, in the arguments, and as a local of a macro.
    rays_both_ways("#for (I, 1, 6) #declare N = trace(O, N, <I, -1, 0>, N); Show() #end\n");
    rays_both_ways("#for (I, 1, 6) #local N = trace(O, N + I, -N, N); #declare P = N; Show() #end\n");
    rays_both_ways("#macro Far(A, B, Thing) #local N = <0, 0, 0>; #local Hit = trace(Thing, A, B - A, N);\n"
                   "  (vlength(N) & vlength(Hit - A) < vlength(B - A)) #end\n"
                   "#for (I, 1, 8) #local Q = <rand(R), I - 4, 0>; #declare K = K + (Far(P, Q, O) ? 1 : 10); "
                   "#if (K < 30 & !Far(Q, P, O)) #declare P = Q; #end Show() #end\n");
}

TEST_CASE("a normal is put back where a block leaves the statement", "[parser][blocks]")
{
    // What is stored turns into another kind, or fails behind the ray: word by word the ray is asked anew.
    rays_both_ways(
        "#for (I, 1, 7) #if (I = 5) #declare P = 1; #end #declare P = trace(O, N, <I, -1, 0>, N); Show() #end\n");
    rays_both_ways("#macro Half(A) #local H = trace(O, A, <rand(R), -1, 0>, N); (1 / (K - 3)) #end\n"
                   "#for (I, 1, 7) #declare K = I; #declare P = P + Half(N); Show() #end\n");
    rays_both_ways("#for (I, 1, 7) #if (I = 4) #declare N = 2; #end #declare P = trace(O, P, -y, N); Show() #end\n");
    rays_both_ways("#for (I, 1, 7) #if (I = 4) #declare O = 2; #end #declare P = trace(O, P, -y, N); Show() #end\n");
}
