#pragma once

#include "function/program.h"

namespace function {

/// Points in lanes together.
inline constexpr int kLanes = 8;
inline constexpr std::size_t kMostTogether = 64;  ///< points of a call

using Values = std::array<double, 5>;

/// The function at `arguments` (Function::parameters of them); components past Function::components are unspecified.
Values evaluate_all(const Function& function, const double* arguments, const Host& host);
/// Its first component.
double evaluate(const Function& function, const double* arguments, const Host& host);

/// The first `components` at so many points, a multiple of kLanes up to kMostTogether: arguments[i][point],
/// out[component][point]. Equal to evaluate_all() bit for bit.
void evaluate_lanes(const Function& function, const double* const* arguments, std::size_t count, const Host& host,
                    std::uint32_t components, double* const* out);

/// Any host for functions that ask nothing of the scene.
const Host& no_host();

}  // namespace function
