#pragma once

#include "render/image/files.h"
#include "render/scene/base/povray.h"

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace app {

/// Whose words the console speaks: Whittle's own, or the lines that callers of `povray` look for.
enum class ConsoleStyle { Whittle, Povray };

/// Points of a run at which a command can be run.
enum class Hook { PreScene, PreFrame, PostFrame, PostScene, UserAbort, FatalError };
inline constexpr std::size_t kHookCount = 6;

/// Frames from `first` on by `step` up to `last`.
struct FrameRange {
    int first, last, step;
};

/// Lines that tell a program of progress, beside what the console says.
enum class ProgressLines { None, Povray, Json, OpenJd };

/// What the command line and INI files ask for, with the defaults of a Debian installation of POV-Ray (spec 1, 18).
struct Settings {
    // Scene.
    std::string input_file;
    std::string include_header;             ///< a file to include ahead of the scene; empty: none
    std::vector<std::string> library_path;  ///< as given, in order; default_library_path() comes after
    std::map<std::string, double> declared_numbers;
    std::map<std::string, std::string> declared_strings;
    std::optional<int> version;  ///< times 100
    std::optional<float> clock;

    // Animation: as given, resolved by frames().
    std::optional<int> initial_frame, final_frame;
    float initial_clock = 0.0f, final_clock = 1.0f;
    double subset_start_frame = 0.0, subset_end_frame = 0.0;  ///< 0: not given; below 1: share of the frames
    int frame_step = 1;
    std::vector<FrameRange> frame_list;  ///< of --frames; empty: none
    bool cyclic = false;

    // Picture.
    int width = 800, height = 600;
    double start_column = 0.0, start_row = 0.0;  ///< below 1: share of the picture; else counted from 1
    double end_column = 1.0, end_row = 1.0;      ///< at most 1: share of the picture; else counted from 1, inclusive
    int quality = 9;
    bool antialias = false, jitter = true;
    float antialias_threshold = 0.3f, antialias_gamma = 2.5f, jitter_amount = 1.0f;
    int sampling_method = 1, antialias_depth = 3;
    float antialias_confidence = 0.9f;  ///< of method 3
    int stochastic_seed = 0;            ///< of method 3
    std::optional<bool> split_unions;
    int threads = 0;  ///< 0: one per core
    int block_size = 32;

    // Many samples (docs/error_and_time.md); all 0: as antialiasing says.
    int samples = 0;             ///< in each pixel
    double samples_error = 0.0;  ///< as many in each pixel as this error needs, of 255
    double error = 0.0;          ///< estimated, of 255, that a picture may have
    double time = 0.0;           ///< seconds that a frame may take
    std::uint32_t seed = 0;      ///< another one: other samples, which err independently of these
    bool paths = false;          ///< by the path tracer (docs/path_tracing.md)
    bool denoise = false;        ///< of a picture of the path tracer
    double shutter = 0.0;        ///< share of the time to the next frame that a picture is exposed for
    int motion_samples = 16;     ///< moments of it
    /// Which pixel gets another sample, or what it becomes, follows from all others.
    bool decides_by_whole() const { return samples_error > 0.0 || error > 0.0 || denoise; }
    bool sampled() const { return paths || asks_for_samples() || shutter > 0.0; }
    bool asks_for_samples() const { return samples > 0 || samples_error > 0.0 || error > 0.0 || time > 0.0; }

    // Output file.
    bool output_to_file = true;
    std::string output_file;  ///< as given; output_path() makes the name of it
    image::FileType file_type = image::FileType::Png;
    int bits_per_color = 8;
    bool greyscale = false, alpha = false, continue_trace = false;
    double memory = 0.0;        ///< bytes for the pixels of a picture; 0: half of what is free
    double partial = 0.0;       ///< seconds between pictures of what is done, under the picture's name; 0: none
    int shard = 0, shards = 0;  ///< the part of so many that is rendered, from 1 on; 0: all of the picture
    bool prepare = false;       ///< only what the parts need of the whole
    std::string views;          ///< of --views: a file of cameras, or words; empty: the scene's camera alone
    bool embed = false;         ///< the picture carries what it was made of
    double state_after = 2.0;   ///< seconds of rendering before finished blocks are kept for +C
    bool dither = false;
    std::optional<image::Dither> dither_method;  ///< unset: as the POV-Ray that is drawn has it
    int compression = 0;                         ///< JPEG quality; 0 and 1 mean 85
    image::TransferCurve file_gamma = image::TransferCurve::srgb(), display_gamma = image::TransferCurve::srgb();

    // Commands, by Hook, and what their exit status does.
    std::array<std::string, kHookCount> commands, command_returns;

    // Messages.
    bool verbose = true;
    bool debug_console = true, warning_console = true, statistic_console = true, render_console = true;
    bool fatal_console = true;
    std::optional<bool> all_console;  ///< overrides the single ones
    /// Files that keep the text of a stream: a name, a truth for the usual name, or empty.
    std::string all_file, debug_file, fatal_file, render_file, statistic_file, warning_file;
    bool append_file = false;
    std::string create_ini;  ///< an INI file to write: a name, a truth for the scene's, or empty
    ConsoleStyle console_style = ConsoleStyle::Whittle;
    bool quiet = false;  ///< errors only
    ProgressLines progress = ProgressLines::None;

    // Whittle's own.
    enum class Dump { None, Tokens, Scene, Plan, Views } dump = Dump::None;
    bool explain = false, parse_only = false;
    bool explain_cost = false;                  ///< with explain
    std::string layers;                         ///< of --aov, by name; empty: none
    std::string heat_file;                      ///< empty: none
    bool extensions = true;                     ///< false: --no-extensions, the constant Whittle is not defined
    bool lean = true;                           ///< false: --no-lean
    bool check = false, deps = false;           ///< with parse_only: no file is written; the files read are printed
    std::string radiosity_file = "object.rca";  ///< of samples of radiosity
    bool radiosity_from_file = false, radiosity_to_file = false;
    std::string preview_file;  ///< empty: none
    std::string json_file;     ///< empty: none; "-": standard output
    bool warnings_are_errors = false, make_folders = false, allow_commands = false, restrict_read = false;
    std::optional<scene::PovRay> povray;     ///< parser::Options::povray
    bool faithful = false;                   ///< plan::Options::faithful
    std::vector<std::string> write_folders;  ///< where a scene may write besides the current folder and the picture's
    std::string isa;                         ///< "v2", "v3", "v4"; empty: the best the processor has

    /// Values by keyword of the option table, as given last; of Library_Path and Declare all.
    std::map<std::string, std::vector<std::string>, std::less<>> given;
    std::vector<std::string> given_own;     ///< Whittle's own options, as "--name" or "--name=value", in order
    std::vector<std::string> ini_files;     ///< read, in order
    std::vector<std::string> not_acted_on;  ///< options given that have no effect yet, for the note
    std::vector<std::string> notes;         ///< other remarks about INI files
};

/// A command line or INI file that cannot be understood.
struct OptionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace app
