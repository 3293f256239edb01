#pragma once

#include "parser/parse.h"
#include "render/app/options/settings.h"
#include "render/plan/compiled_scene.h"

#include <cstdint>
#include <string>

namespace app {

/// What a picture is made from.
struct PictureSource {
    const Settings& settings;
    const parser::Options& reading;
    const plan::Options& planned;
    const image::FileSettings& file;
    const parser::Result& parsed;  ///< the hashes of what it read
    const std::string& views;      ///< cameras in the place of the scene's own; empty: none
};

/// A number that differs, as good as surely, where two pictures may: of the options that change a pixel or its
/// rounding, the version of the program and the contents of the files read. Their names do not count, nor what changes
/// no byte, so it is the same on every machine.
std::uint64_t fingerprint_of(const PictureSource& source);

/// As it stands in pictures and reports: 16 digits.
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace app
