#include "csg/mesh/mesh_shape.h"

#include "numbers/single_precision.h"
#include "csg/mesh/mesh_edges.h"
#include "csg/solids/shared/common.h"

#include <algorithm>

namespace csg {
namespace {

using Corners = std::array<glm::vec3, 3>;

Corners corners(const MeshInput& input, const MeshInput::Face& face)
{
    Corners c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = glm::vec3(input.vertices[face.vertex[k]]);
    return c;
}

bool has_area(const Corners& c)
{
    const glm::dvec3 a(c[0]), n = glm::cross(glm::dvec3(c[1]) - a, glm::dvec3(c[2]) - a);
    const double size = glm::dot(n, n);
    return size > 0.0 && size < kInfinity;
}

bool named(const std::array<std::uint32_t, 3>& indices) { return indices[0] != MeshInput::kNone; }

template <class T>
std::size_t bytes_of(const std::vector<T>& v)
{
    return v.capacity() * sizeof(T);
}

}  // namespace

MeshShape::MeshShape(const MeshInput& input)
{
    std::vector<BvhInput> boxes;
    boxes.reserve(input.faces.size());
    for (std::size_t i = 0; i < input.faces.size(); ++i) {
        const Corners c = corners(input, input.faces[i]);
        if (!has_area(c)) continue;
        Aabb box;
        for (const glm::vec3& corner : c) box.include(glm::dvec3(corner));
        boxes.push_back({box, LeafKind::Triangles, static_cast<std::uint32_t>(i)});
    }
    triangles_ = boxes.size();
    if (input.solid)
        for (const auto& [a, b] : csg::open_edges(input))
            open_edges_.push_back({single(input.vertices[a]), single(input.vertices[b])});
    bvh_ = build_bvh(std::move(boxes));
    fill_blocks(input);
    fill_attributes(input);
}

void MeshShape::fill_blocks(const MeshInput& input)
{
    const auto& first = bvh_.triangle_first;
    if (first.empty()) return;
    blocks_.resize(first.size() - 1);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        for (std::uint32_t place = 0; place < 4; ++place) {
            const bool real = first[b] + place < first[b + 1];
            const std::uint32_t face = bvh_.triangle_members[real ? first[b] + place : first[b]];
            const Corners c = corners(input, input.faces[face]);
            blocks_[b].face[place] = face;
            for (std::size_t k = 0; k < 3; ++k)
                for (int axis = 0; axis < 3; ++axis) blocks_[b].corner[k][axis][place] = real ? c[k][axis] : c[0][axis];
        }
    bvh_.triangle_members = {};  // the blocks say it now
    bvh_.triangle_first = {};
    bvh_.nodes.shrink_to_fit();
}

void MeshShape::fill_attributes(const MeshInput& input)
{
    // Normals that differ by less than this (squared distance of unit vectors) leave a face flat (spec 5b, 3.4).
    constexpr float kSameNormal = 1e-10f;
    for (const glm::dvec3& n : input.normals) normals_.emplace_back(unit_or_x(n));
    for (const glm::dvec2& uv : input.uvs) uvs_.emplace_back(uv);
    const auto any = [&](auto&& has) { return std::any_of(input.faces.begin(), input.faces.end(), has); };
    if (any([](const MeshInput::Face& f) { return named(f.normal); })) normal_of_.reserve(input.faces.size());
    if (any([](const MeshInput::Face& f) { return named(f.uv); })) uv_of_.reserve(input.faces.size());
    if (any([](const MeshInput::Face& f) { return f.slot != 0; })) slots_.reserve(input.faces.size());
    for (const MeshInput::Face& face : input.faces) {
        if (slots_.capacity() != 0) slots_.push_back(face.slot);
        if (uv_of_.capacity() != 0) uv_of_.push_back(face.uv);
        if (normal_of_.capacity() == 0) continue;
        normal_of_.push_back(face.normal);
        if (!named(face.normal)) continue;
        const glm::vec3 a = normals_[face.normal[0]] - normals_[face.normal[1]],
                        b = normals_[face.normal[0]] - normals_[face.normal[2]];
        if (!(glm::dot(a, a) > kSameNormal || glm::dot(b, b) > kSameNormal)) normal_of_.back().fill(MeshInput::kNone);
    }
}

std::size_t MeshShape::bytes() const
{
    return bytes_of(bvh_.nodes) + bytes_of(blocks_) + bytes_of(normal_of_) + bytes_of(uv_of_) + bytes_of(slots_) +
           bytes_of(normals_) + bytes_of(uvs_);
}

glm::dvec3 MeshShape::weights(std::uint32_t face, const glm::dvec3& p) const
{
    const TriangleBlock& block = blocks_[face / 4];
    const glm::dvec3 corner = block.at(0, face % 4), e1 = block.at(1, face % 4) - corner,
                     e2 = block.at(2, face % 4) - corner;
    const glm::dvec3 n = glm::cross(e1, e2), from = p - corner;
    const double n2 = glm::dot(n, n);
    const double u = glm::dot(glm::cross(from, e2), n) / n2, v = glm::dot(glm::cross(e1, from), n) / n2;
    return {1.0 - u - v, u, v};
}

glm::dvec3 MeshShape::normal(std::uint32_t face, const glm::dvec3& p) const
{
    if (!normal_of_.empty()) {
        const auto& n = normal_of_[declared(face)];
        if (named(n)) {
            const glm::dvec3 w = weights(face, p);
            return w.x * glm::dvec3(normals_[n[0]]) + w.y * glm::dvec3(normals_[n[1]]) +
                   w.z * glm::dvec3(normals_[n[2]]);
        }
    }
    const TriangleBlock& block = blocks_[face / 4];
    const glm::dvec3 corner = block.at(0, face % 4);
    return glm::cross(block.at(2, face % 4) - corner, block.at(1, face % 4) - corner);
}

glm::dvec2 MeshShape::uv(std::uint32_t face, const glm::dvec3& p) const
{
    if (uv_of_.empty()) return glm::dvec2(0.0);
    const auto& at = uv_of_[declared(face)];
    if (!named(at)) return glm::dvec2(0.0);
    const glm::dvec3 w = weights(face, p);
    return w.x * glm::dvec2(uvs_[at[0]]) + w.y * glm::dvec2(uvs_[at[1]]) + w.z * glm::dvec2(uvs_[at[2]]);
}

}  // namespace csg
