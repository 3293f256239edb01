// What each switch and keyword comes to. Each row is what POV-Ray 3.7.0.10 wrote, beyond what it writes without the
// row's words, into x.ini for
//     povray s.pov +W4 +H3 -D WORDS +GIx.ini
// Not among the rows: dithering, gamma and strings of Declare, which POV-Ray leaves out of that file, and words that it
// does not understand.
#include "render/app/options/effective_ini.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

using namespace app;

namespace {

using Words = std::vector<std::string>;

struct Row {
    Words words, lines;
};

const std::vector<Row>& rows()
{
    static const std::vector<Row> all = {
        {{"+A"}, {"Antialias=On"}},
        {{"-A"}, {"Antialias=Off"}},
        {{"+A0.3"}, {"Antialias=On", "Antialias_Threshold=0.3"}},
        {{"-A0.1"}, {"Antialias=Off", "Antialias_Threshold=0.1"}},
        {{"+A00.5"}, {"Antialias=On", "Antialias_Threshold=0.5"}},
        {{"+AM1"}, {"Sampling_Method=1"}},
        {{"+AM2"}, {"Sampling_Method=2"}},
        {{"+AG2"}, {"Antialias_Gamma=2"}},
        {{"+B"}, {"Bounding=On"}},
        {{"-B"}, {"Bounding=Off"}},
        {{"+BM2"}, {"Bounding_Method=2"}},
        {{"+BS16"}, {"Render_Block_Size=16"}},
        {{"+MB5"}, {"Bounding=On", "Bounding_Threshold=5"}},
        {{"-MB5"}, {"Bounding=Off", "Bounding_Threshold=5"}},
        {{"-MB"}, {"Bounding=Off"}},
        {{"+C"}, {"Continue_Trace=On"}},
        {{"-C"}, {"Continue_Trace=Off"}},
        {{"-d"}, {}},
        {{"+dX"}, {"Display=On", "Video_Mode=X"}},
        {{"+SR0.5"}, {"Start_Row=0.5"}},
        {{"+ER2"}, {"End_Row=2"}},
        {{"+SC2"}, {"Start_Column=2"}},
        {{"+EC0.5"}, {"End_Column=0.5"}},
        {{"+EP4", "+SP8"}, {"Preview_End_Size=4", "Preview_Start_Size=8"}},
        {{"+F"}, {}},
        {{"-F"}, {"Output_To_File=Off"}},
        {{"+FN"}, {}},
        {{"-FN"}, {"Output_To_File=Off"}},
        {{"+FN16"}, {"Bits_Per_Color=16"}},
        {{"+fp"}, {"Output_File_Type=P"}},
        {{"+FT"}, {"Output_File_Type=T"}},
        {{"+FNg"}, {"Grayscale_Output=On"}},
        {{"+FB", "+UA"}, {"Output_Alpha=On", "Output_File_Type=B"}},
        {{"-GA"}, {"All_Console=Off"}},
        {{"+GAa.txt"}, {"All_Console=On", "All_File=\"a.txt\""}},
        {{"-GAa.txt"}, {"All_Console=Off", "All_File=\"a.txt\""}},
        {{"-GD"}, {"Debug_Console=Off"}},
        {{"+GDd.txt"}, {"Debug_Console=On", "Debug_File=\"d.txt\""}},
        {{"-GF"}, {"Fatal_Console=Off"}},
        {{"-GR"}, {"Render_Console=Off"}},
        {{"+GRr.txt"}, {"Render_Console=On", "Render_File=\"r.txt\""}},
        {{"-GS"}, {"Statistic_Console=Off"}},
        {{"+GSs.txt"}, {"Statistic_Console=On", "Statistic_File=\"s.txt\""}},
        {{"-GW"}, {"Warning_Console=Off"}},
        {{"+GWw.txt"}, {"Warning_Console=On", "Warning_File=\"w.txt\""}},
        {{"+GP"}, {"Append_File=On"}},
        {{"+HR"}, {"High_Reproducibility=On"}},
        {{"+J"}, {"Jitter=On"}},
        {{"-J"}, {"Jitter=Off"}},
        {{"+J0.5"}, {"Jitter=On", "Jitter_Amount=0.5"}},
        {{"-J0.5"}, {"Jitter=Off", "Jitter_Amount=0.5"}},
        {{"+K0.25"}, {"Clock=0.25"}},
        {{"+KC"}, {"Cyclic_Animation=On"}},
        {{"+KI0.5", "+KF2"}, {"Final_Clock=2", "Initial_Clock=0.5"}},
        {{"+KFI1", "+KFF2"}, {"Final_Frame=2", "Initial_Frame=1"}},
        {{"+KFF3", "+SF2"}, {"Final_Frame=3", "Subset_Start_Frame=2"}},
        {{"+KFF3", "+SF0.5"}, {"Final_Frame=3", "Subset_Start_Frame=0.5"}},
        {{"+KFF3", "+EF0.9"}, {"Final_Frame=3", "Subset_End_Frame=0.9"}},
        {{"+KFF3", "+EF2"}, {"Final_Frame=3", "Subset_End_Frame=2"}},
        {{"+KFF3", "+STP2"}, {"Final_Frame=3", "Frame_Step=2"}},
        {{"+L/tmp"}, {"Library_Path=\"/tmp\""}},
        {{"+L/tmp/", "+L/tmp"}, {"Library_Path=\"/tmp\"", "Library_Path=\"/tmp/\""}},
        {{"-L/tmp"}, {"Library_Path=\"/tmp\""}},
        {{"+MI64"}, {"Max_Image_Buffer_Memory=64"}},
        {{"+MV3.5"}, {"Version=3.5"}},
        {{"+Oq.png"}, {"Output_File_Name=\"q.png\""}},
        {{"-Oq.png"}, {"Output_File_Name=\"q.png\""}},
        {{"+Q3"}, {"Quality=3"}},
        {{"-Q3"}, {"Quality=3"}},
        {{"+R2"}, {"Antialias_Depth=2"}},
        {{"+RFx.rad"}, {"Radiosity_File_Name=\"x.rad\""}},
        {{"+RFI"}, {"Radiosity_From_File=On"}},
        {{"+RFO"}, {"Radiosity_To_File=On"}},
        {{"+RP1"}, {"Render_Pattern=1"}},
        {{"+RS7"}, {"Render_Block_Step=7"}},
        {{"+RVP"}, {"Radiosity_Vain_Pretrace=On"}},
        {{"-RVP"}, {"Radiosity_Vain_Pretrace=Off"}},
        {{"+SU"}, {"Split_Unions=On"}},
        {{"-SU"}, {"Split_Unions=Off"}},
        {{"+TH"}, {"Dither=On"}},
        {{"+UA"}, {"Output_Alpha=On"}},
        {{"-UA"}, {"Output_Alpha=Off"}},
        {{"+UD"}, {"Draw_Vistas=On"}},
        {{"+UF"}, {"Field_Render=On"}},
        {{"+UL"}, {"Light_Buffer=On"}},
        {{"+UO"}, {"Odd_Field=On"}},
        {{"-UR"}, {"Remove_Bounds=Off"}},
        {{"+UV"}, {"Vista_Buffer=On"}},
        {{"+V"}, {}},
        {{"-V"}, {"Verbose=Off"}},
        {{"+WL5"}, {"Warning_Level=5"}},
        {{"+WT1"}, {"Work_Threads=1"}},
        {{"+X"}, {"Test_Abort=On"}},
        {{"-X"}, {"Test_Abort=Off"}},
        {{"+X50"}, {"Test_Abort=On", "Test_Abort_Count=50"}},
        {{"-X50"}, {"Test_Abort=Off", "Test_Abort_Count=50"}},
        {{"+v", "-V"}, {"Verbose=Off"}},
        {{"Declare=a=3", "Declare=b=4"}, {"Declare=a=3", "Declare=b=4"}},
        {{"Declare=a=3", "Declare=a=4"}, {"Declare=a=3", "Declare=a=4"}},
        {{"Antialias=yes"}, {"Antialias=On"}},
        {{"Antialias=0"}, {"Antialias=Off"}},
        {{"Antialias=of"}, {"Antialias=Off"}},
        {{"Antialias="}, {"Antialias=On"}},
        {{"Antialias=1"}, {"Antialias=On"}},
        {{"Antialias_Threshold=0.75"}, {"Antialias_Threshold=0.75"}},
        {{"Antialias_Depth=20"}, {"Antialias_Depth=20"}},
        {{"Antialias_Depth=0"}, {"Antialias_Depth=0"}},
        {{"Bits_Per_Color=12"}, {"Bits_Per_Color=12"}},
        {{"Quality=20"}, {"Quality=20"}},
        {{"Jitter_Amount=3"}, {"Jitter_Amount=3"}},
        {{"Compression=200"}, {"Compression=200"}},
        {{"Output_File_Type=t"}, {"Output_File_Type=T"}},
        {{"Output_File_Type=N16"}, {}},
        {{"Clock=0.1"}, {"Clock=0.1"}},
        {{"Sampling_Method=7"}, {"Sampling_Method=7"}},
        {{"Work_Threads=0"}, {"Work_Threads=0"}},
        {{"Height=1.5"}, {"Height=1"}},
        {{"Width=4.9"}, {}},
        {{"Version=3.5"}, {"Version=3.5"}},
        {{"Input_File_Name=s"}, {"Input_File_Name=\"s\""}},
        {{"Palette=y"}, {"Palette=y"}},
        {{"Video_Mode=3"}, {"Video_Mode=3"}},
        {{"Warning_Level=5"}, {"Warning_Level=5"}},
        {{"Split_Unions=no"}, {"Split_Unions=Off"}},
        {{"Pre_Scene_Command=ls"}, {"Pre_Scene_Command=ls"}},
        {{"+W4"}, {}},
        {{"+W'4'"}, {}},
        {{"Output_File_Name=\"a b.png\""}, {"Output_File_Name=\"a b.png\""}},
        {{"+O'a b.png'"}, {"Output_File_Name=\"a b.png\""}},
        {{"+Is.pov"}, {}},
        {{"+wT1", "+w4"}, {"Work_Threads=1"}},
        {{"Grayscale_Output=on"}, {"Grayscale_Output=On"}},
        {{"Odd_Field=on"}, {"Odd_Field=On"}},
        {{"Render_Pattern=9"}, {"Render_Pattern=9"}},
        {{"Continue_Trace=No"}, {"Continue_Trace=Off"}},
        {{"Start_Row=2", "End_Row=2"}, {"End_Row=2", "Start_Row=2"}},
        {{"Max_Image_Buffer_Memory=3"}, {"Max_Image_Buffer_Memory=3"}},
        {{"Clockless_Animation=on"}, {"Clockless_Animation=On"}},
        {{"Cyclic_Animation=on"}, {"Cyclic_Animation=On"}},
        {{"+KFF02"}, {"Final_Frame=2"}},
        {{"High_Reproducibility=on"}, {"High_Reproducibility=On"}},
        {{"Bounding_Threshold=77"}, {"Bounding_Threshold=77"}},
        {{"Bounding_Method=2"}, {"Bounding_Method=2"}},
        {{"BSP_MaxDepth=3"}, {"BSP_MaxDepth=3"}},
        {{"BSP_ISectCost=1.5"}, {"BSP_ISectCost=1.5"}},
        {{"Radiosity_Vain_Pretrace=off"}, {"Radiosity_Vain_Pretrace=Off"}},
        {{"Radiosity_File_Name=z"}, {"Radiosity_File_Name=\"z\""}},
        {{"Test_Abort_Count=9"}, {"Test_Abort_Count=9"}},
        {{"Preview_Start_Size=8"}, {"Preview_Start_Size=8"}},
        {{"Frame_Step=2"}, {"Frame_Step=2"}},
        {{"Subset_Start_Frame=0.3"}, {"Subset_Start_Frame=0.3"}},
        {{"All_Console=off"}, {"All_Console=Off"}},
        {{"All_File=on"}, {"All_File=\"on\""}},
        {{"Debug_File=true"}, {"Debug_File=\"true\""}},
        {{"Fatal_Error_Command=x"}, {"Fatal_Error_Command=x"}},
        {{"Append_File=on"}, {"Append_File=On"}},
        {{"Jitter=off"}, {"Jitter=Off"}},
        {{"Light_Buffer=off"}, {"Light_Buffer=Off"}},
        {{"Remove_Bounds=off"}, {"Remove_Bounds=Off"}},
        {{"Antialias_Gamma=1"}, {"Antialias_Gamma=1"}},
    };
    return all;
}

/// What the file holds without any of the words.
const Words kAlways{"Bounding_Threshold=3", "Display=Off",       "Height=3",   "Input_File_Name=\"s.pov\"",
                    "Output_File_Type=N",   "Output_To_File=On", "Verbose=On", "Width=4"};

Words lines_of(const Words& words)
{
    Settings settings;
    apply_command_line(settings, {"s.pov", "+W4", "+H3", "-D"});
    apply_command_line(settings, words);
    std::istringstream ini(effective_ini(settings));
    Words lines;
    for (std::string line; std::getline(ini, line);)
        if (std::find(kAlways.begin(), kAlways.end(), line) == kAlways.end()) lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    return lines;
}

}  // namespace

TEST_CASE("switches and keywords come to the options that they come to in POV-Ray", "[app][options]")
{
    for (const Row& row : rows()) {
        INFO("words: " << row.words.front());
        CHECK(lines_of(row.words) == row.lines);
    }
}

TEST_CASE("the file of options in force, read as an INI file, gives them again", "[app][options]")
{
    for (const Row& row : rows()) {
        Settings settings;
        apply_command_line(settings, {"s.pov", "+W4", "+H3", "-D"});
        apply_command_line(settings, row.words);
        const std::string ini = effective_ini(settings);
        Settings again;
        apply_ini_text(again, ini, "", "again.ini");
        INFO("words: " << row.words.front());
        CHECK(effective_ini(again) == ini);
    }
}
