#pragma once

#include <glm/glm.hpp>

/// Numbers that POV-Ray holds in single precision, as double.
namespace numbers {

/// \return v rounded to a float
inline double single(double v)
{
    auto f = static_cast<float>(v);
#if defined(__GNUC__) && !defined(__clang__)
    // g++ 12 makes vectors of two such conversions side by side and then drops them, there and back, from -O2 on.
    asm("" : "+x"(f));
#endif
    return static_cast<double>(f);
}
inline glm::dvec3 single(const glm::dvec3& p) { return {single(p.x), single(p.y), single(p.z)}; }

}  // namespace numbers
