#include "render/solid/mesh/patch.h"

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr double kSharp = 0.94;  // cosine of 20 degrees: normals that differ by more are of two surfaces
constexpr double kWell = 0.5;    // of Finish::off: nearer needs no point of its own
constexpr double kBeyond = 0.5;  // of a tetrahedron's size: so far its surface is looked for
constexpr int kTries = 3;

/// The range of t in which from + t along has all `count` coordinates (given at two points) at least 0.
template <std::size_t N>
void clip(const std::array<double, N>& at, const std::array<double, N>& slope, double& low, double& high)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (slope[i] == 0.0) continue;
        const double t = -at[i] / slope[i];
        if (slope[i] > 0.0) low = std::max(low, t);
        else high = std::min(high, t);
    }
}

std::array<double, 3> barycentric(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p)
{
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::dot(n, n);
    const double u = glm::dot(glm::cross(c - b, p - b), n) / area, v = glm::dot(glm::cross(a - c, p - c), n) / area;
    return {u, v, 1.0 - u - v};
}

std::array<double, 4> barycentric(const std::array<glm::dvec3, 4>& c, const glm::dvec3& p)
{
    const glm::dmat3 m(c[1] - c[0], c[2] - c[0], c[3] - c[0]);
    const glm::dvec3 x = glm::inverse(m) * (p - c[0]);
    return {1.0 - x.x - x.y - x.z, x.x, x.y, x.z};
}

/// `p` moved toward `inner` until no coordinate is below `share_kept` of the least of inner's.
template <std::size_t N>
glm::dvec3 kept_inside(double share_kept, const std::array<double, N>& own, const std::array<double, N>& inner,
                       const glm::dvec3& p, const glm::dvec3& to)
{
    const double least = share_kept * *std::min_element(inner.begin(), inner.end());
    double share = 0.0;
    for (std::size_t i = 0; i < N; ++i)
        if (own[i] < least) share = std::max(share, (least - own[i]) / (inner[i] - own[i]));
    return p + std::min(share, 1.0) * (to - p);
}

/// The place nearest to `point` on the line along the unit vector `out` where the line leaves the body, or passes at
/// all.
/// \param folded  whether parts of the line that the surface is farther from than half of Finish::narrow lie between
///        passages
bool passage(const Body& body, const Finish& finish, const glm::dvec3& point, const glm::dvec3& out, double low,
             double high, bool leaving, SurfacePoint& found, double& t, bool* folded = nullptr)
{
    thread_local std::vector<Chord> chords;
    if (!(low < high)) return false;
    body.chords(point, out, low, high, chords);
    bool any = false;
    const End* last = nullptr;
    for (const Chord& chord : chords)
        for (const End* end : {&chord.in, &chord.out}) {
            if (end->t < low || end->t > high) continue;
            if (folded != nullptr && last != nullptr && end->t - last->t > finish.narrow &&
                2.0 * height_between(body, point, out, *last, *end) > finish.narrow)
                *folded = true;
            last = end;
            if (leaving && end == &chord.in) continue;
            if (any && std::abs(end->t) >= std::abs(t)) continue;
            any = true;
            t = end->t;
            found.point = point + t * out;
            found.normal = body.normal(found.point, *end);
            const bool outward = end == &chord.out;
            if ((glm::dot(found.normal, out) < 0.0) == outward) found.normal = -found.normal;
        }
    return any;
}

}  // namespace

