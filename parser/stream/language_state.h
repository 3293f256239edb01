#pragma once

#include "render/scene/description.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parser {

/// A macro: parameters and the token range of its body.
struct Macro {
    std::uint32_t name = 0;
    std::vector<std::uint32_t> parameters;
    std::vector<bool> optional;  ///< by parameter: may be left out in a call (version 3.8)
    std::uint16_t file = 0;
    std::uint32_t begin = 0, end = 0;  ///< tokens of the body; end is the Hash of its `#end`
};

/// `#declare deprecated [once] ["message"] NAME`: what a use of the name is told.
struct Deprecation {
    bool once = false;
    std::string message;
};

/// global_settings { charset }: what bytes above 127 in a text mean.
enum class Charset : std::uint8_t { Ascii, Utf8, System };

/// Settings of the text that change how the rest of it is read.
struct LanguageState {
    int version = 370;                          ///< `#version` * 100
    scene::PovRay povray = scene::PovRay::V37;  ///< of Options, or what the main scene's #version says
    bool version_set = false;                   ///< by a directive or an option; off: gamma and the like act as in 3.62
    bool version_directive = false;             ///< a #version was executed
    /// Of the first #version, if other text was read before it.
    std::optional<scene::SourceRef> late_version;
    Charset charset = Charset::Ascii;
    scene::AssumedGamma assumed_gamma;  ///< the grammar keeps it up to date: srgb colours depend on it
    int effective_version() const { return version_set ? version : 362; }
};

}  // namespace parser
