// Programs that call `povray`: their command lines and INI files as they give them, the picture that they then open,
// and what they look for in the text. The pictures are small where a caller leaves the size to its user.
#include "render/image/files.h"

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>

namespace {

using support::Ended;
using support::write_text;
using Words = std::vector<std::string>;

constexpr const char* kScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                               "camera { location <0, 0, -4> look_at 0 }\nlight_source { <-5, 5, -5>, 1 }\n"
                               "sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } }\n";

struct File {
    const char *name, *text;
};

/// One call and what its caller expects. Exit status 0 and the picture are expected by all.
struct Call {
    const char* caller;
    Words arguments;
    const char* picture;  ///< file that must exist; null: PNG or PPM on standard output
    int width, height;
    std::vector<File> files = {};  ///< besides the scene
    const char* scene = "x.pov";
    std::vector<const char*> said = {};  ///< regular expressions that some line of standard error matches wholly
};

constexpr const char* kParsing = "==== \\[Parsing\\.\\.\\.\\] =+";
constexpr const char* kRendering = "==== \\[Rendering\\.\\.\\.\\] =+";
constexpr const char* kFinished = "POV-Ray finished";
constexpr const char* kPercent = "Rendered \\d+ of \\d+ pixels \\(100%\\)";

const std::vector<Call>& calls()
{
    static const std::vector<Call> all = {
        {"vscode-povray",
         {"x.pov", "-D", "Width=64", "Height=48", "Output_File_Name=out/", "Library_Path=lib", "Output_File_Type=P"},
         "out/x.ppm",
         64,
         48},
        {"vscode-povray, a name with blanks",
         {"'tea pot.pov'", "Width=64", "Height=48"},
         "tea pot.png",
         64,
         48,
         {},
         "tea pot.pov"},
        {"Emacs pov-mode", {"res120", "-Q3", "+ix.pov"}, "x.png", 120, 90, {}, "x.pov", {kFinished}},
        {"vapory",
         {"__temp__.pov", "+H36", "+W48", "+Q9", "+A0.010000", "-D", "+Llib", "Output_File_Type=P", "+O-"},
         nullptr,
         48,
         36,
         {},
         "__temp__.pov"},
        {"fdray",
         {"Width=48", "Height=36", "Output_Alpha=on", "Quality=9", "Antialias=on", "Display=off",
          "Input_File_Name=x.pov", "Work_Threads=2", "Output_File_Name=y.png"},
         "y.png",
         48,
         36,
         {},
         "x.pov",
         {kParsing, kRendering, "-+"}},
        {"fdray, antialiasing switch",
         {"Width=48", "Height=36", "Output_Alpha=on", "Quality=9", "+A0.3", "Display=off", "Input_File_Name=x.pov",
          "Output_File_Name=y.png"},
         "y.png",
         48,
         36},
        {"FreeCAD Render", {"+W48", "+H36", "-D", "+O\"out/y.png\"", "+AM1", "+R3", "\"x.pov\""}, "out/y.png", 48, 36},
        {"FreeCAD Render, no output named", {"+W48", "+H36", "+D", "\"x.pov\""}, "x.png", 48, 36},
        {"Blender render_povray",
         {"x.ini", "-d", "+Llib"},
         "y.png",
         48,
         36,
         {{"x.ini", "Version=3.7\nAll_File=1\nInput_File_Name=\"x.pov\"\nOutput_File_Name=\"y.png\"\nWidth=48\nHeight="
                    "36\nStart_Column=   0\nStart_Row=   0\nEnd_Column=   1\nEnd_Row=   1\n"
                    "Bounding_Method=2\nDisplay=1\nPause_When_Done=0\nOutput_File_Type=N\nOutput_Alpha=1\nAntialias="
                    "1\nAntialias_Depth=3\nAntialias_Threshold=0.3\n"
                    "Antialias_Gamma=2.5\nSampling_Method=2\nJitter=1\nJitter_Amount=1\n"}},
         "x.pov",
         {".*= \\[Parsing\\.\\.\\.\\] =.*", ".*= \\[Rendering\\.\\.\\.\\] =.*", ".*\\(100%\\).*"}},
        {"Blender render_povray, texture preview",
         {"x.ini", "-d"},
         "y.png",
         16,
         16,
         {{"x.ini", "Version=3.8\nInput_File_Name=\"x.pov\"\nOutput_File_Name=\"y.png\"\nWidth=16\nHeight="
                    "16\nAntialias=1\nSampling_Method=2\n"}}},
        {"LeoCAD",
         {"+I\"x.pov\"", "+W48", "+H36", "-O-", "+Q11", "+R3", "+A0.1", "+J0.5", "+FN", "-D", "+L\"lib\"",
          "+L\"lib/sub\""},
         nullptr,
         48,
         36,
         {},
         "x.pov",
         {kFinished}},
        {"LPub3D",
         {"+d", "+O\"y.png\"", "+I\"x.pov\"", "+W48", "+H36", "+UA", "+Q11 +R3 +A0.1 +J0.5", "+L\"lib\""},
         "y.png",
         48,
         36},
        {"ASE",
         {"x.ini"},
         "x.png",
         48,
         36,
         {{"x.ini", "Input_File_Name=x.pov\nOutput_to_File=True\nOutput_File_Type=N\nOutput_Alpha=on\n; if you adjust "
                    "Height, and width, you must preserve the ratio\nWidth=48\nHeight=36\n"
                    "Antialias=True\nAntialias_Threshold=0.1\nDisplay=False\nPause_When_Done=True\nVerbose=False\n"}}},
        {"PyMOL", {"-D", "+Ix.pov", "+Oy.png", "+W48", "+H36", "+A"}, "y.png", 48, 36},
        {"VMD", {"+W48", "+H36", "-Ix.pov", "-Ox.pov.tga", "+D", "+X", "+A", "+FT"}, "x.pov.tga", 48, 36},
        {"VMD, the line in its files",
         {"+W48", "+H36", "-Ix.pov", "-Oy.tga", "+P", "+X", "+A", "+FT", "+C"},
         "y.tga",
         48,
         36},
        {"VMD, another extension",
         {"+W48", "+H36", "-Ix.pov", "-Ox.png", "+D", "+X", "+A", "+FT"},
         "x.png.tga",
         48,
         36},
        {"VMD, PNG on a cluster",
         {"+W48", "+H36", "-Ix.pov", "-Ox.png", "+D", "+X", "+A", "+FN", "+UA", "+wt2"},
         "x.png",
         48,
         36},
        {"Avogadro 1",
         {"+Ix.pov", "+Oy.png", "+W48", "+H36", "+V", "+D", "+FN", "+Q9", "+P", "+UD", "+UL", "+UV", "+A", "+AM2",
          "+UA"},
         "y.png",
         48,
         36,
         {{"y.png", ""}},
         "x.pov",
         {kPercent}},
        {"Avogadro 1, video", {"-D", "x.pov"}, "x.png", 800, 600},
        {"Jmol",
         {"x.pov.ini"},
         "y.png",
         48,
         36,
         {{"x.pov.ini", "Input_File_Name=x.pov\nOutput_to_File=true\nOutput_File_Type=N\nOutput_File_Name=y."
                        "png\nHeight=36\nWidth=48\nAntialias=true\nAntialias_Threshold=0.1\n"
                        "Display=true\nPause_When_Done=true\nWarning_Level=5\nVerbose=false\n"}}},
        {"CueMol 2",
         {"Input_File_Name='x.pov'", "Output_File_Name='y.png'", "Library_Path='lib'", "Library_Path='lib/sub'",
          "Declare=_stereo=0", "Declare=_iod=0.03", "File_Gamma=1", "-D", "+WT2", "+W48", "+H36", "+FN8", "Quality=11",
          "Antialias=On", "Antialias_Depth=3", "Antialias_Threshold=0.1", "Jitter=Off", "+V", "+UA"},
         "y.png",
         48,
         36,
         {},
         "x.pov",
         {kPercent}},
        {"Wings3D",
         {"x.pov", "+W48", "+Q9", "+H36", "+UA", "+FN", "+oy.png", "+A0.300000", "+R3", "+J", "+AM2", "+WT2"},
         "y.png",
         48,
         36},
        {"reanimate", {"+W48", "+H36", "-D", "+UA", "+Ix.pov", "+oy.png"}, "y.png", 48, 36},
        {"morpho", {"x.pov", "-D", "+A", "+UA", "+W48", "+H36"}, "x.png", 48, 36},
        {"morpho, a name that begins as a switch",
         {"-0.25_90.pov", "-D", "+A", "+W48", "+H36"},
         "-0.25_90.png",
         48,
         36,
         {},
         "-0.25_90.pov"},
        {"Chrono",
         {"x.ini"},
         "x009.png",
         16,
         12,
         {{"x.ini", "; a script for all frames\nAntialias=Off\n# -- size\nHeight =12\nWidth =16 # "
                    "pixels\nInput_File_Name=x.pov\nInitial_Frame=0007\nFinal_Frame=0009\nFinal_Frame=0100 ; "
                    "last\nSubset_Start_Frame=8\nSubset_End_Frame=9\nDeclare=i=8\n"
                    "Pause_when_Done=off\n"}}},
        {"Light-field tools",
         {"+I\"x.pov\"", "+L\"lib\"", "+W48", "+H36", "+O\"y.png\"", "+HI\"cam.inc\"", "+GA\"name.log\"", "-D",
          "Declare=EXT_CAMERA=1"},
         "y.png",
         48,
         36,
         {{"cam.inc", "#declare External = EXT_CAMERA;\n#debug \"camera file read\\n\"\n"}},
         "x.pov",
         {"camera file read"}},
        {"Spack", {"x.pov", "+W48", "+H36"}, "x.png", 48, 36, {}, "x.pov", {kFinished}},
        {"povray-slurm",
         {"+KFI1", "+KFF4000", "+SF17", "+EF17", "x.ini"},
         "x0017.png",
         16,
         12,
         {{"x.ini", "Input_File_Name=x.pov\nWidth=16\nHeight=12\n"}}},
        {"povray-slurm, sub-frames",
         {"x.ini", "-V", "+SF2", "+EF2", "+KI0.25", "+KF0.75", "-WT2", "-D", "+Osub_1.png"},
         "sub_12.png",
         16,
         12,
         {{"x.ini", "Input_File_Name=x.pov\nWidth=16\nHeight=12\nFinal_Frame=3\n"}}},
        {"task-distributor", {"x.pov", "+FN", "+W48", "+H36", "+SR13", "+ER24"}, "x.png", 48, 36},
        {"NetSolve", {"x.pov", "+FN", "+W48", "+H36", "/EXIT"}, "x.png", 48, 36},
    };
    return all;
}

void prepare(const support::TemporaryFolder& folder, const Call& call)
{
    for (const char* name : {"out", "lib", "lib/sub"}) std::filesystem::create_directories(folder / name);
    write_text(folder / call.scene, kScene);
    for (const File& file : call.files) write_text(folder / file.name, file.text);
}

/// Lines as a terminal shows them: '\r' ends one as '\n' does.
std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n' || c == '\r') lines.emplace_back();
        else lines.back() += c;
    }
    return lines;
}

