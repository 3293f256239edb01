#include "tests/parser/stream_support.h"

#include <catch2/catch.hpp>

using parser_test::debug_of;
using parser_test::error_of;
using parser_test::plain;

TEST_CASE("conditionals choose by the truth of their condition", "[parser][stream]")
{
    CHECK(plain("#if(0) a #elseif(1) b #else c #end d") == "b d");
    CHECK(plain("#if(1e-11) a #else b #end") == "b");
    CHECK(plain("#if(0) #if(1) a #else b #end #else c #end") == "c");
    CHECK(plain("#ifdef(Q) a #else b #end #declare Q=1; #ifdef(Q) c #end #ifdef(sphere) d #end") == "b c");
    CHECK(plain("#if(0) #error \"x\" %%% sphere{{{ \"str #end\" /* #end */ #end ok") == "ok");
    CHECK(plain("#switch(2) #case(1) a #break #case(2) b #case(3) c #break #else d #end e") == "b c e");
    CHECK(plain("#switch(7) #range(1,2) a #break #else d #end e") == "d e");
    CHECK(plain("#switch(1) #case(1) a #else b #end") == "a b");
}

TEST_CASE("loops count as the language does", "[parser][stream]")
{
    CHECK(debug_of("#for(I,0,1,0.1) #debug \"x\" #end #debug str(I,0,3)") == "xxxxxxxxxxx1.100");
    CHECK(debug_of("#for(I,3,1,-1) #debug str(I,0,0) #end") == "321");
    CHECK(debug_of("#for(I,1,9) #if(I=4) #break #end #debug str(I,0,0) #end #debug str(I,0,0)") == "1234");
    CHECK(debug_of("#declare N=0; #while(N<3) #declare N=N+1; #if(N=2) #debug \"!\" #end #debug str(N,0,0) #end") ==
          "1!23");
}

TEST_CASE("macros are text with arguments by value or by reference", "[parser][stream]")
{
    CHECK(debug_of("#macro Add(a,b) a+b #end #debug str(2*Add(1,2),0,0)") == "4");
    CHECK(debug_of("#macro V(a) a,a+1 #end #debug vstr(4,<V(1),V(5)>,\",\",0,0)") == "1,2,5,6");
    const std::string change = "#macro M(A) #declare A=A+1; #end #declare Q=5; ";
    CHECK(debug_of(change + "M(Q) #debug str(Q,0,0)") == "6");
    CHECK(debug_of(change + "M((Q)) M(+Q) M(Q+0) #debug str(Q,0,0)") == "5");
    CHECK(debug_of("#macro M(A) #local A=A+1; #end #declare Q=5; M(Q) #debug str(Q,0,0)") == "6");
    CHECK(debug_of("#macro M(A) #declare A=9; #end #declare X=array[2]{1,2} M(X[1]) #debug str(X[1],0,0)") == "9");
    CHECK(debug_of("#macro B() #declare S=S+1; #end #macro A() #local S=10; B() #debug str(S,0,0) #end A()") == "11");
    CHECK(debug_of("#macro L() #local V=7; V #end #declare R=(L()); #debug str(R,0,0)") == "7");
    CHECK(debug_of("#macro F(n) #if(n<=1) 1 #else (n*F(n-1)) #end #end #debug str(F(5),0,0)") == "120");
    CHECK(plain("#macro Open() union { a #end Open() }") == "union { a }");
    CHECK(plain("#macro M(A) #macro N(B) A B #end #end M(1) #macro N(B) z #end N(2)") == "z");
}

TEST_CASE("directives are not executed where an operator of a declaration may stand", "[parser][stream]")
{
    CHECK(debug_of("#declare A=#if(1) 1; #else 2; #end #debug str(A,0,0)") == "1");
    CHECK(debug_of("#declare A=(#if(0) 1 #else 2 #end); #debug str(A,0,0)") == "2");
    CHECK(error_of("#declare A=1 #declare B=2;") ==
          "test.pov:1:14: error: expected ';' at the end of the declaration, found '#'\n"
          "    1 | #declare A=1 #declare B=2;\n"
          "      |              ^");
}

TEST_CASE("errors name place, need and find", "[parser][error]")
{
    CHECK(error_of("#declare Radius = 1;\n#declare B = Raduis;") ==
          "test.pov:2:14: error: 'Raduis' is not declared; did you mean 'Radius'?\n"
          "    2 | #declare B = Raduis;\n"
          "      |              ^");
    CHECK(error_of("#macro Bite(r)\n  #declare Q = r + y*;\n#end\nBite(2)") ==
          "test.pov:2:22: error: expected a number or vector, found ';'\n"
          "    2 |   #declare Q = r + y*;\n"
          "      |                      ^\n"
          "test.pov:4:1: note: in the expansion of macro Bite");
    CHECK(error_of("#if(1) a").starts_with("test.pov:1:1: error: this has no #end"));
    CHECK(error_of("/* a /* b */").starts_with("test.pov:1:1: error: this comment is never closed"));
    CHECK(error_of("#macro A() A() #end A()").find("does a recursion never end?") != std::string::npos);
    CHECK(error_of("#declare A=" + std::string(100000, '(')).find("nested too deeply") != std::string::npos);
    CHECK(error_of("#include \"no such file\"").find("cannot find the include file 'no such file'") !=
          std::string::npos);
}

TEST_CASE("functions", "[parser][function]")
{
    CHECK(debug_of("#declare f=function(x,y){x-y-1-2*3/4/2} #debug str(f(10,3),0,2)") == "5.25");
    CHECK(debug_of("#declare f=function{-x*x} #debug str(f(3,0,0),0,0)") == "-9");
    CHECK(debug_of("#declare k=2; #declare f=function(a){k*sin(a)} #declare k=5; #debug str(f(1),0,4)") == "1.6829");
}

TEST_CASE("a local whose value a macro gives belongs to the scope that declares it", "[parser][macro]")
{
    CHECK(parser_test::debug_of("#macro Give() #local Q=<1,2,3>; Q #end "
                                "#macro Take() #local N=Give() #debug str(vlength(N),0,3) #end "
                                "#version 3.0; Take() #ifdef(N) #debug \"leaked\" #end") == "3.742");
}
