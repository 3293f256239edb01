#include "parser/parse.h"
#include "render/scene/description.h"

#include <catch2/catch.hpp>

// Objects in loops and macros are made from recipes (docs/blocks.md): they are those that reading them word by word
// makes, and so are the messages. fuzz_blocks of tests/fuzz compares programs that nobody wrote.
namespace {

std::string made_by(const std::string& text, bool blocks)
{
    std::string said;
    parser::Options options;
    options.blocks = blocks;
    const auto keep = [](void* to, const parser::Message& message) {
        *static_cast<std::string*>(to) += message.text + "\n";
    };
    try {
        said += scene::dump(parser::parse_text(text, "t.pov", options, keep, &said).scene);
    } catch (const parser::Error& error) {
        said += error.what();
    }
    return said;
}

/// What both ways make.
std::string made_both_ways(const std::string& body)
{
    const std::string text = "#version 3.7;\n#declare S=seed(3);#declare Ball=sphere{0,1 pigment{rgb .5}}\n"
                             "#declare Paint=texture{pigment{granite}}#declare Shine=finish{phong .5}\n"
                             "#declare Move=transform{rotate y*20 translate x}\n" +
                             body;
    const std::string made = made_by(text, true);
    CHECK(made == made_by(text, false));
    return made;
}

std::size_t count(const std::string& text, const std::string& word)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("objects in loops are those that are read word by word", "[parser][blocks]")
{
    const char* const kObjects[] = {
        "sphere{<I,rand(S),2> rand(S)}",
        "box{<1,I,0>,<0,0,2> pigment{rgb <rand(S),I/9,.3>} finish{Shine} translate x*I}",
        "cylinder{<I,0,0>,y,.5 open texture{Paint} scale <1,2,3>}",
        "cone{0,.5,<0,I+1,0>,.2 texture{pigment{rgbt <I,0,1,.5>} finish{phong I}} rotate I}",
        "cone{0,.5,<0,I+1,0>,.2 texture{pigment{rgb <I,0,1>} finish{Shine} normal{bumps .2}} rotate I}",
        "torus{I+2,.5 no_shadow hollow no_image}",
        "disc{<0,I,0>,y,2 transform{Move}}",
        "plane{<I+1,1,0>,I pigment{checker} transform Move}",
        "triangle{<0,0,0>,<1,0,0>,<0,1,0>}",
        "triangle{<0,I,0>,<1,0,0>,<0,1,3> texture{Paint} texture{pigment{rgbt <I,1,0,.8>}}}",
        "smooth_triangle{0,x,<1,I,0>,y,<0,0,2>,z}",
        "object{Ball scale I+1 translate <rand(S),0,0>}",
        "Ball",
        "union{sphere{I,1} box{0,<1,2,I>} Ball pigment{rgb <I,0,0>} rotate y*rand(S)}",
        "difference{box{-1,1} object{Ball translate x*I} merge{sphere{0,.2} sphere{<I,0,0>,.2}}}",
        "union{#for(J,1,4)sphere{<I,J,0>,.4 pigment{rgb <J,I,0>}}#end pigment{rgb 1}}",
        "blob{threshold .5 #for(J,1,4)sphere{<I,J,0>,1,.7 pigment{rgb J/4}} cylinder{0,<1,J,I>,1,strength "
        "1 scale 2} component 1 .5 <I,J,0> #end}",
        "mesh{#for(J,1,4)triangle{<0,0,0>,<J,1,I>,y uv_vectors <0,0>,<1,0>,<J,1>} "
        "smooth_triangle{x,y,y*J,z,z,<I,J,0>}#end}",
    };
    for (const char* const object : kObjects) {
        INFO(object);
        const std::string made = made_both_ways(std::string("#for(I,0,6)\n") + object + "\n#end");
        CHECK(made.find("error") == std::string::npos);
        made_both_ways(std::string("#macro M(I)") + object + "#end\n#declare I=0;#while(I<7)M(I)#declare I=I+1;#end");
    }
}

TEST_CASE("what has to be said of an object in a loop is said", "[parser][blocks]")
{
    CHECK(count(made_both_ways("#for(I,0,6)\ncylinder{<0,1,0>,<0,min(I,4)-3,0>,1}\n#end"), "ends are the same point") ==
          1);
    CHECK(count(made_both_ways("#for(I,0,6)\nplane{<I-4,0,0>,1}\n#end"), "normal is zero") == 1);
    CHECK(count(made_both_ways("#for(I,0,6)\nsphere{0,1 scale <1,I-4,1>}\n#end"), "scale by 0") == 1);
    CHECK(count(made_both_ways("#for(I,0,6)\ntriangle{0,x,x*I}\n#end"), "on a line") == 1);
    CHECK(count(made_both_ways("#for(I,0,6)\nsphere{0,1/(I-4)}\n#end"), "division by zero") == 1);
    CHECK(count(made_both_ways("#for(I,0,6)\nsphere{<0,I,0>,V}\n#if(I=4)#declare V=x;#else#declare V=1;#end\n#end"),
                "error") >= 1);
    made_both_ways("#declare O=Ball;#for(I,0,9)\nobject{O translate x*I}\n#if(I=4)#declare O=<1,2>;#end\n#end");
    made_both_ways(
        "#declare P=Paint;#for(I,0,9)\nsphere{I,1 texture{P}}\n#if(I=4)#declare P=texture{pigment{rgb I}}#end\n#end");
    made_both_ways("#declare C=rgb x;#for(I,0,9)\nsphere{I,1 pigment{C}}\n#if(mod(I,3)=0)#declare C=rgb I;#end\n#end");
}

TEST_CASE("random numbers are set back where an object in a loop is left to its tokens", "[parser][blocks]")
{
    // The first texture is read by itself on the way, the second cannot follow it.
    const std::string text = "#declare R = seed(4); #declare B = .5; #declare Paint = texture { pigment { rgb 1 } }\n"
                             "#for (I, 1, 3) union { #for (J, 1, 6)\n"
                             "object { sphere { J*x, rand(R) } texture { pigment { rgb I } normal { dents B } }\n"
                             "texture { Paint finish { phong I } } }\n"
                             "#end } #debug concat(str(rand(R), 0, 6), \" \") #end\n";
    CHECK(made_by("#version 3.7;\n" + text, true) == made_by("#version 3.7;\n" + text, false));
}

TEST_CASE("an object in a loop stands where an object may stand only", "[parser][blocks]")
{
    CHECK(made_both_ways("#macro M()#for(I,0,6)sphere{I,1}#end 3 #end\nsphere{0,M()}").find("error") !=
          std::string::npos);
    CHECK(made_both_ways("#macro M()#for(I,0,6)sphere{I,1}#end 3 #end\n#for(K,0,5)#declare A=M();#end").find("error") !=
          std::string::npos);
    CHECK(made_both_ways("sphere{0,1 #for(I,0,6)sphere{I,1}#end}").find("error") != std::string::npos);
    CHECK(made_both_ways("#for(I,0,6)sphere{I,1,2}#end").find("error") != std::string::npos);
    CHECK(made_both_ways("blob{#for(I,0,6)box{I,1}#end}").find("error") != std::string::npos);
    CHECK(made_both_ways("#macro M(A)sphere{A,1}#end#for(I,0,6)M(I)#end blob{threshold .5 #for(I,0,6)M(I)#end}")
              .find("error") != std::string::npos);
    // Each in its own way: a component of a blob has a strength.
    made_both_ways("#macro M(A)sphere{A,1}#end#macro N(A)sphere{A,1,1}#end#for(I,0,6)M(I)#end blob{threshold .5 "
                   "#for(I,0,6)N(I)#end}#for(I,0,6)M(I)#end");
}

TEST_CASE("splines are asked in compiled expressions", "[parser][blocks]")
{
    made_both_ways(
        "#declare C=spline{cubic_spline 0,<0,1>,1,<2,3>,2,<5,1>,4,<1,0>}#declare D=spline{0,1 1,<2,3,4,5,6>}"
        "#for(I,0,9)#declare A=C(I/2)+C(I/3,linear_spline)*2;sphere{<A.x,A.y,C(I,natural_spline).y>,D(I/9).z}"
        "sphere{0,D(I/9,quadratic_spline).transmit}#end");
}
