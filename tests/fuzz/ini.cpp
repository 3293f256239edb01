// INI files and command lines, to the frames, the window and the file names that come of them. First byte: which.
#include "render/app/options/command_line.h"
#include "render/app/options/effective_ini.h"
#include "render/app/frames/frames.h"
#include "render/app/options/ini_file.h"
#include "render/app/output/output_name.h"
#include "render/app/frames/window.h"
#include "tests/fuzz/target.h"

#include <sstream>

void fuzz::one(const Bytes& bytes)
{
    if (bytes.empty()) return;
    const std::string text(bytes.begin() + 1, bytes.end());
    app::Settings settings;
    try {
        if (bytes[0] % 2 == 0) {
            app::apply_ini_text(settings, text, bytes[0] % 4 == 0 ? "" : "part", "fuzz.ini");
        } else {
            std::vector<std::string> arguments;
            std::istringstream lines(text);
            for (std::string line; std::getline(lines, line);) arguments.push_back(line);
            app::apply_command_line(settings, arguments);
        }
        const app::Window window = app::window_of(settings);
        require(window.first_row >= 0 && window.last_row < settings.height && window.first_column >= 0 &&
                    window.last_column < settings.width,
                "a window outside the picture");
        const app::FrameList list = app::frames_of(settings);
        if (!list.frames.empty()) app::output_path(settings, list, list.frames.back());
        app::effective_ini(settings);
    } catch (const app::OptionError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    const std::string ini =
        "; a remark\nWidth=320\nHeight = 200\nAntialias=on\n+A0.1 -D +FN16\nDeclare=name=\"text\"\nLibrary_Path=\"a "
        "b\",c\n[part]\nInitial_Frame=2\nFinal_Frame=9\nInitial_Clock=0.5\n"
        "Final_Clock=2.5e1\nSubset_Start_Frame=0.25\nSubset_End_Frame=7\nFrame_Step=2\nCyclic_Animation=yes\nInclude_"
        "Ini=none.ini\n[other]\nQuality=11\nFile_Gamma=sRGB\nOutput_File_Type=T\n"
        "Output_File_Name=out.tga\nStart_Row=0.5\nEnd_Row=150\nStart_Column=3\nEnd_Column=0.9\nPre_Scene_Command=echo "
        "%o\nPost_Frame_Return=-S\nDither_Method=FS\nVersion=3.6\nClock=3";
    const std::string words =
        "scene.pov\n+W640 +H480\n+A0.3 +AM2 +R4 -J\n+Idata.pov\n+Oout.png\n+KFI1 +KFF10 +KI0.1 +KF2 "
        "+KC\n+SF3\n+EF0.5\n+SR0.2 +ER100 +SC5 +EC0.75\n--json=x.json\n--dump\nscene\n--state-after=3\n"
        "+GA\"all.txt\" +GS -GW\n+FJ +Q5 +MV3.1 +WT4 "
        "+BS16\n--isa=v3\n'+L/usr/share'\nDeclare=x=3\n+HIhead.inc\n+SMfile\n--console=povray\n";
    return {bytes_of('\0' + ini), bytes_of('\2' + ini), bytes_of('\1' + words)};
}
