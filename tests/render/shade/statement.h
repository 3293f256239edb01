#pragma once

#include "render/scene/textures/texture.h"

#include <string>

/// Reads the statements of the measured vectors: far less than the parser, and independent of it.
namespace test {

struct Statement {
    scene::Pattern pattern;
    double amount = 0.5, accuracy = 0.02;  ///< normals: the number after the pattern
};

/// Throws std::runtime_error on a word that it does not know.
Statement read_statement(const std::string& text);

}  // namespace test
