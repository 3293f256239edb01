#include "tests/parser/blocks/said.h"
#include "tests/support/share.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

// Blocks of directives are compiled where they are read again (docs/blocks.md). Read word by word they say the same;
// fuzz_blocks of tests/fuzz compares programs that nobody wrote.
namespace {

std::string said_by(const std::string& text, bool blocks, const std::vector<std::string>& library = {})
{
    parser::Options options;
    options.blocks = blocks;
    options.library_path = library;
    options.write_nothing = true;  // a scene reads what it would have written
    return said::in_full(text, options);
}

bool unending(const std::string& said) { return said.find("the limit of tokens is reached") != std::string::npos; }

/// What is said both ways.
std::string both_ways(const std::string& text)
{
    const std::string compiled = said_by("#version 3.7;\n" + text, true);
    CHECK(compiled == said_by("#version 3.7;\n" + text, false));
    return compiled;
}

struct MacroOf {
    std::string name;
    std::size_t parameters;
};

std::vector<MacroOf> macros_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const std::string all = text.str();
    static const std::regex kMacro(R"(#\s*macro\s+(\w+)\s*\(([^)]*)\))");
    std::vector<MacroOf> macros;
    for (std::sregex_iterator at(all.begin(), all.end(), kMacro), end; at != end; ++at) {
        std::stringstream words((*at)[2].str());
        std::string word;
        std::size_t count = 0;
        while (std::getline(words, word, ',')) count += word.find_first_not_of(" \t\r\n") != std::string::npos ? 1 : 0;
        macros.push_back({(*at)[1].str(), count});
    }
    return macros;
}

}  // namespace

TEST_CASE("an error in a compiled block names its place and the calls that led there", "[parser][blocks]")
{
    const std::string said = both_ways("#macro Root(X) #local Y = sqrt(X); (Y + 1) #end\n"
                                       "#macro Sum(N, Out)\n  #local I = N;\n  #while (I > -3)\n"
                                       "    #declare Out = Out + Root(I);\n    #local I = I - 1;\n  #end\n#end\n"
                                       "#declare Total = 0;\n#for (K, 3, 6) Sum(K, Total) #end\n");
    CHECK(said.find("t.pov:2:27: error: sqrt of a number below 0") != std::string::npos);
    CHECK(said.find("note: in the expansion of macro Root") != std::string::npos);
    CHECK(said.find("t.pov:11:16: note: in the expansion of macro Sum") != std::string::npos);
}

TEST_CASE("an expression that is too long is told at its beginning, compiled or not", "[parser][blocks]")
{
    const std::string said = both_ways("#macro M(X, Y)\n  #local Z = sin(X + 2*Y);\n#end\n"
                                       "#for (I, 1, 4) M(I, 1) #end #for (I, 1, 4) M(I, (I > 2 ? 1 : 2)) #end\n"
                                       "#for (I, 1, 4) #if (I = 3) #undef I #declare I = 7; #end M(I, x) #end\n");
    CHECK(said.find("t.pov:3:18: error: expected a number, found a vector or color") != std::string::npos);
}

TEST_CASE("what a block has done stays done where it is left, and no more", "[parser][blocks]")
{
    const std::string show = "#debug concat(str(A, 0, 3), \" \", str(B, 0, 3), \" \", str(rand(R), 0, 6), \"|\")\n";
    const std::string start = "#declare A = 0; #declare B = 0; #declare R = seed(3);\n"
                              "#macro Count(X) #declare B = B + X; (X * rand(R)) #end\n";
    // The division warns behind the call: both are left to the reader of tokens, once.
    const std::string warned = both_ways(start + "#for (I, -2, 4) #declare A = Count(I) + 1 / I; " + show + "#end\n");
    CHECK(warned.find("division by zero") != std::string::npos);
    CHECK(both_ways(start + "#for (I, 1, 6) #declare A = A + I; #if (I = 5) #declare C[1] = 2; #end " + show + "#end\n")
              .find("error:") != std::string::npos);
    both_ways(start + "#for (I, 1, 6) #declare A = (I = 4 ? Count(I) : A); #undef B #declare B = 1; " + show +
              "#end\n");
}

