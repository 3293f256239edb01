#include "bench/embree/rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <pmmintrin.h>
#include <stdexcept>
#include <xmmintrin.h>

namespace embree_bench {

namespace {

/// Flushes denormal numbers to zero while Embree is asked, as its manual recommends.
class FlushToZero {
public:
    FlushToZero() : before_(_mm_getcsr())
    {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~FlushToZero() { _mm_setcsr(before_); }
    FlushToZero(const FlushToZero&) = delete;
    FlushToZero& operator=(const FlushToZero&) = delete;

private:
    unsigned before_;
};

/// A device of one thread and a scene on it.
struct Device {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = nullptr;

    explicit Device(const Scene& from)
    {
        if (device == nullptr) throw std::runtime_error("Embree gives no device");
        scene = rtcNewScene(device);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = from.faces.empty() ? balls(from) : triangles(from);
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree does not take the scene");
    }
    ~Device()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// A new buffer of the geometry for `many` groups of `each` numbers.
    template <class T>
    static T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t each, std::size_t many)
    {
        return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, each * sizeof(T), many));
    }
    RTCGeometry balls(const Scene& from) const
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* out = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, from.balls.size());
        for (const Ball& ball : from.balls) {
            for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(ball.center[axis]);
            *out++ = static_cast<float>(ball.radius);
        }
        return geometry;
    }
    RTCGeometry triangles(const Scene& from) const
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* corner = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3, from.corners.size());
        for (const glm::dvec3& p : from.corners)
            for (int axis = 0; axis < 3; ++axis) *corner++ = static_cast<float>(p[axis]);
        auto* index = buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3, from.faces.size());
        for (const auto& face : from.faces)
            for (const std::uint32_t vertex : face) *index++ = vertex;
        return geometry;
    }
};

constexpr float kBlocked = -std::numeric_limits<float>::infinity();  // tfar of a ray that met anything

/// Ray k of a tile at place i of a packet: `Rays` has arrays, one place a ray.
template <class Rays>
void put(Rays& out, std::size_t i, const csg::RayTile& tile, std::size_t k)
{
    out.org_x[i] = static_cast<float>(tile.ox[k]);
    out.org_y[i] = static_cast<float>(tile.oy[k]);
    out.org_z[i] = static_cast<float>(tile.oz[k]);
    out.dir_x[i] = static_cast<float>(tile.dx[k]);
    out.dir_y[i] = static_cast<float>(tile.dy[k]);
    out.dir_z[i] = static_cast<float>(tile.dz[k]);
    out.tnear[i] = static_cast<float>(tile.t_min[k]);
    out.tfar[i] = static_cast<float>(tile.t_max[k]);
    out.time[i] = 0.0f;
    out.mask[i] = 0xffffffffu;
    out.flags[i] = 0;
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = flags;
    return context;
}

std::uint64_t ask_singly(RTCScene scene, Asked asked, const std::vector<csg::RayTile>& rays)
{
    const FlushToZero flush;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    std::uint64_t found = 0;
    for (const csg::RayTile& tile : rays)
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
            RTCRayHit one;
            const auto single = [k](const auto& lanes) { return static_cast<float>(lanes[k]); };
            one.ray = {single(tile.ox),
                       single(tile.oy),
                       single(tile.oz),
                       single(tile.t_min),
                       single(tile.dx),
                       single(tile.dy),
                       single(tile.dz),
                       0.0f,
                       single(tile.t_max),
                       0xffffffffu,
                       0,
                       0};
            one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            if (asked == Asked::Nearest) {
                rtcIntersect1(scene, &context, &one);
                found += one.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            } else {
                rtcOccluded1(scene, &context, &one.ray);
                found += one.ray.tfar == kBlocked;
            }
        }
    return found;
}

/// Packets of N rays, in the order of the tile: two or four rows of eight pixels.
template <std::size_t N, class RayHits, class Intersect, class Occluded>
std::uint64_t ask_packets(RTCScene scene, Asked asked, const std::vector<csg::RayTile>& rays, Intersect intersect,
                          Occluded occluded)
{
    const FlushToZero flush;
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
    std::uint64_t found = 0;
    for (const csg::RayTile& tile : rays)
        for (std::size_t first = 0; first < static_cast<std::size_t>(tile.count); first += N) {
            const std::size_t many = std::min(N, static_cast<std::size_t>(tile.count) - first);
            alignas(64) std::array<int, N> valid{};
            alignas(64) RayHits packet;
            for (std::size_t i = 0; i < N; ++i) {
                valid[i] = i < many ? -1 : 0;
                put(packet.ray, i, tile, first + (i < many ? i : 0));
                packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
                packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            }
            if (asked == Asked::Nearest) {
                intersect(valid.data(), scene, &context, &packet);
                for (std::size_t i = 0; i < many; ++i) found += packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            } else {
                occluded(valid.data(), scene, &context, &packet.ray);
                for (std::size_t i = 0; i < many; ++i) found += packet.ray.tfar[i] == kBlocked;
            }
        }
    return found;
}

}  // namespace

Built build_embree(const Scene& scene)
{
    const double began = now();
    const auto device = std::make_shared<Device>(scene);
    Built built{.build_s = now() - began, .methods = {}, .hits = {}};
    built.methods.push_back({"Embree", "packets of 16", [device](Asked asked, const auto& rays) {
                                 return ask_packets<16, RTCRayHit16>(device->scene, asked, rays, rtcIntersect16,
                                                                     rtcOccluded16);
                             }});
    built.methods.push_back({"Embree", "packets of 8", [device](Asked asked, const auto& rays) {
                                 return ask_packets<8, RTCRayHit8>(device->scene, asked, rays, rtcIntersect8,
                                                                   rtcOccluded8);
                             }});
    built.methods.push_back({"Embree", "single", [device](Asked asked, const auto& rays) {
                                 return ask_singly(device->scene, asked, rays);
                             }});
    return built;
}

}  // namespace embree_bench
