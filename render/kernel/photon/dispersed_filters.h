#pragma once

#include <glm/glm.hpp>

namespace trace {

/// What filters the samples, photons that dispersion makes of one (spec 6, 3.5). POV-Ray filters only the first by the
/// surface; each other sample by what it worked out last, on the way of the sample before. So the others can only be
/// corrected when all ways are known.
class DispersedFilters {
public:
    /// What is known of one photon, a sample or not.
    struct Part {
        enum class Sample : unsigned char { None, First, Later } sample = Sample::None;
        glm::vec3 own{0.0f};     ///< filter of the surface that made it a sample
        glm::vec3 met{0.0f};     ///< filter of the surface that it comes to; black if opaque
        glm::vec3 factor{1.0f};  ///< by which the flux that it leaves is off; before visit(), that of the photon before
    };

    /// What a sample is filtered by at first: its surface's filter, but 1 in channels that would be lost for good.
    static glm::vec3 carried(const glm::vec3& own)
    {
        glm::vec3 out = own;
        for (int c = 0; c < 3; ++c)
            if (own[c] == 0.0f) out[c] = 1.0f;
        return out;
    }

    /// Takes photons in the order in which POV-Ray follows them.
    void visit(Part& part)
    {
        if (part.sample == Part::Sample::First) last_ = part.own;
        if (part.sample != Part::Sample::None) part.factor *= last_ / carried(part.own);
        if (part.met != glm::vec3(0.0f)) last_ = part.met;
    }

private:
    glm::vec3 last_{1.0f};
};

}  // namespace trace