TEST_CASE("variables change their type under a compiled block", "[parser][blocks]")
{
    both_ways("#declare V = 1; #for (I, 1, 9) #if (I = 6) #declare V = <1, 2, I>; #else #declare V = V * 2; #end\n"
              "#debug concat(vstr(3, V, \",\", 0, 3), \" \") #end");
    both_ways("#macro M(P) #local Q = P; #local Q = Q + P; #debug vstr(3, Q, \",\", 0, 2) #end\n"
              "#for (I, 1, 5) M(I) M(<I, 1>) M(x * I) M(I / 2) #end");
    both_ways(
        "#for (I, 1, 6) #ifdef (New) #undef New #else #local New = I; #end #ifdef (New) #debug str(New, 0, 0) #end "
        "#end");
    // One that turns to and fro in each pass, under another name too, and in the place of a loop's variable.
    const std::string show = " #debug concat(vstr(5, Hue, \",\", 0, 3), \" \") ";
    both_ways("#declare Hue = rgb <1, .5, .25>; #for (I, 1, 9) #declare Hue = Hue*0.5 + rgb <I, 0, 1/3>*0.1;" + show +
              "#declare Hue = <Hue.red, Hue.green, Hue.blue>;" + show + "#declare Hue = Hue.y; #local T = Hue + I;" +
              show + "#local Hue = <T, Hue, I/3>; #end\n" + show);
    both_ways("#macro M(Hue, B) #for (I, 1, 7) #declare Hue = B + <1, 2, 3>; #declare B = B + 1;" + show +
              "#declare B = vlength(Hue); #local Hue = 2; #local Hue = Hue*<I, 1>; #end #end\n"
              "#declare A = 1; M(A, A) #declare V = <1, 2, 3>; M(V, A)\n");
    both_ways("#for (I, 1, 6) #declare Hue = I; #declare I = <1, 2, I>;" + show + "#end\n");
}

TEST_CASE("loops write what they write word by word", "[parser][blocks]")
{
    const auto written = [](const std::string& loop) {
        return both_ways("#declare S = \"s\"; #declare R = seed(2); #declare A = array[2] { \"p\", \"q\" }\n"
                         "#fopen File \"w.txt\" write\n#for (I, 0, 9)\n" +
                         loop + "\n#end\n#fclose File\n#fopen File \"w.txt\" read\n" +
                         "#while (defined(File)) #read (File, Line) #debug concat(Line, \"|\") #end\n");
    };
    const std::string all = written("#write (File, \"\\\"\", str(I / 4, 0, 2), A[mod(I, 2)] S, \"\\\\\", "
                                    "concat(\"x\", str(rand(R), 0, 0)), \"\\\",\\n\")");
    CHECK(all.find("0.00ps\\x") != std::string::npos);
    CHECK(all.find("2.25qs\\x") != std::string::npos);
    // What is no text, a text beyond ASCII, a file that is closed or read meanwhile.
    written("#write (File, \"\\\"\", I, <1, I, 2>, \"\\\",\")");
    written("#declare S = chr(I < 6 ? 65 + I : 200 + I); #write (File, \"\\\"\" S \"\\\",\")");
    CHECK(written("#write (File, \"\\\"a\\\",\") #if (I = 5) #fclose File #end").find("error:") != std::string::npos);
    CHECK(written("#write (File, \"\\\"a\\\",\") #if (I = 5) #fclose File #fopen File \"w.txt\" read #end")
              .find("was opened for reading") != std::string::npos);
    // A macro whose value is wanted, and that writes on its way.
    both_ways(
        "#fopen File \"w.txt\" write\n#macro Told(X) #write (File, \"\\\"\", str(X, 0, 0), \"\\\",\") (X + 1) #end\n"
        "#declare B = 0; #for (I, 0, 9) #declare B = B + Told(I); #declare B = Told(I) / (I - 4); #end\n"
        "#fclose File\n#fopen File \"w.txt\" read\n"
        "#while (defined(File)) #read (File, Line) #debug concat(Line, \"|\") #end\n");
}

