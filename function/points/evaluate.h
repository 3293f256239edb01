#pragma once

#include "function/program.h"

namespace function {

/// Points per lane call.
inline constexpr int kLanes = 8;

using Values = std::array<double, 5>;

/// The function at `arguments` (Function::parameters of them); components past Function::components are unspecified.
Values evaluate_all(const Function& function, const double* arguments, const Host& host);
/// Its first component.
double evaluate(const Function& function, const double* arguments, const Host& host);

/// The first `components` at eight points: arguments[i][lane], out[component * kLanes + lane]. Equal to evaluate_all()
/// bit for bit.
void evaluate_lanes(const Function& function, const double (*arguments)[kLanes], const Host& host,
                    std::uint32_t components, double* out);

/// Any host for functions that ask nothing of the scene.
const Host& no_host();

}  // namespace function
