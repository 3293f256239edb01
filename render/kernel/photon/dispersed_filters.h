#pragma once

#include <glm/glm.hpp>

namespace trace {

/// What filters the photons that dispersion makes of one (spec 6, 3.5). POV-Ray takes the filter of the surface for the
/// first of them alone; for the others the one that it has evaluated last, on the ways of those before. So only when
/// all ways are known can the others be corrected.
class DispersedFilters {
public:
    /// A photon's part of it.
    struct Part {
        enum class Sample : unsigned char { None, First, Later } sample = Sample::None;
        glm::vec3 own{0.0f};     ///< what the surface filters that made it a sample
        glm::vec3 met{0.0f};     ///< what the surface filters that it comes to; black: nothing gets through
        glm::vec3 factor{1.0f};  ///< of what it leaves, after visit()
    };

    /// What a sample is filtered by until visit().
    static glm::vec3 carried(const glm::vec3& own)
    {
        glm::vec3 out = own;
        for (int c = 0; c < 3; ++c)
            if (own[c] == 0.0f) out[c] = 1.0f;
        return out;
    }

    /// Parts in the order in which POV-Ray follows them, each with the factor of the photon before.
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
