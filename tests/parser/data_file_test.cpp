#include "parser/stream/files/data_file.h"
#include "parser/stream/files/mapped_text.h"
#include "stream_support.h"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>

namespace fs = std::filesystem;
using parser_test::debug_of;

namespace {

/// A folder of its own that is the current one while it lives.
struct Folder {
    fs::path before = fs::current_path(),
             here = fs::temp_directory_path() / ("whittle_data_" + std::to_string(std::random_device{}()));
    Folder()
    {
        fs::create_directory(here);
        fs::current_path(here);
    }
    ~Folder()
    {
        fs::current_path(before);
        fs::remove_all(here);
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(here / name, std::ios::binary) << text;
    }
    std::string read(const std::string& name) const
    {
        std::ifstream in(here / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

std::string trouble_of(const std::string& text)
{
    try {
        debug_of(text);
    } catch (const parser::Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("what a scene writes", "[parser][file]")
{
    const Folder folder;
    debug_of(
        "#declare V=<1,2,3>; #fopen F \"a.txt\" write #write(F,\"n \",1/3,\",\",V,\",\",<1,2.5>,\"\\n\") #fclose F "
        "#fopen F \"a.txt\" append #write(F, 12, -0.5) #fclose F");
    CHECK(folder.read("a.txt") == "n 0.333333,<1,2,3> ,<1,2.5> \n12-0.5");
    debug_of("#fopen F \"b.bin\" write #write(F, sint8 -200, 127.5 uint16be 258 uint16le <258,3>) #fclose F");
    CHECK(folder.read("b.bin") == std::string("\x80"
                                              "127.5"
                                              "\x01\x02"
                                              "\x02\x01\x03\x00",
                                              12));
}

TEST_CASE("what a scene reads: items need commas, the end closes", "[parser][file]")
{
    const Folder folder;
    folder.write("a.txt", "1 2 3 4 5 6");
    CHECK(debug_of("#fopen F \"a.txt\" read #read(F,A,B,C) #debug concat(str(A,0,0),str(B,0,0),str(C,0,0))") == "135");
    folder.write("b.txt", "1,2,/* no */3 // end");
    const std::string loop =
        "#declare N=0; #while(defined(F)) #read(F,A) #declare N=N+1; #end #debug concat(str(N,0,0),\" \",str(A,0,0))";
    CHECK(debug_of("#fopen F \"b.txt\" read " + loop) == "3 3");
    folder.write("c.txt", "1,2,3,\n");
    CHECK(debug_of("#fopen F \"c.txt\" read " + loop) == "4 3");
    folder.write("d.txt", "-1.5e1, <1,-2,3>, \"two \\\"words\\\"\"");
    // In a compiled loop: the end of the file in the middle of an item's list, a vector and a text on the way.
    const std::string sums =
        "#declare A=0;#declare B=0;#declare T=0;#declare N=0;#while(defined(F))#read(F,A,B)#declare "
        "T=T*3+A-B;#declare N=N+1;#end #debug concat(str(T,0,0),\" \",str(N,0,0))";
    folder.write("e.txt", "1,2,3,4,5,6,7,8,-9,10,11,12,13");
    CHECK(debug_of("#fopen F \"e.txt\" read " + sums) == "-1253 7");
    folder.write("e.txt", "1,2,3,4,5,6,7,8, 9 // last\n,10,11,12,13,14,\n");
    CHECK(debug_of("#fopen F \"e.txt\" read " + sums) == "-3280 8");
    folder.write("e.txt", "1,2,3,4,5,6,7,8,<9,1,2>,10,11,12");
    CHECK_THROWS(debug_of("#fopen F \"e.txt\" read " + sums));
    // A file that is written while it is read: what it held when it was opened.
    std::string many;
    for (int i = 0; i < 60'000; ++i) many += "1,\n";
    folder.write("f.txt", many);
    CHECK(debug_of("#fopen F \"f.txt\" read #declare A=0;#declare N=0;#read(F,A)#fopen G \"f.txt\" write "
                   "#write(G,5)#fclose G #while(defined(F))#read(F,A)#declare N=N+A;#end #debug str(N,0,0)") ==
          "60000");
    CHECK(debug_of("#fopen F \"d.txt\" read #read(F,A,V,S) #debug concat(str(A,0,1),vstr(3,V,\",\",0,0),S)") ==
          "-15.01,-2,3two \"words\"");
    CHECK(debug_of("#declare A=array[2]{0,0} #fopen F \"b.txt\" read #read(F,A[1],A[0]) #debug "
                   "concat(str(A[0],0,0),str(A[1],0,0))") == "21");
}

TEST_CASE("a variable past the end of the data stays as it was", "[parser][file]")
{
    const Folder folder;
    folder.write("a.txt", "7");
    CHECK(debug_of("#declare B=5; #fopen F \"a.txt\" read #read(F,A,B,C) #debug concat(str(A,0,0),str(B,0,0)) "
                   "#ifdef(C) #debug \"C\" #end #ifdef(F) #debug \"F\" #end") == "75");
}

TEST_CASE("files are refused with a reason", "[parser][file]")
{
    const Folder folder;
    folder.write("a.txt", "x");
    CHECK(trouble_of("#fopen F \"no.txt\" read").find("cannot open 'no.txt' for reading") != std::string::npos);
    CHECK(trouble_of("#fopen F \"../up.txt\" write").find("may not write") != std::string::npos);
    CHECK(trouble_of("#fopen F \"/up.txt\" append").find("may not write") != std::string::npos);
    CHECK(trouble_of("#fopen F \"a.txt\" read #read(F,A)").find("a.txt: expected a number, found 'x'") !=
          std::string::npos);
    CHECK(trouble_of("#fopen F \"a.txt\" read #write(F,1)").find("opened for reading") != std::string::npos);
    CHECK(trouble_of("#declare F=1; #fopen F \"a.txt\" read").find("declared already") != std::string::npos);
    CHECK(debug_of("#fclose Nothing #debug \"on\"") == "on");
    CHECK_FALSE(fs::exists(folder.here.parent_path() / "up.txt"));
}

TEST_CASE("a long file lies where the system has it, and nobody writes to it meanwhile", "[parser][file]")
{
    const Folder folder;
    folder.write("long.txt", std::string(10'000, 'x'));
    CHECK_FALSE(parser::MappedText("no.txt", 1));
    CHECK_FALSE(parser::MappedText("long.txt", 10'001));
    const auto writable = [] {
        const int file = open("long.txt", O_WRONLY | O_TRUNC | O_NONBLOCK);
        if (file < 0) return errno != EWOULDBLOCK;
        close(file);
        return true;
    };
    {
        const parser::MappedText mapped("long.txt", 10'000);
        if (!mapped) return;  // this file system gives no leases: files are read
        CHECK(mapped.text() == std::string(10'000, 'x'));
        CHECK_FALSE(writable());
        CHECK(mapped.text() == std::string(10'000, 'x'));
    }
    const int busy = open("long.txt", O_WRONLY);
    CHECK_FALSE(parser::MappedText("long.txt", 1));  // it may change
    close(busy);
    CHECK(writable());
    CHECK_FALSE(parser::MappedText("long.txt", 0));  // nothing is left of it
}

TEST_CASE("a long include file says the same as a short one", "[parser][file]")
{
    const Folder folder;
    const std::string blanks = "\n" + std::string(5'000'000, ' ');
    for (const char* const body :
         {"#declare A = 3;\n#debug \"A\"\n", "\n\n#declare B = (1 + ;\n", "#if (1)\n", "/* open"}) {
        folder.write("short.inc", body);
        folder.write("large.inc", body + blanks);
        const auto said = [](const std::string& name) {
            const std::string text = "#include \"" + name + "\" #debug str(A, 0, 0)";
            std::string told = trouble_of(text);
            if (told == "no error") told = debug_of(text);
            if (const std::size_t at = told.find(name); at != std::string::npos) told.replace(at, name.size(), "it");
            return told;
        };
        CHECK(said("short.inc") == said("large.inc"));
    }
}
