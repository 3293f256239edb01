#include "csg/freeform/surface/bicubic_patch.h"

#include "csg/mesh/mesh_query.h"
#include "csg/solids/shared/common.h"

#include <unordered_map>

namespace csg {
namespace {

using Row = std::array<glm::dvec3, 4>;
using Points = BicubicPatch::Points;

constexpr double kSame =
    1e-10;  // POV-Ray's: corners apart; the square of the sine of an angle that is none (spec 5b, 5)

/// The halves of a cubic curve (de Casteljau).
void halve(const Row& c, Row& low, Row& high)
{
    const glm::dvec3 a = 0.5 * (c[0] + c[1]), b = 0.5 * (c[1] + c[2]), d = 0.5 * (c[2] + c[3]), ab = 0.5 * (a + b),
                     bd = 0.5 * (b + d);
    const glm::dvec3 middle = 0.5 * (ab + bd);
    low = {c[0], a, ab, middle};
    high = {middle, bd, d, c[3]};
}

Points turned(const Points& p)
{
    Points out;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) out[j][i] = p[i][j];
    return out;
}

void halve_v(const Points& p, Points& low, Points& high)
{
    for (std::size_t i = 0; i < 4; ++i) halve(p[i], low[i], high[i]);
}

void halve_u(const Points& p, Points& low, Points& high)
{
    Points a, b;
    halve_v(turned(p), a, b);
    low = turned(a);
    high = turned(b);
}

bool same(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 apart = glm::abs(a - b);
    return apart.x < kSame && apart.y < kSame && apart.z < kSame;
}

/// Bernstein's polynomials and their slopes.
void weights(double t, double (&value)[4], double (&slope)[4])
{
    const double s = 1.0 - t;
    value[0] = s * s * s;
    value[1] = 3.0 * t * s * s;
    value[2] = 3.0 * t * t * s;
    value[3] = t * t * t;
    slope[0] = -3.0 * s * s;
    slope[1] = 3.0 * s * (s - 2.0 * t);
    slope[2] = 3.0 * t * (2.0 * s - t);
    slope[3] = 3.0 * t * t;
}

glm::dvec3 unit_or_zero(const glm::dvec3& n) { return n == glm::dvec3(0.0) ? n : unit_or_x(n); }

/// Places are multiples of 2^-kMostSteps, which single precision holds.
std::uint32_t step_of(double t) { return static_cast<std::uint32_t>(t * (1u << BicubicPatch::kMostSteps)); }

/// Whether two edges span an area worth the name.
bool spans_area(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 n = glm::cross(a, b);
    return glm::dot(n, n) > kSame * glm::dot(a, a) * glm::dot(b, b);
}

}  // namespace

BicubicPatch::BicubicPatch(const Input& input) : input_(input)
{
    input_.u_steps = std::clamp(input_.u_steps, 0, kMostSteps);
    input_.v_steps = std::clamp(input_.v_steps, 0, kMostSteps);
    MeshInput triangles;
    divide(input_.points, {0.0f, 1.0f, 0.0f, 1.0f}, 0, triangles);
    // Four pieces meet at most corners: each normal is worked out once.
    std::unordered_map<std::uint64_t, glm::vec3> known;
    for (const Piece& piece : pieces_) {
        std::array<glm::vec3, 4>& normals = normals_.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec2 at = parameters(piece)[k];
            const auto [found, fresh] = known.try_emplace(std::uint64_t{step_of(at.x)} << 32 | step_of(at.y));
            if (fresh) found->second = glm::vec3(unit_or_zero(normal_at(at)));
            normals[k] = found->second;
        }
    }
    mesh_ = std::make_shared<MeshShape>(triangles);
}

/// Whether no control point is as far as the flatness from the plane of three corners.
bool BicubicPatch::flat(const Points& p) const
{
    const glm::dvec3 a = p[0][0];
    glm::dvec3 b = p[0][3], c = p[3][0];
    if (same(a, b)) b = p[3][3];
    else if (same(a, c) || same(b, c)) c = p[3][3];
    if (same(a, b) || same(a, c) || same(b, c)) return false;
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = std::sqrt(glm::dot(n, n));
    if (!(length > kSame)) return false;
    double farthest = 0.0;
    for (const Row& row : p)
        for (const glm::dvec3& point : row) farthest = std::max(farthest, std::abs(glm::dot(point - a, n)) / length);
    return farthest < input_.flatness;
}