bool says(const std::string& text, const char* pattern)
{
    const std::regex wanted(pattern);
    for (const std::string& line : lines_of(text))
        if (std::regex_match(line, wanted)) return true;
    return false;
}


}  // namespace

TEST_CASE("each caller gets its picture, exit status 0 and the lines that it looks for", "[callers]")
{
    for (const Call& call : calls()) {
        INFO(call.caller);
        const support::TemporaryFolder folder;
        prepare(folder, call);
        const Ended ended = support::run_program(folder.path(), WHITTLE_AS_POVRAY, call.arguments, kScene);
        INFO(ended.err);
        CHECK(ended.status == 0);
        std::string picture = call.picture ? folder / call.picture : "";
        if (!call.picture) {
            const bool png = ended.out.starts_with("\x89PNG");
            CHECK((png || ended.out.starts_with("P6")));
            write_text(picture = folder / (png ? "stdout.png" : "stdout.ppm"), ended.out);
        } else {
            CHECK(ended.out.empty());
        }
        if (!std::filesystem::exists(picture)) {
            FAIL_CHECK("no picture " << picture);
            continue;
        }
        const image::Picture read = image::Files().read(picture);
        CHECK(read.width == call.width);
        CHECK(read.height == call.height);
        for (const char* pattern : call.said) {
            INFO(pattern);
            CHECK(says(ended.err, pattern));
        }
        // What all callers rely on: little text, in ASCII.
        CHECK(support::ascii(ended.err));
        CHECK(ended.err.size() < 16384);
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\r') <= 101);
        CHECK_FALSE(says(ended.err, ".*Error:.*"));
    }
}

TEST_CASE("called by its own name the program makes the same pictures", "[callers]")
{
    for (const Call& call : calls()) {
        INFO(call.caller);
        std::string pictures[2];
        for (int named = 0; named < 2; ++named) {
            const support::TemporaryFolder folder;
            prepare(folder, call);
            const Ended ended = support::run_program(folder.path(), named ? WHITTLE_AS_POVRAY : WHITTLE_PROGRAM,
                                                     call.arguments, kScene);
            CHECK(ended.status == 0);
            CHECK(support::ascii(ended.err));
            pictures[named] = call.picture ? support::text_of(folder / call.picture) : ended.out;
        }
        CHECK(pictures[0] == pictures[1]);
        CHECK_FALSE(pictures[0].empty());
    }
}