FaceCut cut_face(const Body& body, const Finish& finish, const glm::dvec3& lone, const glm::dvec3& m,
                 const glm::dvec3& n, bool lone_inside, const SurfacePoint& p, const SurfacePoint& q)
{
    FaceCut out;
    const glm::dvec3 across = glm::normalize(glm::cross(m - lone, n - lone));
    const glm::dvec3 chord = q.point - p.point;
    const double size = glm::length(chord);
    glm::dvec3 outward = glm::cross(across, chord);
    const glm::dvec3 middle = 0.5 * (p.point + q.point);
    if ((glm::dot(outward, lone - middle) > 0.0) == lone_inside) outward = -outward;
    outward /= glm::length(outward);
    const auto range = [&](const glm::dvec3& from, double& low, double& high) {
        const auto at = barycentric(lone, m, n, from), next = barycentric(lone, m, n, from + size * outward);
        std::array<double, 3> slope{};
        for (std::size_t i = 0; i < 3; ++i) slope[i] = (next[i] - at[i]) / size;
        low = -numbers::kInfinity;
        high = numbers::kInfinity;
        clip(at, slope, low, high);
    };
    const auto look = [&](const glm::dvec3& from, SurfacePoint& found, double& t, bool* folded) {
        double low = 0.0, high = 0.0;
        range(from, low, high);
        return passage(body, finish, from, outward, low, high, true, found, t, folded);
    };
    SurfacePoint hit;
    double t = 0.0;
    bool folded = false;
    if (!look(middle, hit, t, &folded)) {
        out.coarse = true;
        return out;
    }
    out.coarse = folded;
    const glm::dvec3 g = p.normal - across * glm::dot(across, p.normal),
                     h = q.normal - across * glm::dot(across, q.normal);
    const double gg = glm::length(g), hh = glm::length(h);
    out.sharp = gg > 0.0 && hh > 0.0 && glm::dot(g, h) < kSharp * gg * hh;
    if (std::abs(t) <= kWell * finish.off && !out.sharp) return out;
    // Two lines in the plane of the face meet where both are met; with a third tangent the face's own plane holds it.
    out.bent = true;
    out.place = hit;
    if (out.sharp) {
        const std::array<SurfacePoint, 3> tangents{SurfacePoint{p.point, g / gg}, SurfacePoint{q.point, h / hh},
                                                   SurfacePoint{middle, across}};
        const glm::dvec3 x = meeting_point(tangents, middle);
        const auto own = barycentric(lone, m, n, x);
        SurfacePoint near;
        double off = 0.0;
        if (*std::min_element(own.begin(), own.end()) > 0.0 && look(x, near, off, nullptr) &&
            std::abs(off) < 0.5 * finish.off) {
            out.place = near;
            if (std::abs(off) < kWell * finish.off) out.place.point = x;
        } else if (std::abs(t) <= kWell * finish.off) {
            out.bent = false;  // the normals differ, the places do not
            out.sharp = false;
            return out;
        } else {
            out.sharp = false;
        }
    }
    const glm::dvec3 meant = out.place.point;
    out.place.point =
        kept_inside(finish.inner, barycentric(lone, m, n, meant), barycentric(lone, m, n, middle), meant, middle);
    if (glm::length(out.place.point - meant) > kWell * finish.off) out.coarse = true;
    for (const SurfacePoint* end : {&p, &q}) {
        SurfacePoint near;
        double off = 0.0;
        if (!look(0.5 * (end->point + out.place.point), near, off, nullptr) || std::abs(off) > finish.off)
            out.coarse = true;
    }
    return out;
}

namespace {

/// How far the middle of a triangle is from the body, along its normal.
bool too_far(const Body& body, const Finish& finish, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
             double room)
{
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double area = glm::length(n);
    const double side = std::max(glm::length(b - a), std::max(glm::length(c - a), glm::length(c - b)));
    if (area < side * finish.off * 0.5) return false;  // lower than what is exact enough
    SurfacePoint near;
    double t = 0.0;
    return !passage(body, finish, (a + b + c) / 3.0, n / area, -room, room, false, near, t) || std::abs(t) > finish.off;
}

/// Of four corners: 0 is the diagonal from the first to the third, 1 the other; the one that bends less.
int flatter_diagonal(const Polygon& polygon)
{
    if (polygon.count != 4) return 0;
    const auto point = [&](std::size_t i) { return polygon.corners[i % polygon.count].place.point; };
    const auto bend = [&](std::size_t d) {
        const glm::dvec3 a = glm::cross(point(d + 1) - point(d), point(d + 2) - point(d)),
                         b = glm::cross(point(d + 2) - point(d), point(d + 3) - point(d));
        const double l = glm::length(a) * glm::length(b);
        return l > 0.0 ? glm::dot(a, b) / l : -1.0;
    };
    return bend(1) > bend(0) ? 1 : 0;
}

/// Whether the polygon's one or two triangles are the body's surface, without an edge of it between the corners.
bool lies_on(const Body& body, const Finish& finish, const Polygon& polygon, std::size_t d, double room)
{
    double least_cosine = 1.0;
    for (std::size_t i = 0; i < polygon.count; ++i)
        for (std::size_t k = 0; k < i; ++k)
            least_cosine =
                std::min(least_cosine, glm::dot(polygon.corners[i].place.normal, polygon.corners[k].place.normal));
    const auto point = [&](std::size_t i) { return polygon.corners[i % polygon.count].place.point; };
    return least_cosine >= kSharp && !too_far(body, finish, point(d), point(d + 1), point(d + 2), room) &&
           (polygon.count != 4 || !too_far(body, finish, point(d), point(d + 2), point(d + 3), room));
}

/// The mean of the sharp points on faces where there are any, else of all corners.
glm::dvec3 middle_of(const Polygon& polygon)
{
    glm::dvec3 all(0.0), sharp(0.0);
    int sharp_ones = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Polygon::Corner& c = polygon.corners[i];
        all += c.place.point;
        if (!c.on_face || !c.sharp) continue;
        sharp += c.place.point;
        ++sharp_ones;
    }
    return sharp_ones > 0 ? sharp / static_cast<double>(sharp_ones) : all / static_cast<double>(polygon.count);
}

