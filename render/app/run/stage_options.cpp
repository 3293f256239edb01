#include "render/app/run/stage_options.h"

#include "render/app/base/library_path.h"
#include "render/app/base/text.h"
#include "render/app/frames/window.h"
#include "render/app/run/allocation.h"
#include "render/picture/threads.h"

#include <algorithm>

namespace app {

parser::Options parser_options(const Settings& settings, const FrameList& list, const Frame& frame)
{
    parser::Options options;
    options.library_path = settings.library_path;
    for (std::string& folder : default_library_path()) options.library_path.push_back(std::move(folder));
    options.declared_numbers = settings.declared_numbers;
    options.declared_strings = settings.declared_strings;
    if (settings.extensions) options.declared_numbers.try_emplace("Whittle", 1.0);
    options.povray = settings.povray;
    options.version_given = settings.version.has_value();
    options.version = settings.version.value_or(options.version);
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.clock = static_cast<double>(frame.clock);
    options.clock_on = list.clock_on;
    options.frame_number = frame.number;
    options.initial_frame = list.initial_frame;
    options.final_frame = list.final_frame;
    options.clock_delta = list.clock_delta;
    if (list.animation) {
        options.initial_clock = static_cast<double>(settings.initial_clock);
        options.final_clock = static_cast<double>(settings.final_clock);
    }
    options.include_header = settings.include_header;
    options.write_folders = settings.write_folders;
    options.write_nothing = settings.check;
    options.restrict_read = settings.restrict_read;
    return options;
}

plan::Options plan_options(const Settings& settings)
{
    plan::Options options;
    options.width = settings.width;
    options.height = settings.height;
    options.quality = plan::Quality::of(settings.quality);
    options.alpha = settings.alpha && image::stores_alpha(settings.file_type);
    plan::Antialiasing& aa = options.antialiasing;
    aa.method = settings.antialias ? settings.sampling_method : 0;
    aa.threshold = static_cast<double>(settings.antialias_threshold);
    aa.depth = settings.antialias_depth;
    aa.jitter = settings.jitter ? static_cast<double>(settings.jitter_amount) : 0.0;
    aa.gamma = static_cast<double>(settings.antialias_gamma);
    aa.confidence = static_cast<double>(settings.antialias_confidence);
    aa.seed = static_cast<std::uint32_t>(settings.stochastic_seed);
    const Window window = window_of(settings);
    options.start_row = window.first_row;
    options.end_row = window.last_row;
    options.start_column = window.first_column;
    options.end_column = window.last_column;
    options.block_size = settings.block_size;
    options.faithful = settings.faithful;
    if (!settings.lean) options.lean = plan::LeanSteps::none();
    options.free_sampling = settings.sampled();
    options.paths = settings.paths;
    options.grain_stream = settings.faithful && settings.threads == 1 && !settings.sampled();
    if (settings.split_unions) options.split_unions = *settings.split_unions;
    return options;
}

/// A method that both versions have is another one in 3.8, and so is the usual one.
image::Dither dither_of(const Settings& settings, bool newer)
{
    using image::Dither;
    const Dither asked = settings.dither_method.value_or(newer ? Dither::BlueNoise : Dither::FloydSteinberg);
    if (!newer) return asked;
    switch (asked) {
    case Dither::Ordered2: return Dither::Bayer2;
    case Dither::Ordered3: return Dither::Bayer3;
    case Dither::Ordered4: return Dither::Bayer4;
    case Dither::Spread: return Dither::SierraLite;
    case Dither::FloydSteinberg: return Dither::FloydSteinbergLight;
    default: return asked;
    }
}

image::FileSettings file_settings(const Settings& settings, const scene::Description& description)
{
    std::optional<image::TransferCurve> assumed;
    if (description.global.assumed_gamma) assumed = description.global.assumed_gamma->curve();
    // An option Version=3.7 turns gamma handling on for the output of an older scene too (spec 2, 10.1).
    const int version = std::max(description.effective_version, settings.version.value_or(0));
    image::FileSettings file;
    file.type = settings.file_type;
    file.encoding.curves = image::output_curves(assumed, version, settings.file_gamma, settings.display_gamma);
    const bool newer = description.povray == scene::PovRay::V38;
    constexpr int kLeastOf37 = 5;
    file.encoding.bits = newer ? settings.bits_per_color : std::max(settings.bits_per_color, kLeastOf37);
    if (settings.greyscale && !newer) file.encoding.bits = 16;
    if (newer && settings.given.contains("Compression")) {
        if (settings.compression == 0 && file.type == image::FileType::Ppm) file.type = image::FileType::PpmPlain;
        if (settings.compression > 0 && file.type == image::FileType::Targa)
            file.type = image::FileType::TargaRunLength;
    }
    if (newer && image::is_ppm(file.type) && !settings.given.contains("File_Gamma"))
        file.encoding.curves.file = image::TransferCurve::bt709();
    if (settings.greyscale && image::is_ppm(file.type))
        file.encoding.curves.file = file.encoding.curves.working;  // PGM is linear (spec 2, 12.3)
    if (settings.dither) file.encoding.dither = dither_of(settings, newer);
    file.encoding.alpha = settings.alpha;
    file.encoding.greyscale = settings.greyscale;
    if (settings.compression > 1) file.jpeg_quality = settings.compression;
    return file;
}

void refuse_contradictions(const Settings& settings)
{
    if (settings.shutter > 0.0 && (settings.error > 0.0 || settings.samples_error > 0.0 || settings.time > 0.0))
        throw OptionError(
            "Shutter takes its samples at fixed moments: it goes with --samples, not with an error or a time");
    if (settings.denoise && !settings.paths)
        throw OptionError("--denoise is for pictures of the path tracer: it goes with --integrator=path");
    if (settings.greyscale && !image::stores_greyscale(settings.file_type))
        throw OptionError("this output file type stores no greyscale: use +FN or +FP");
    window_of(settings);  // outside of the picture
}

bool from_standard_input(const Settings& settings)
{
    return settings.input_file == "-" || same_text(settings.input_file, "stdin");
}

int threads_of(const Settings& settings)
{
    return trace::threads_of(settings.threads > 0 ? settings.threads : allocated_threads());
}

trace::Isa isa_of(const Settings& settings)
{
    if (settings.isa == "v2") return trace::Isa::V2;
    if (settings.isa == "v3") return trace::Isa::V3;
    if (settings.isa == "v4") return trace::Isa::V4;
    return trace::Isa::Auto;
}

}  // namespace app
