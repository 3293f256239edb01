#include "render/plan/images.h"
#include "render/plan/probe.h"
#include "render/plan/textures.h"

/// What patterns look their values up in: pictures, densities, objects. Each is taken once, however often it is used.
namespace plan {
namespace {

struct ProbedObject final : texture::InsideTest {
    ProbedObject(const scene::Object& object, const scene::GlobalSettings& global) : probe(object, global) {}
    bool holds(const glm::dvec3& p) const override { return probe.inside(p); }
    ObjectProbe probe;
};

std::uint32_t size_of(std::size_t n) { return static_cast<std::uint32_t>(n); }

}  // namespace

std::uint32_t TextureCompiler::pattern_data(const scene::Pattern& description, texture::PatternKind kind)
{
    using texture::PatternKind;
    if (kind != PatternKind::Image && kind != PatternKind::DensityFile && kind != PatternKind::Object) return texture::kNone;
    const scene::Statement& statement = *description.block;
    const auto first_size = kind == PatternKind::Image ? out_.images.size() : kind == PatternKind::Object ? out_.objects.size() : out_.volumes.size();
    const auto [known, fresh] = known_data_.emplace(description.block, size_of(first_size));
    if (!fresh) return known->second;
    const scene::StatementItem& source = statement.items.front();
    if (kind == PatternKind::Image) out_.images.push_back(compile_image(scene_, statement, description.name == "image_map"));
    else if (kind == PatternKind::Object) out_.objects.push_back(std::make_shared<ProbedObject>(*std::get<std::shared_ptr<const scene::Object>>(source.operands[0]), scene_.global));
    else out_.volumes.push_back(std::get<std::shared_ptr<const scene::Volume>>(source.operands.back()));
    return known->second;
}

}  // namespace plan
