#pragma once

#include "parser/parse.h"
#include "render/solid/measure/body.h"

#include <string>

/// The first object of a scene as a body.
inline solid::Body body_of(const std::string& text)
{
    parser::Options options;
    const auto parsed =
        parser::parse_text("#version 3.7; global_settings { assumed_gamma 1 } " + text, "test", options);
    return solid::Body(*parsed.scene.objects.begin(), parsed.scene.global);
}
