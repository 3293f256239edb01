#pragma once

#include "function/evaluate.h"
#include "parser/parse.h"
#include "parser/stream/function.h"
#include "render/texture/noise.h"

#include <fstream>
#include <string>
#include <vector>

namespace function_test {

/// Lines of a table without its header; fields may stand in quotes.
inline std::vector<std::vector<std::string>> table(const std::string& name)
{
    std::ifstream in(std::string(WHITTLE_TEST_DATA "/") + name);
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> row(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"') quoted = !quoted;
            else if (c == ',' && !quoted) row.emplace_back();
            else if (c != '\r') row.back() += c;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The scene's noise, generator 2, and nothing else.
struct NoiseHost final : function::Host {
    double noise(const glm::dvec3& p, int generator) const override { return texture::noise(p, generator ? generator : 2); }
    double pattern(std::uint32_t, const glm::dvec3&) const override { return 0.0; }
    std::array<double, 5> pigment(std::uint32_t, const glm::dvec3&) const override { return {}; }
};

/// Functions declared by a text, by name: what `pattern { function { ... } }` would hold.
function::FunctionPtr compiled(const std::string& declarations, const std::string& name);

}  // namespace function_test
