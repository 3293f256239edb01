// Which files a run makes. Each row is the exit status and the new files of POV-Ray 3.7.0.10 for
//     povray +W4 +H3 -D WORDS
// in a folder that holds what make() puts there. (It makes Create_Ini=true a file `true`; Whittle follows the manual.)
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

struct NameRow {
    Words words;
    int status;
    Words files;
};

const std::vector<NameRow>& name_rows()
{
    static const std::vector<NameRow> all = {
        {{"s.pov", "+Ox"}, 0, {"x.png"}},
        {{"s.pov", "+Ox.png"}, 0, {"x.png"}},
        {{"s.pov", "+Ox.PNG"}, 0, {"x.PNG.png"}},
        {{"s.pov", "+Ox."}, 0, {"x.png"}},
        {{"s.pov", "+Ox.foo"}, 0, {"x.foo.png"}},
        {{"s.pov", "+O.png"}, 0, {"s.png"}},
        {{"s.pov", "+Oout/"}, 0, {"out/s.png"}},
        {{"s.pov", "+Oout"}, 0, {"out.png"}},
        {{"s.pov", "+Oout/.png"}, 0, {"out/s.png"}},
        {{"s.pov", "+Oout/x"}, 0, {"out/x.png"}},
        {{"s.pov", "+O./"}, 0, {"s.png"}},
        {{"s.pov", "+Osub/../x"}, 0, {"x.png"}},
        {{"s.pov", "+Oa.b/x"}, 0, {"a.b/x.png"}},
        {{"s.pov", "+Oa.b"}, 0, {"a.b.png"}},
        {{"+Isub/d"}, 0, {"sub/d.png"}},
        {{"+Isub/d.pov"}, 0, {"sub/d.png"}},
        {{"+Lsub", "+Id"}, 0, {"d.png"}},
        {{"+Lsub", "d.pov"}, 0, {"d.png"}},
        {{"UP.POV"}, 0, {"UP.png"}},
        {{"+IUP"}, 0, {"UP.png"}},
        {{"two.dots.pov"}, 0, {"two.dots.png"}},
        {{"+Itwo.dots"}, 0, {"two.png"}},
        {{"+Inoext"}, 0, {"noext.png"}},
        {{"'sp ace.pov'"}, 0, {"sp ace.png"}},
        {{"a.b/e.pov"}, 0, {"a.b/e.png"}},
        {{"+Ia.b/e"}, 0, {"a.b/e.png"}},
        {{"i.ini"}, 0, {"s.png"}},
        {{"i"}, 0, {"s.png"}},
        {{"i.ini", "+Oq"}, 0, {"q.png"}},
        {{"s.pov", "+Oq", "+FT"}, 0, {"q.tga"}},
        {{"s.pov", "+Oq.png", "+FT"}, 0, {"q.png.tga"}},
        {{"s.pov", "+Oq.tga", "+FC"}, 0, {"q.tga"}},
        {{"s.pov", "+Oq.jpeg", "+FJ"}, 0, {"q.jpeg.jpg"}},
        {{"s.pov", "+KFF2", "+Oq"}, 0, {"q1.png", "q2.png"}},
        {{"s.pov", "+KFF2", "+Oq.png"}, 0, {"q1.png", "q2.png"}},
        {{"s.pov", "+KFF2", "+Oout/"}, 0, {"out/s1.png", "out/s2.png"}},
        {{"s.pov", "+KFF2", "+O.png"}, 0, {"s1.png", "s2.png"}},
        {{"s.pov", "+KFF2", "+Oq7"}, 0, {"q71.png", "q72.png"}},
        {{"s.pov", "+KFF100", "+SF9", "+EF9", "+Oq_"}, 0, {"q_009.png"}},
        {{"s.pov", "Output_File_Name="}, 0, {"s.png"}},
        {{"s.pov", "-F"}, 0, {}},
        {{"s.pov", "-F", "+Ox"}, 0, {}},
        {{"s.pov", "+F", "-Oz"}, 0, {"z.png"}},
        {{"+Is.pov", "+Isub/d.pov"}, 0, {"sub/d.png"}},
        {{"sub/d.pov", "s.pov"}, 0, {"s.png"}},
        {{"s.pov", "+O-"}, 0, {}},
        {{"s.pov", "+Ostdout"}, 0, {}},
        {{"s.pov", "+OSTDOUT"}, 0, {"STDOUT.png"}},
        {{"s.pov", "+Ostderr"}, 0, {}},
        {{"s.pov", "+GAl.txt", "+Oout/x"}, 0, {"out/l.txt", "out/x.png"}},
        {{"s.pov", "+GIe.ini", "+Oout/x"}, 0, {"e.ini", "out/x.png"}},
        {{"s.pov", "All_File=true", "+Oout/"}, 0, {"out/alltext.out", "out/s.png"}},
        {{"s.pov", "+O'a b'"}, 0, {"a b.png"}},
        {{"s.pov", "+KFI5", "+KFF5"}, 0, {"s5.png"}},
        {{"s.pov", "+KFF1"}, 0, {"s1.png"}},
        {{"s.pov", "+KFF0"}, 0, {"s.png"}},
        {{"s.pov", "+Onone/x"}, 1, {}},
    };
    return all;
}

void make(const support::TemporaryFolder& folder)
{
    for (const char* name : {"sub", "out", "a.b"}) fs::create_directory(folder / name);
    for (const char* name : {"s.pov", "sub/d.pov", "UP.POV", "two.dots.pov", "noext", "sp ace.pov", "a.b/e.pov"})
        support::write_text(folder / name,
                            "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -z }\n");
    support::write_text(folder / "i.ini", "Input_File_Name=s.pov\n");
}

Words files_of(const support::TemporaryFolder& folder)
{
    Words names;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder.path()).string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("a run makes the files that POV-Ray makes", "[program][names]")
{
    for (const NameRow& row : name_rows()) {
        std::string said;
        for (const std::string& word : row.words) said += word + " ";
        INFO(said);
        const support::TemporaryFolder folder;
        make(folder);
        const Words before = files_of(folder);
        Words words{"+W4", "+H3", "-D"}, made;
        words.insert(words.end(), row.words.begin(), row.words.end());
        CHECK(support::run_program(folder.path(), WHITTLE_PROGRAM, words).status == row.status);
        const Words after = files_of(folder);
        std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(made));
        CHECK(made == row.files);
    }
}
