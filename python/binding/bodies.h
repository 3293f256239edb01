#pragma once

#include "python/binding/scene.h"
#include "render/solid/measure/measure.h"
#include "render/solid/mesh/triangle_mesh.h"
#include "render/solid/section/cutting_plane.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace python {

/// Which objects of a scene are asked.
struct Asked {
    Words words;
    std::string object;  ///< name; empty: all
};

/// What is told of an object; where `problem` has words it is no body, or not the one that was wanted.
struct Told {
    std::string name, problem;
};

struct ToldMeasures : Told {
    solid::Measures measures;
};

struct ToldMesh : Told {
    solid::TriangleMesh mesh;
    std::vector<glm::vec3> normals;              ///< of the vertices, out of the body
    std::array<double, 3> color{0.7, 0.7, 0.7};  ///< sRGB, 0 to 1
    double deviation = 0.0;                      ///< scene units, as sampled
};

struct ToldSection : Told {
    std::vector<solid::Loop> loops;
    double area = 0.0, area_error = 0.0, deviation = 0.0;
};

/// How far meshes and sections may be off, and what that may cost.
struct Fineness {
    double tolerance = 0.01;  ///< scene units
    int cells = 16;           ///< of the first lattice
    double seconds = 60.0;    ///< of an object
};

std::vector<ToldMeasures> measure(const std::shared_ptr<Source>& source, const Asked& asked, double precision);
std::vector<ToldMesh> mesh(const std::shared_ptr<Source>& source, const Asked& asked, const Fineness& fineness);
std::vector<ToldSection> section(const std::shared_ptr<Source>& source, const Asked& asked,
                                 const solid::CuttingPlane& plane, const Fineness& fineness);

/// Rays that meet solids: those of ray i are [first[i], first[i + 1]).
struct Spans {
    std::vector<std::int64_t> first;
    /// Of each span: where the ray goes in and out, in lengths of its direction; the first may be behind its start.
    std::vector<std::array<double, 2>> ends;
    std::vector<std::int32_t> object;  ///< of each: index into names
    std::vector<std::string> names;
};

/// Three numbers a ray in each; directions of any length but 0.
struct Rays {
    std::vector<double> origins, directions;
    std::size_t size() const { return origins.size() / 3; }
    csg::Ray operator[](std::size_t i) const
    {
        const double *o = &origins[3 * i], *d = &directions[3 * i];
        return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
    }
};

/// Throws app::OptionError for a ray that is none.
std::shared_ptr<Spans> spans(const std::shared_ptr<Source>& source, const Asked& asked, Rays rays);

}  // namespace python
