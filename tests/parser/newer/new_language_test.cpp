#include "tests/parser/stream_support.h"

#include <catch2/catch.hpp>

// What version 3.8 adds to the language, and that its words are names in scenes that declare them.
namespace {

std::string said(const std::string& text)
{
    try {
        return parser_test::debug_of("#version 3.8;\n" + text);
    } catch (const parser::Error& error) {
        const std::string all = error.what();
        return all.substr(0, all.find('\n'));
    }
}

}  // namespace

TEST_CASE("the words of 3.8 are words until a scene declares them", "[parser][language]")
{
    CHECK(parser_test::debug_of("#declare tau = 1; #declare optional = 2; #declare dictionary = 3; #debug "
                                "str(tau+optional+dictionary,0,0)") == "6");
    CHECK(said("#debug str(tau,0,9)") == "6.283185307");
    CHECK(said("#declare tau = 1; #debug str(tau,0,0)") == "1");
    CHECK(said("#declare F = function(x) { x*tau }; #debug str(F(2),0,6)") == "12.566371");
    CHECK(parser_test::debug_of(
              "#debug str(tau,0,2) #declare tau = 1; #debug str(tau,0,2) #undef tau #debug str(tau,0,2)") ==
          "6.281.006.28");
    CHECK(parser_test::debug_of("#macro M(tau, optional) #debug str(tau+optional,0,0) #end M(1, 2) M(3, 4)") == "37");
    CHECK(parser_test::debug_of("#macro M(tau) #debug str(tau,0,2) #end M(1) #debug str(tau,0,2)") == "1.006.28");
    CHECK(parser_test::debug_of("#for(tau,1,3) #debug str(tau,0,0) #end #declare steps = 4; #debug str(steps,0,0)") ==
          "1234");
    CHECK(parser_test::debug_of("#declare F = function(tau) { 2*tau }; #debug str(F(2),0,0)") == "4");
    CHECK(parser_test::debug_of("#declare C = rgb <1,1,1>; #debug str(C.grey,0,2)") == "1.00");
    CHECK(parser_test::debug_of("#ifdef(tau) #debug \"y\" #else #declare tau = 3; #debug str(tau,0,0) #end") == "3");
}

TEST_CASE("the language before 3.8 can be asked for", "[parser][language]")
{
    parser::Options options;
    options.povray = scene::PovRay::V37;
    const auto error = [&](const std::string& text) {
        try {
            parser_test::debug_of(text, options);
        } catch (const parser::Error& failed) {
            return std::string(failed.what());
        }
        return std::string();
    };
    CHECK(error("#declare A = tau;")
              .find("'tau' is not declared; 'tau' is a word of POV-Ray 3.8, and --povray=3.7 asks for") !=
          std::string::npos);
    CHECK(error("#declare tau = 3; #debug str(tau,0,0)").empty());
}

TEST_CASE("#version 3.8 may stand anywhere", "[parser][language]")
{
    CHECK(said("#debug str(version,0,2)") == "3.80");
    CHECK(parser_test::debug_of("#declare A = 1; #version 3.7; #version 3.8; #debug str(version,0,2)") == "3.80");
    // An include comes back at its end to the version that it found.
    CHECK(said("#declare Before = version; #version 3.5; #debug str(version,0,2) #version Before; #debug "
               "str(version,0,2)") == "3.503.80");
    CHECK(parser_test::error_of("#version 3.9;").find("later version of the language than 3.8") != std::string::npos);
}

TEST_CASE("dictionaries hold members of any type", "[parser][language]")
{
    const std::string made =
        "#declare D = dictionary { .Size: 3, [\"Name\"]: \"ball\", .At: <1,2,3>, .Inner: dictionary { .Deep: 7 } }\n";
    CHECK(
        said(made +
             "#debug "
             "concat(str(D.Size,0,0),D.Name,str(D[\"Size\"]+1,0,0),vstr(3,D.At,\",\",0,0),str(D.Inner.Deep*2,0,0))") ==
        "3ball41,2,314");
    CHECK(said(made + "#declare D.Size = 9; #declare D.New = \"x\"; #debug concat(str(D.Size,0,0),D.New)") == "9x");
    CHECK(said(made + "#undef D.Size #ifdef(D.Size) #debug \"yes\" #else #debug \"no\" #end #ifdef(D.Name) #debug "
                      "\"yes\" #end") == "noyes");
    CHECK(said(made + "#declare E = D; #declare E.Size = 1; #debug str(D.Size,0,0)") == "3");
    CHECK(said(made + "#debug str(D.Nothing,0,0)").find("error: ") != std::string::npos);
    CHECK(said("#macro M(T) #declare T.A = 5; #end #declare D = dictionary; M(D) #debug str(D.A,0,0)") == "5");
}

TEST_CASE("optional parameters may be left out", "[parser][language]")
{
    const std::string macro =
        "#macro M(A, optional B) #ifdef(local.B) #debug str(A+B,0,0) #else #debug str(A,0,0) #end #debug \" \" #end\n";
    CHECK(said(macro + "M(1) M(1,) M(1,2) M(1,Unknown)") == "1 1 3 1 ");
    CHECK(said("#declare B = 5;\n" + macro + "M(1)") == "1 ");
    CHECK(said("#macro M(A) #end M()").find("error: expected argument 'A' of macro M") != std::string::npos);
}

