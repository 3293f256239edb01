#include "render/app/output/fingerprint.h"

#include "render/files/hash.h"

#include <fmt/format.h>

#include <vector>

namespace app {

namespace {

std::string curve_text(const image::TransferCurve& curve)
{
    return fmt::format("{} {}", static_cast<int>(curve.kind), curve.gamma);
}

std::string options_text(const PictureSource& source)
{
    const parser::Options& o = source.reading;
    const plan::Options& p = source.planned;
    const Settings& s = source.settings;
    std::string text = "whittle " WHITTLE_VERSION "\n";
    text += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}\n", o.version_given, o.version, o.image_width,
                        o.image_height, o.clock, o.clock_on, o.frame_number, o.initial_frame, o.final_frame,
                        o.clock_delta, o.initial_clock, o.final_clock, !o.include_header.empty());
    for (const auto& [name, value] : o.declared_numbers) text += fmt::format("{}={}\n", name, value);
    for (const auto& [name, value] : o.declared_strings) text += fmt::format("{}=\"{}\"\n", name, value);
    const plan::Antialiasing& aa = p.antialiasing;
    text += fmt::format("{} {} {} {} {} {} {} {} {}\n", p.quality.code(), p.alpha, p.start_row, p.start_column,
                        p.end_row, p.end_column, p.split_unions, p.faithful, p.grain_stream);
    if (aa.method != 0)  // which looks no farther than its block
        text +=
            fmt::format("{} {} {} {} {} {}\n", aa.method, aa.depth, aa.threshold, aa.jitter, aa.gamma, p.block_size);
    if (aa.method == 3) text += fmt::format("{} {}\n", aa.confidence, aa.seed);
    if (o.povray) text += fmt::format("povray {}\n", static_cast<int>(*o.povray));
    if (s.sampled())
        text += fmt::format("{} {} {} {} {} {} {} {} {} {}\n", s.samples, s.samples_error, s.error, s.time, s.seed,
                            s.paths, s.denoise, s.shutter, s.motion_samples, p.block_size);
    if (!source.views.empty()) text += "views\n" + source.views;
    const image::Encoding& e = source.file.encoding;
    const bool lossy = source.file.type == image::FileType::Jpeg;
    return text + fmt::format("{} {} {} {} {} {} {} {}\n", static_cast<char>(source.file.type), e.bits, e.alpha,
                              e.greyscale, static_cast<int>(e.dither), curve_text(e.curves.working),
                              curve_text(e.curves.file), lossy ? source.file.jpeg_quality : 0);
}

}  // namespace

std::uint64_t fingerprint_of(const PictureSource& source)
{
    std::vector<std::uint64_t> hashes{files::hash_of_text(options_text(source))};
    for (const std::vector<std::uint64_t>* read : {&source.parsed.text_hashes, &source.parsed.data_hashes})
        hashes.insert(hashes.end(), read->begin(), read->end());
    if (source.settings.radiosity_from_file) hashes.push_back(files::hash_of_file(source.settings.radiosity_file));
    return files::hash_of(hashes.data(), hashes.size() * sizeof hashes.front());
}

std::string fingerprint_text(std::uint64_t fingerprint) { return fmt::format("{:016x}", fingerprint); }

}  // namespace app