/// Where the polygon looks to: the mean normal of its corners, unless that contradicts their order.
glm::dvec3 outward_of(const Polygon& polygon)
{
    glm::dvec3 normal(0.0), area(0.0);
    const glm::dvec3 first = polygon.corners[0].place.point;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const SurfacePoint& at = polygon.corners[i].place;
        area += glm::cross(at.point - first, polygon.corners[(i + 1) % polygon.count].place.point - first);
        normal += at.normal;
    }
    if (glm::length(normal) > 0.1 && glm::dot(normal, area) > 0.0) return glm::normalize(normal);
    return glm::length(area) > 0.0 ? glm::normalize(area) : glm::dvec3(0, 0, 1);
}

/// The tangent planes of the corners meet on the edge or in the corner of the body, where there is one. coarse: no ray
/// says that the place lies on the body.
glm::dvec3 centre_of(const Body& body, const Finish& finish, const std::array<glm::dvec3, 4>& corners,
                     const Polygon& polygon, double room, bool& coarse)
{
    std::array<SurfacePoint, 8 + kTries> tangents;
    std::size_t known = 0;
    for (std::size_t i = 0; i < polygon.count; ++i)
        if (!polygon.corners[i].on_face || !polygon.corners[i].sharp) tangents[known++] = polygon.corners[i].place;
    const glm::dvec3 start = middle_of(polygon), outward = outward_of(polygon);
    SurfacePoint hit;
    double t = 0.0;
    for (int i = 0; i < kTries; ++i) {
        const glm::dvec3 place = meeting_point(std::span(tangents.data(), known), start);
        const auto own = barycentric(corners, place);
        if (*std::min_element(own.begin(), own.end()) <= 0.0) break;
        if (!passage(body, finish, place, outward, -room, room, true, hit, t)) break;
        if (std::abs(t) <= kWell * finish.off) return place;
        tangents[known++] = hit;
    }
    if (passage(body, finish, start, outward, -room, room, true, hit, t)) return hit.point;
    coarse = true;
    return start;
}

}  // namespace

CentreCut cut_centre(const Body& body, const Finish& finish, const std::array<glm::dvec3, 4>& corners,
                     const Polygon& polygon)
{
    const double room = kBeyond * glm::max(glm::length(corners[1] - corners[0]), glm::length(corners[3] - corners[2]));
    CentreCut out;
    if (!polygon.any_on_face) {
        out.diagonal = flatter_diagonal(polygon);
        out.needed = !lies_on(body, finish, polygon, static_cast<std::size_t>(out.diagonal), room);
        if (!out.needed) return out;
    }
    out.needed = true;
    glm::dvec3 inner(0.0);
    int crossings = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        if (polygon.corners[i].on_face) continue;
        inner += polygon.corners[i].place.point;
        ++crossings;
    }
    inner /= crossings;
    const glm::dvec3 meant = centre_of(body, finish, corners, polygon, room, out.coarse);
    out.place = kept_inside(finish.inner, barycentric(corners, meant), barycentric(corners, inner), meant, inner);
    if (glm::length(out.place - meant) > finish.off) out.coarse = true;
    for (std::size_t i = 0; i < polygon.count && !out.coarse; ++i)
        out.coarse = too_far(body, finish, polygon.corners[i].place.point,
                             polygon.corners[(i + 1) % polygon.count].place.point, out.place, room);
    return out;
}

}  // namespace solid
