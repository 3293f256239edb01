#pragma once

#include "csg/base/hit.h"
#include "csg/base/types.h"

#include <array>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

/// The scenes and rays that both are asked about, and what they answer.
namespace embree_bench {

struct Ball {
    glm::dvec3 center;
    double radius;
};

/// Balls or triangles, never both.
struct Scene {
    std::string name;
    std::vector<Ball> balls;
    std::vector<glm::dvec3> corners;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

/// Whether a question wants the nearest hit or any hit.
enum class Asked { Nearest, Any };

/// One way to ask all rays.
struct Method {
    std::string program, name;
    std::function<std::uint64_t(Asked, const std::vector<csg::RayTile>&)> ask;  ///< how many rays hit
};

/// Seconds of building, and what can be asked.
struct Built {
    double build_s = 0.0;
    std::vector<Method> methods;
    std::function<csg::HitTile(const csg::RayTile&)> hits;  ///< of ours alone: where the shadow rays begin
};

Built build_ours(const Scene& scene);
Built build_embree(const Scene& scene);

/// Processor seconds: work of others on the machine matters less.
inline double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace embree_bench
