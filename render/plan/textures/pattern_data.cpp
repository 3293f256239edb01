#include "render/plan/textures/images.h"
#include "render/plan/probe.h"
#include "render/plan/textures/fields.h"
#include "render/plan/textures/textures.h"
#include "render/scene/solids.h"

/// What patterns look their values up in: pictures, densities, objects. Each is taken once, however often it is used.
namespace plan {
namespace {

std::shared_ptr<const void> kept(std::monostate) { return nullptr; }
template <class Data>
std::shared_ptr<const void> kept(const std::shared_ptr<const Data>& data)
{
    return data;
}

/// It keeps the object alive.
std::shared_ptr<const csg::InsideIndex> inside_of(const std::shared_ptr<const ObjectProbe>& object)
{
    return {object, &object->inside_index()};
}

std::uint32_t length_of(std::size_t n) { return static_cast<std::uint32_t>(n); }

}  // namespace

texture::Potential TextureCompiler::potential(const scene::Object& object)
{
    Options options;
    options.quality = quality_;
    texture::Potential out;
    out.shape =
        csg::drawn_shape(FieldLinker(scene_, options, notes_).linked(std::get<scene::Freeform>(object.shape).shape));
    out.into.linear = object.transform->inverse_linear;
    out.into.offset = object.transform->inverse_offset;
    out.inverse = object.inverse;
    // What is inside above its threshold has the function's opposite for its field.
    const scene::WrittenSolid* written = object.details->written.get();
    const auto* isosurface = written ? std::get_if<scene::Isosurface>(&written->parameters) : nullptr;
    if (isosurface && isosurface->polarity > 0.0) out.inverse = !out.inverse;
    if (const auto* solid = std::get_if<csg::Isosurface>(&out.shape->kind)) out.threshold = solid->terms().threshold;
    else out.threshold = std::get<csg::Blob>(out.shape->kind).threshold();
    return out;
}

std::uint32_t TextureCompiler::pattern_data(const scene::Pattern& description, texture::PatternKind kind)
{
    using texture::PatternKind;
    if (kind != PatternKind::Image && kind != PatternKind::DensityFile && kind != PatternKind::Object &&
        kind != PatternKind::Potential)
        return texture::kNone;
    const auto shared = std::visit([](const auto& data) { return kept(data); }, description.data);
    const auto first_size = kind == PatternKind::Image       ? out_.images.size()
                            : kind == PatternKind::Object    ? out_.objects.size()
                            : kind == PatternKind::Potential ? out_.potentials.size()
                                                             : out_.volumes.size();
    const auto [known, fresh] = known_data_.emplace(shared, length_of(first_size));
    if (!fresh) return known->second;
    if (const auto* image = std::get_if<std::shared_ptr<const scene::ImageMap>>(&description.data))
        out_.images.push_back(compile_image(scene_, **image, description.name == "image_map"));
    else if (const auto* object = std::get_if<std::shared_ptr<const scene::Object>>(&description.data);
             kind == PatternKind::Potential)
        out_.potentials.push_back(potential(**object));
    else if (object) out_.objects.push_back(inside_of(std::make_shared<ObjectProbe>(**object, scene_.global)));
    else out_.volumes.push_back(std::get<std::shared_ptr<const scene::DensityFile>>(description.data)->volume);
    return known->second;
}

}  // namespace plan