TEST_CASE("scopes by name", "[parser][language]")
{
    CHECK(
        said("#declare X = 1; #macro M() #local X = 2; #debug concat(str(X,0,0),str(local.X,0,0),str(3*global.X,0,0)) "
             "#declare global.X = 9; #end M() #debug str(X,0,0)") == "2239");
    CHECK(said("#macro M() #ifdef(local.X) #debug \"l\" #end #ifdef(global.X) #debug \"g\" #end #end #declare X = 1; "
               "M()") == "g");
    CHECK(said("#declare S = \"text\"; #debug global.S #declare global[\"N\"] = 3; #debug str(N,0,0)") == "text3");
    CHECK(said("#macro M() #declare local[concat(\"Q\",\"1\")] = 3; #debug str(Q1,0,0) #end M() #ifdef(Q1) #debug "
               "\"y\" #end") == "3");
    CHECK(
        said("#declare F = function(x) {3*x} #declare V = array[2] {\"a\",\"b\"}; #debug concat(str(global.F(2),0,0), "
             "local.V[1])") == "6b");
}

TEST_CASE("several names are assigned at once", "[parser][language]")
{
    CHECK(said("#declare (A, B) = (1, \"two\"); #debug concat(str(A,0,0),B)") == "1two");
    CHECK(said("#declare A = 1; #declare B = 2; #declare (A, B) = (B, A); #debug concat(str(A,0,0),str(B,0,0))") ==
          "22");  // one after the other, as in POV-Ray
    CHECK(said("#declare (A, B) = (1, 2) #debug str(A+B,0,0)") == "3");
    CHECK(said("#declare V = array[3] {4,5,6}; #declare { A, , C } = V; #debug concat(str(A,0,0),str(C,0,0))") == "46");
    CHECK(said("#declare A = 1; #declare (optional A, B) = (, 2); #debug concat(str(A,0,0),str(B,0,0))") == "12");
    CHECK(said("#declare (A, B) = (1);").find("error: ") != std::string::npos);
}

TEST_CASE("arrays grow, mix types, have gaps", "[parser][language]")
{
    CHECK(said("#declare A = array; #declare A[0] = 1; #declare A[1] = 2; #debug "
               "concat(str(A[1],0,0),str(dimension_size(A,1),0,0))") == "22");
    CHECK(said("#declare A = array {1,2,3}; #for(I,3,40) #declare A[I] = I*I; #end #debug "
               "str(A[40]+dimension_size(A,1),0,0)") == "1641");
    CHECK(said("#declare A = array; #declare A[3] = 1; #ifdef(A[1]) #debug \"y\" #end #debug "
               "str(dimension_size(A,1),0,0)") == "4");
    CHECK(said("#declare A = array; #debug str(A[1],0,0)").find("its size there is 0") != std::string::npos);
    CHECK(said("#declare A = array optional {1,,3,}; #ifdef(A[1]) #debug \"y\" #end #debug "
               "str(dimension_size(A,1),0,0)") == "3");
    CHECK(
        said("#declare A = array mixed [3] {1,\"two\",<3,3,3>}; #debug concat(str(A[0],0,0),vstr(3,A[2],\"\",0,0))") ==
        "1333");
    CHECK(said("#declare A = array[3] optional {1,,3}; #ifdef(A[1]) #debug \"yes\" #else #debug str(A[2],0,0) #end") ==
          "3");
    CHECK(parser_test::debug_of("#declare A = array {1,2}; #debug str(A[1],0,0)") == "2");
}

TEST_CASE("parts of a mixed array stand where their type may", "[parser][language]")
{
    const std::string made = "#declare A = array mixed {1, \"two\", <3,4,5>, array {6}, dictionary {.Q: \"seven\"}};\n";
    CHECK(said(made + "#debug A[1] #debug concat(A[0+1], str(A[0]*2,0,0), vstr(3,A[2],\"\",0,0))") == "twotwo2345");
    CHECK(said(made + "#debug concat(str(A[3][0],0,0), A[4].Q)") == "6seven");
    CHECK(said(made + "#for(I,0,1) #if(I = 1) #debug A[I] #else #debug str(A[I],0,0) #end #end") == "1two");
    CHECK(said(made +
               "#declare R = seed(1); #debug A[int(rand(R))+1] #declare S = seed(1); #declare T = rand(S); #debug "
               "str((rand(R)=rand(S)),0,0)") == "two1");
    CHECK(said(made + "#debug A[0]").find("error: ") != std::string::npos);
}

TEST_CASE("a backslash in a file's name is an escape", "[parser][language]")
{
    CHECK(said("#include \"no\\\\where\\u0041\"").find("'no\\whereA'") != std::string::npos);
    CHECK(parser_test::error_of("#include \"no\\\\where\"").find("'no\\\\where'") != std::string::npos);
}