void BicubicPatch::divide(const Points& p, const Piece& piece, int depth, MeshInput& out)
{
    const bool more_u = depth < input_.u_steps, more_v = depth < input_.v_steps;
    if ((more_u || more_v) && !flat(p)) {
        const float u = 0.5f * (piece.u0 + piece.u1), v = 0.5f * (piece.v0 + piece.v1);
        std::array<Points, 2> halves{p, p};
        if (more_u) halve_u(p, halves[0], halves[1]);
        for (std::size_t h = 0; h < (more_u ? 2u : 1u); ++h) {
            Piece half = piece;
            if (more_u) (h == 0 ? half.u1 : half.u0) = u;
            if (!more_v) {
                divide(halves[h], half, depth + 1, out);
                continue;
            }
            Points low, high;
            halve_v(halves[h], low, high);
            divide(low, {half.u0, half.u1, half.v0, v}, depth + 1, out);
            divide(high, {half.u0, half.u1, v, half.v1}, depth + 1, out);
        }
        return;
    }
    pieces_.push_back(piece);
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    const glm::dvec3 c[4] = {p[0][0], p[0][3], p[3][3], p[3][0]};
    out.vertices.insert(out.vertices.end(), c, c + 4);
    for (const std::uint32_t k : {1u, 2u}) {
        MeshInput::Face face;
        // A face without an area keeps its place and is never met.
        const bool real = spans_area(c[k] - c[0], c[k + 1] - c[0]);
        face.vertex = {first, first + (real ? k : 0u), first + (real ? k + 1 : 0u)};
        out.faces.push_back(face);
    }
}

void BicubicPatch::intersect(const Ray& ray, IntersectionList& out) const
{
    mesh_crossings(*mesh_, ray, out.from, out.to, [&](double t, std::uint32_t face) {
        out.touch(t, face);
        return out.first_only ? t : out.to;
    });
}

/// (u, v) at the corners of a piece.
std::array<glm::dvec2, 4> BicubicPatch::parameters(const Piece& p)
{
    return {glm::dvec2(p.u0, p.v0), glm::dvec2(p.u0, p.v1), glm::dvec2(p.u1, p.v1), glm::dvec2(p.u1, p.v0)};
}

glm::dvec3 BicubicPatch::normal_at(const glm::dvec2& q) const
{
    double u[4], du[4], v[4], dv[4];
    weights(q.x, u, du);
    weights(q.y, v, dv);
    glm::dvec3 along_u(0.0), along_v(0.0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            along_u += du[i] * v[j] * input_.points[i][j];
            along_v += u[i] * dv[j] * input_.points[i][j];
        }
    return spans_area(along_u, along_v) ? glm::cross(along_u, along_v) : glm::dvec3(0.0);
}

glm::dvec3 BicubicPatch::world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const
{
    const glm::dvec3 share = mesh_->weights(face, p);
    const std::uint32_t which = declared(face);
    const std::array<std::size_t, 3> at = corners(which);
    // POV-Ray moves the points: a mirrored patch has its normals on the other side.
    const double side = glm::determinant(frame.linear) < 0.0 ? -1.0 : 1.0;
    glm::dvec3 sum(0.0);
    for (int k = 0; k < 3; ++k)
        sum += share[k] *
               unit_or_x(side * frame.normal(glm::dvec3(normals_[which / 2][at[static_cast<std::size_t>(k)]])));
    return sum;
}

glm::dvec2 BicubicPatch::uv(const glm::dvec3& p, std::uint32_t face) const
{
    const glm::dvec3 share = mesh_->weights(face, p);
    const std::uint32_t which = declared(face);
    const std::array<glm::dvec2, 4> all = parameters(pieces_[which / 2]);
    const std::array<std::size_t, 3> at = corners(which);
    const glm::dvec2 q = share.x * all[at[0]] + share.y * all[at[1]] + share.z * all[at[2]];
    const auto& c = input_.uv;
    return glm::mix(glm::mix(c[0], c[1], q.y), glm::mix(c[3], c[2], q.y), q.x);
}

Aabb BicubicPatch::extent() const
{
    Aabb box;
    for (const Row& row : input_.points)
        for (const glm::dvec3& point : row) box.include(point);
    return box;
}

}  // namespace csg
