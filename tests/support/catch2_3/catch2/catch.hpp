#pragma once

#include <catch2/catch_all.hpp>

#include <string>

/// Catch2 3 under the names that Catch2 2 has them by, so that the tests are written once; in the include path where 3 is installed.
using Catch::Approx;

namespace Catch {
using Matchers::EndsWith;
using Matchers::Matches;
using Matchers::StartsWith;
inline auto Contains(const std::string& part) { return Matchers::ContainsSubstring(part); }
}  // namespace Catch
