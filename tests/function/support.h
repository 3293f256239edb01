#pragma once

#include "function/points/evaluate.h"
#include "parser/parse.h"
#include "parser/stream/functions/function.h"
#include "render/texture/noise/noise.h"
#include "tests/support/csv_table.h"

#include <string>
#include <vector>

namespace function_test {

/// A table of the tests' data.
inline std::vector<std::vector<std::string>> table(const std::string& name)
{
    return test_support::csv_table(std::string(WHITTLE_TEST_DATA "/") + name);
}

/// The scene's noise, generator 2, and nothing else.
struct NoiseHost final : function::Host {
    double noise(const glm::dvec3& p, int generator) const override
    {
        return texture::noise(p, generator ? generator : 2);
    }
    double pattern(std::uint32_t, const glm::dvec3&) const override { return 0.0; }
    std::array<double, 5> pigment(std::uint32_t, const glm::dvec3&) const override { return {}; }
};

/// Functions declared by a text, by name: what `pattern { function { ... } }` would hold.
function::FunctionPtr compiled(const std::string& declarations, const std::string& name);

}  // namespace function_test
