#pragma once

#include <string>
#include <vector>

namespace numerics {

/// A count of rays of CSG objects that went wrong, and of how many.
struct CsgRow {
    std::string name;
    double value = 0;
    long rays = 0, wrong = 0;
};

/// Thin shells, faces that coincide or nearly do, rays at edges and vertices, operands in another order.
std::vector<CsgRow> csg_checks(long rays);

}  // namespace numerics