TEST_CASE("every macro of the standard includes says the same compiled and word by word", "[parser][blocks]")
{
    const std::filesystem::path folder = "/usr/share/povray-3.7/include";
    if (!std::filesystem::is_directory(folder)) return;  // the package is optional
    const std::vector<std::string> library = {folder.string()};
    std::size_t compared = 0, seen = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".inc") continue;
        for (const MacroOf& macro : macros_of(entry.path())) {
            if (seen++ % test::kEvery != 0) continue;
            std::string numbers, mixed;
            for (std::size_t i = 0; i < macro.parameters; ++i) {
                const std::string more = std::to_string(i + 1);
                numbers += (i ? ", " : "") + std::string("I * 0.5 + ") + more;
                mixed += (i ? ", " : "") + std::string(i % 3 == 0   ? "<I, 0.5, " + more + ">"
                                                       : i % 3 == 1 ? "<1, I, 2>"
                                                                    : "Variable");
            }
            const std::string head =
                "#version 3.7; global_settings { assumed_gamma 1 } #include \"math.inc\" #include \"" +
                entry.path().filename().string() + "\"\n#declare Variable = 0.5;\n";
            for (const std::string& given : {numbers, mixed})
                for (const std::string& use :
                     {"#local Given = (" + macro.name + "(" + given + "));\n#debug vstr(3, Given, \" \", 0, 9)\n",
                      macro.name + "(" + given + ")\n"}) {
                    const std::string text = head + "#for (I, 1, 4)\n" + use + "#end\n";
                    const std::string plain = said_by(text, false, library), compiled = said_by(text, true, library);
                    if (unending(plain) || unending(compiled)) continue;
                    INFO(text);
                    REQUIRE(compiled == plain);
                    ++compared;
                }
        }
    }
    CHECK(compared > 800 / test::kEvery);
}

TEST_CASE("a text waits for nothing that a macro behind it may write over", "[parser][blocks]")
{
    const std::string said = both_ways("#macro F(S) strlen(S) #end\n"
                                       "#macro M(A, B) #declare R = concat(A, str(B, 0, 0), \"\\n\"); #end\n"
                                       "#declare R = \"\";\n"
                                       "#for (I, 0, 5) M(\"abc\", F(\"hello world\")) #debug R #end\n");
    CHECK(said.find("abc11") != std::string::npos);
    CHECK(said.find("abc3") == std::string::npos);
}

TEST_CASE("more numbers than there are registers are left to the reader of tokens", "[parser][blocks]")
{
    std::string call = "I";
    for (int depth = 0; depth < 6; ++depth) call = "G(1,2,3,4,5,6,7,8,9,10,11,12,13,14,15," + call + ")";
    const std::string begin =
        "#declare G = function(a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p) { a + 2*o + p };\n#declare Q = 0;\n";
    const std::string in_block = begin + "#for (I, 0, 5) #declare Q = Q + " + call + "; #end #debug str(Q, 0, 0)\n";
    const std::string alone = begin + "#for (I, 0, 5) #debug str(" + call + ", 0, 0) #end\n";
    CHECK(both_ways(in_block).find("1131") != std::string::npos);  // 6 * 6 * 31 + 15
    CHECK(both_ways(alone).find("191") != std::string::npos);      // 6 * 31 + 5
}

TEST_CASE("a compiled loop without end is ended by the limit of tokens", "[parser][blocks]")
{
    for (const bool blocks : {true, false})
        CHECK(unending(said_by("#version 3.7; #declare A = 0;\n#while (1)\n#declare A = A + 1;\n#end\n", blocks)));
    CHECK(unending(said_by("#version 3.7; #declare A = 0; #macro M(X) #while (1) #local A = X + 1; #end (X) #end\n"
                           "#for (I, 1, 5) #declare A = M(I); #end\n",
                           true)));
}

TEST_CASE("a compiled loop without end can be cancelled, and says where", "[parser][blocks]")
{
    std::atomic<bool> cancel = false;
    parser::Options options;
    options.cancel = &cancel;
    std::string note;
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        cancel = true;
    });
    const auto keep = [](void* to, const parser::Message& message) {
        *static_cast<std::string*>(to) += message_text(message);
    };
    bool cancelled = false;
    try {
        parser::parse_text("#version 3.7;\n#declare A = 0;\n  #while (1) #declare A = A + 1; #end\n", "t.pov", options,
                           keep, &note);
    } catch (const parser::Cancelled&) {
        cancelled = true;
    }
    other.join();
    CHECK(cancelled);
    CHECK(note.find("t.pov:3:3: note: reading is cancelled, in this loop") != std::string::npos);
}
