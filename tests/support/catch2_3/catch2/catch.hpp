#pragma once

#include <catch2/catch_all.hpp>

#include <string>

/// Catch2 3 by the names of Catch2 2, so that the tests are written once; in the include path where 3 is installed.
using Catch::Approx;

namespace Catch {
using namespace Matchers;
inline auto Contains(const std::string& part) { return Matchers::ContainsSubstring(part); }
}  // namespace Catch
