#pragma once

#include <glm/glm.hpp>

namespace texture {

/// The inside of an object for the pattern `object`; called from many threads at once.
struct InsideTest {
    virtual ~InsideTest() = default;
    virtual bool holds(const glm::dvec3& p) const = 0;
};

}  // namespace texture
