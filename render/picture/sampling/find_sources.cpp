#include "render/picture/sampling/find_sources.h"

#include "numbers/functions/functions.h"
#include "render/picture/threads.h"
#include "render/texture/evaluate.h"
#include "render/texture/finish.h"

#include <algorithm>
#include <cmath>

namespace trace::path {
namespace {

float brightest(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

/// The light of a surface that gives off the same everywhere, to any side; 0 for others.
glm::vec3 even_light(const plan::CompiledScene& scene, const plan::Surface& surface)
{
    const texture::TextureSet& set = scene.textures;
    if (surface.texture == plan::kNone || surface.blends() || surface.interior_texture != plan::kNone)
        return glm::vec3(0);
    const texture::Texture& texture = set.textures[surface.texture];
    if (texture.kind != texture::Texture::Kind::Layers || texture.count != 1) return glm::vec3(0);
    const texture::Layer& layer = set.layers[texture.first];
    const texture::Pigment& pigment = set.pigments[layer.pigment];
    if (pigment.kind != texture::Pigment::Kind::Solid) return glm::vec3(0);
    const texture::Finish& finish = set.finishes[layer.finish];
    const float share = texture.plain ? 1.0f : texture::opacity(pigment.color, set.legacy_opacity);
    return pigment.color.rgb() * (finish.ambient + finish.emission) * share;
}

/// The faces of a box, in the order of csg::BoxFace.
void add_faces(Emitter& out, const glm::dvec3& lower, const glm::dvec3& upper, const csg::Transform* frame)
{
    const glm::dvec3 size = upper - lower;
    const auto point = [&](const glm::dvec3& p) { return frame ? frame->point(p) : p; };
    const auto vector = [&](const glm::dvec3& v) { return frame ? frame->vector(v) : v; };
    glm::dvec3 middle = point(0.5 * (lower + upper));
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            glm::dvec3 corner = lower, a(0), b(0);
            if (side == 1) corner[axis] = upper[axis];
            a[(axis + 1) % 3] = size[(axis + 1) % 3];
            b[(axis + 2) % 3] = size[(axis + 2) % 3];
            Emitter::Face face;
            face.corner = point(corner);
            face.a = vector(a);
            face.b = vector(b);
            glm::dvec3 n = glm::cross(face.a, face.b);
            face.area = glm::length(n);
            glm::dvec3 outward(0);
            outward[axis] = side == 0 ? -1.0 : 1.0;
            if (face.area > 0.0) n /= face.area;
            if (glm::dot(n, frame ? frame->normal(outward) : outward) < 0.0) n = -n;
            face.normal = n;
            out.faces.push_back(face);
        }
    out.center = middle;
}

/// A flat face of a given shape. area: as a share of the parallelogram of a and b
Emitter::Face flat(Emitter::Face::Shape shape, const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b,
                   double area)
{
    Emitter::Face out;
    out.shape = shape;
    out.corner = corner;
    out.a = a;
    out.b = b;
    const glm::dvec3 n = glm::cross(a, b);
    const double length = glm::length(n);
    out.area = area * length;
    out.normal = length > 0.0 ? n / length : n;
    return out;
}

/// Faces that are seen from both sides and may hide each other.
void add_two_sided(Emitter& out, std::vector<Emitter::Face> faces)
{
    out.convex = false;
    double sum = 0.0;
    for (const Emitter::Face& face : faces) out.ends.push_back(sum += face.area);
    out.faces = std::move(faces);
}

bool add_disc(Emitter& out, const csg::Disc& disc)
{
    const double hole = disc.radius > 0.0 ? disc.hole / disc.radius : 1.0;
    if (!(hole < 1.0)) return false;
    const glm::dvec3 a = disc.frame.vector({disc.radius, 0.0, 0.0}), b = disc.frame.vector({0.0, disc.radius, 0.0});
    Emitter::Face ring =
        flat(Emitter::Face::Shape::Ring, disc.frame.point(glm::dvec3(0.0)), a, b, kPi * (1.0 - hole * hole));
    ring.hole = hole;
    add_two_sided(out, {ring});
    return true;
}

/// A closed one whose section is a circle across its axis, faces in the order of csg::TubeFace.
bool add_cylinder(Emitter& out, const csg::Cylinder& tube)
{
    constexpr double kRound = 1e-9;
    using Shape = Emitter::Face::Shape;
    const glm::dvec3 base = tube.frame.point(glm::dvec3(0.0)), a = tube.frame.vector({1.0, 0.0, 0.0}),
                     b = tube.frame.vector({0.0, 1.0, 0.0}), axis = tube.frame.vector({0.0, 0.0, 1.0});
    const double radius = glm::length(a), length = glm::length(axis);
    if (tube.open || !(radius > 0.0) || !(length > 0.0)) return false;
    if (std::abs(glm::length(b) - radius) > kRound * radius || std::abs(glm::dot(a, b)) > kRound * radius * radius ||
        std::abs(glm::dot(a, axis)) + std::abs(glm::dot(b, axis)) > kRound * radius * length)
        return false;
    Emitter::Face side;
    side.shape = Shape::Side;
    side.corner = base;
    side.a = a;
    side.b = b;
    side.axis = axis;
    side.area = 2.0 * kPi * radius * length;
    side.normal = glm::dvec3(0);
    Emitter::Face low = flat(Shape::Ring, base, a, b, kPi), high = flat(Shape::Ring, base + axis, a, b, kPi);
    low.normal = -axis / length;
    high.normal = axis / length;
    out.faces = {side, low, high};
    return true;
}

/// With one surface for all its faces, and not too many of them.
bool add_mesh(Emitter& out, const csg::Mesh& mesh)
{
    constexpr std::size_t kMostBlocks = 250'000;
    const std::size_t blocks = mesh.shape->blocks();
    if (mesh.surfaces.size() != 1 || mesh.blends || blocks > kMostBlocks) return false;
    std::vector<Emitter::Face> faces;
    faces.reserve(4 * blocks);
    for (std::uint32_t i = 0; i < 4 * blocks; ++i) {
        const auto corner = [&](std::uint32_t k) { return mesh.frame.point(mesh.shape->block(i / 4).at(k, i % 4)); };
        const glm::dvec3 first = corner(0);
        faces.push_back(flat(Emitter::Face::Shape::Triangle, first, corner(1) - first, corner(2) - first, 0.5));
    }
    add_two_sided(out, std::move(faces));
    return true;
}

bool add_body(const csg::SolidStore& store, Emitter& out, double& area)
{
    const std::uint32_t i = csg::index_of(out.part);
    switch (csg::kind_of(out.part)) {
    case csg::SolidKind::Sphere: {
        const csg::Sphere& ball = store.all<csg::Sphere>()[i];
        out.sphere = true;
        out.center = ball.center;
        out.radius = ball.radius;
        area = 4.0 * kPi * ball.radius * ball.radius;
        return ball.radius > 0.0;
    }
    case csg::SolidKind::Box: {
        const csg::Box& box = store.all<csg::Box>()[i];
        add_faces(out, box.lower, box.upper, nullptr);
        break;
    }
    case csg::SolidKind::OrientedBox: {
        const csg::OrientedBox& box = store.all<csg::OrientedBox>()[i];
        add_faces(out, box.lower, box.upper, &box.frame);
        break;
    }
    case csg::SolidKind::Cylinder:
        if (!add_cylinder(out, store.all<csg::Cylinder>()[i])) return false;
        break;
    case csg::SolidKind::Disc:
        if (!add_disc(out, store.all<csg::Disc>()[i])) return false;
        break;
    case csg::SolidKind::Triangle: {
        const csg::Triangle& triangle = store.all<csg::Triangle>()[i];
        add_two_sided(out,
                      {flat(Emitter::Face::Shape::Triangle, triangle.corner, triangle.edge1, triangle.edge2, 0.5)});
        break;
    }
    case csg::SolidKind::Mesh:
        if (!add_mesh(out, store.all<csg::Mesh>()[i])) return false;
        break;
    default: return false;  // paths find it by chance
    }
    area = 0.0;
    for (const Emitter::Face& face : out.faces) area += face.area;
    return area > 0.0;
}

/// Of a mesh, that of its faces if there is but one.
csg::SurfaceId surface_of(const csg::SolidStore& store, csg::PartId part)
{
    if (csg::kind_of(part) != csg::SolidKind::Mesh) return store.surface(part);
    const auto& surfaces = store.all<csg::Mesh>()[csg::index_of(part)].surfaces;
    return surfaces.size() == 1 ? surfaces[0] : csg::kNoSurface;
}

void find_emitters(const plan::CompiledScene& scene, std::vector<Emitter>& out)
{
    const csg::WorldData& world = scene.geometry;
    double sum = 0.0;
    for (const csg::WorldItem& item : world.items) {
        if (item.solid == csg::kNoPart || item.inverted || item.guard != csg::WorldItem::kNoGuard) continue;
        if ((item.visible & plan::bit(plan::RayKind::Gather)) == 0) continue;
        Emitter body;
        const csg::SurfaceId surface = surface_of(world.store, item.solid);
        if (surface == csg::kNoSurface) continue;
        body.radiance = even_light(scene, scene.surfaces[surface]);
        const float light = brightest(body.radiance);
        body.part = item.solid;
        double area = 0.0;
        if (!(light > 0.0f) || !add_body(world.store, body, area)) continue;
        sum += body.chance = static_cast<double>(light) * area;
        out.push_back(std::move(body));
    }
    for (Emitter& body : out) body.chance /= sum;
    std::sort(out.begin(), out.end(), [](const Emitter& a, const Emitter& b) { return a.part < b.part; });
}

float sky_brightness(const plan::CompiledScene& scene, const glm::dvec3& direction)
{
    const texture::Sky& sky = scene.sky;
    const texture::Surroundings around{{}, {}, direction};
    glm::vec3 sum(0), filter(1);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const scene::Color c = texture::pigment_color(scene.textures, sky.layers[i], direction, around);
        sum += c.rgb() * (1.0f - c.filter - c.transmit) * filter * sky.emission;
        filter *= c.rgb() * c.filter + c.transmit;
    }
    return std::max(0.0f, brightest(sum + filter * sky.background.rgb()));
}

/// Cells fine enough for the texels of a picture.
std::size_t columns_for(const plan::CompiledScene& scene)
{
    constexpr std::size_t kLeast = 512, kMost = 2048;
    std::size_t columns = kLeast;
    const texture::TextureSet& set = scene.textures;
    const auto shows = [&](std::uint32_t layer) { return set.pigments[layer].kind == texture::Pigment::Kind::Image; };
    if (std::none_of(scene.sky.layers.begin(), scene.sky.layers.end(), shows)) return columns;
    for (const texture::Image& image : set.images)
        while (columns < kMost && columns < image.width) columns *= 2;
    return columns;
}

/// Each cell as bright as the brightest of its middle and its corners, so that little is missed that lies between.
std::vector<float> sky_cells(const plan::CompiledScene& scene, std::size_t columns, std::size_t rows,
                             trace::Threads& threads)
{
    const auto at = [&](double x, double y) {
        return sky_brightness(scene,
                              SkyTable::direction(x / static_cast<double>(columns), y / static_cast<double>(rows)));
    };
    std::vector<float> corners(columns * (rows + 1)), cells(columns * rows);
    threads.each(0, rows + 1, [&](std::size_t y, int) {
        for (std::size_t x = 0; x < columns; ++x)
            corners[y * columns + x] = at(static_cast<double>(x), static_cast<double>(y));
    });
    threads.each(0, rows, [&](std::size_t y, int) {
        for (std::size_t x = 0; x < columns; ++x) {
            const std::size_t next = (x + 1) % columns;
            cells[y * columns + x] = std::max({at(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5),
                                               corners[y * columns + x], corners[y * columns + next],
                                               corners[(y + 1) * columns + x], corners[(y + 1) * columns + next]});
        }
    });
    return cells;
}

std::unique_ptr<const SkyTable> find_sky(const plan::CompiledScene& scene, int threads)
{
    if (scene.sky.layers.empty()) return nullptr;  // light from everywhere alike needs no aim
    const std::size_t columns = columns_for(scene), rows = columns / 2;
    trace::Threads sharing(threads);
    std::vector<float> cells = sky_cells(scene, columns, rows, sharing);
    double sum = 0.0, all = 0.0;
    float most = 0.0f;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double share = numbers::sin(kPi * (static_cast<double>(i / columns) + 0.5) / static_cast<double>(rows));
        sum += share * static_cast<double>(cells[i]);
        all += share;
        most = std::max(most, cells[i]);
    }
    constexpr double kEven = 2.0;  // times the mean: surfaces find such light by themselves
    const double mean = sum / all;
    if (!(mean > 0.0) || !(static_cast<double>(most) > kEven * mean)) return nullptr;
    for (float& cell : cells) cell += static_cast<float>(0.02 * mean);  // what lies between the places asked
    return std::make_unique<const SkyTable>(columns, rows, cells);
}

}  // namespace

Sources find_sources(const plan::CompiledScene& scene, int threads)
{
    Sources out;
    find_emitters(scene, out.emitters);
    out.sky = find_sky(scene, trace::threads_of(threads));
    return out;
}

}  // namespace trace::path
