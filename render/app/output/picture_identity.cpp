#include "render/app/output/picture_identity.h"

#include "render/app/output/state_file.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace app {

std::uint64_t picture_identity(const parser::Options& o, const plan::Options& p, const parser::Result& parsed)
{
    std::string text = "whittle " WHITTLE_VERSION "\n";
    text += fmt::format("{} {} {} {} {} {} {} {} {} {} {}\n", o.version_given, o.version, o.image_width, o.image_height,
                        o.clock, o.clock_on, o.frame_number, o.initial_frame, o.final_frame, o.clock_delta,
                        o.include_header);
    for (const auto& [name, value] : o.declared_numbers) text += fmt::format("{}={}\n", name, value);
    for (const auto& [name, value] : o.declared_strings) text += fmt::format("{}=\"{}\"\n", name, value);
    const plan::Antialiasing& aa = p.antialiasing;
    text += fmt::format("{} {} {} {} {} {} {} {} {} {} {}\n", p.quality.code(), p.alpha, p.start_row, p.start_column,
                        p.end_row, p.end_column, p.block_size, p.split_unions, aa.method, aa.depth, p.faithful);
    text += fmt::format("{} {} {}\n", aa.threshold, aa.jitter, aa.gamma);
    std::uint64_t hash = hash_of(text.data(), text.size());
    for (const std::vector<std::string>* files : {&parsed.scene.files, &parsed.data_files}) {
        for (const std::string& file : *files) {
            std::ifstream in(file, std::ios::binary);
            std::ostringstream content;
            content << in.rdbuf();
            const std::string bytes = std::move(content).str();
            hash = hash_of(bytes.data(), bytes.size(), hash_of(file.data(), file.size(), hash));
        }
    }
    return hash;
}

}  // namespace app
