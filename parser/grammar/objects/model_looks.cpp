#include "parser/grammar/objects/model_looks.h"

#include "parser/stream/files/file_bytes.h"
#include "render/image/codecs/read/direct_readers.h"
#include "render/image/levels/transfer_curve.h"
#include "render/model/mtl_reader.h"
#include "render/scene/textures/image_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace parser {
namespace {

using image::TransferCurve;

/// From the file's colours to the scene's.
class Working {
public:
    Working(MeshState& s, bool linear)
    {
        const scene::AssumedGamma& assumed = s.stream().language().assumed_gamma;
        curve_ = {assumed ? assumed->curve() : TransferCurve::linear(),
                  linear ? TransferCurve::linear() : TransferCurve::srgb()};
    }
    glm::vec3 operator()(const glm::vec3& color) const
    {
        return {curve_.to_working(color.x), curve_.to_working(color.y), curve_.to_working(color.z)};
    }

private:
    image::Transcoder curve_;
};

std::uint32_t add_look(MeshState& s, scene::Pigment pigment, const glm::vec3& emission)
{
    const auto texture = std::make_shared<scene::Texture>(*s.build.default_texture());
    scene::Layer& top = std::get<std::vector<scene::Layer>>(texture->kind).back();
    pigment.source = texture->source;
    top.pigment = std::move(pigment);
    if (emission != glm::vec3(0)) top.finish.edit().emission = emission;
    s.looks.push_back(s.add_texture(texture));
    return s.looks.back();
}

/// pigment { uv_mapping image_map { ... } }
scene::Pigment picture_pigment(std::shared_ptr<const image::Picture> picture, const std::string& path,
                               const scene::GammaCurve& gamma, const scene::SourceRef& at)
{
    auto map = std::make_shared<scene::ImageMap>();
    map->source.kind = "file";
    map->source.path = path;
    map->source.picture = std::move(picture);
    map->source.gamma = gamma;
    map->interpolation = scene::ImageMap::Interpolation::Bilinear;
    map->at = at;
    scene::PatternedPigment shown;
    shown.pattern.name = "image_map";
    shown.pattern.source = at;
    shown.pattern.data = std::move(map);
    const auto on_surface = std::make_shared<scene::Pigment>();
    on_surface->kind = std::move(shown);
    scene::PatternedPigment mapped;
    mapped.pattern.name = "uv_mapping";
    mapped.pattern.source = at;
    mapped.map = scene::PigmentMap{{0.0, on_surface}};
    scene::Pigment pigment;
    pigment.kind = std::move(mapped);
    return pigment;
}

/// A file that the mesh's file names, which stands beside that; empty: it is not there, or may not be read.
std::string companion(MeshState& s, const std::string& path, const std::string& name)
{
    std::string unix = name;
    std::replace(unix.begin(), unix.end(), '\\', '/');
    const std::size_t slash = path.find_last_of('/');
    const std::string folder = slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
    std::string found = s.stream().find_file(folder + unix, {});
    if (!found.empty()) s.stream().read_files().data(found);
    return found;
}

void read_libraries(MeshState& s, const scene::SourceRef& at, const std::string& path, model::Model& model)
{
    for (const std::string& name : model.libraries) {
        const std::string found = companion(s, path, name);
        if (found.empty()) {
            s.stream().warn(at, fmt::format("cannot find '{}', which tells what '{}' looks like", name, path));
            continue;
        }
        try {
            model::dress(model, bytes_of_file(s.stream(), at, found));
        } catch (const model::ModelError& error) {
            s.stream().fail(at, fmt::format("{}:{}: {}", found, error.line, error.what()));
        }
    }
}

/// Colours of corners, each a number.
std::vector<std::uint32_t> numbered(const std::vector<glm::vec3>& colors, std::vector<glm::vec3>& different)
{
    constexpr float kLevels = 65535.0f;
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    std::vector<std::uint32_t> number;
    number.reserve(colors.size());
    for (const glm::vec3& color : colors) {
        std::uint64_t key = 0;
        for (int k = 0; k < 3; ++k)
            key = key << 16 | static_cast<std::uint64_t>(std::clamp(color[k], 0.0f, 1.0f) * kLevels + 0.5f);
        const auto [at, fresh] = known.try_emplace(key, static_cast<std::uint32_t>(different.size()));
        if (fresh) different.push_back(glm::clamp(color, 0.0f, 1.0f));
        number.push_back(at->second);
    }
    return number;
}

/// A picture with a block of 2 by 2 pixels for each face: the corners' colours in three of them, and in the fourth what
/// makes the interpolated colour a linear function of the place within the face.
class ColorSheet {
public:
    using Corners = std::array<std::uint32_t, 3>;
    /// \param colors of the scene's, which interpolated are what a blend of textures is
    explicit ColorSheet(const std::vector<glm::vec3>& colors) : colors_(colors) {}

    std::uint32_t block(const Corners& corners)
    {
        const auto [at, fresh] = known_.try_emplace(corners, static_cast<std::uint32_t>(blocks_.size()));
        if (fresh) blocks_.push_back(corners);
        return at->second;
    }
    std::size_t blocks() const { return blocks_.size(); }
    const Corners& corners(std::size_t block) const { return blocks_[block]; }
    void settle()
    {
        across_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(blocks_.size()))));
        down_ = (blocks_.size() + across_ - 1) / across_;
    }
    /// Of a corner's pixel: its middle.
    glm::dvec2 uv(std::size_t block, std::size_t corner) const
    {
        const double x = 2.0 * static_cast<double>(block % across_) + (corner == 1 ? 1.5 : 0.5),
                     y = 2.0 * static_cast<double>(block / across_) + (corner == 2 ? 1.5 : 0.5);
        return {x / (2.0 * static_cast<double>(across_)), 1.0 - y / (2.0 * static_cast<double>(down_))};
    }
    std::shared_ptr<const image::Picture> picture() const
    {
        auto out = std::make_shared<image::Picture>();
        out->width = static_cast<int>(2 * across_);
        out->height = static_cast<int>(2 * down_);
        out->channels = 3;
        out->bits = 32;
        image::Samples::Floats samples(3 * out->count());
        for (std::size_t i = 0; i < blocks_.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const glm::vec3 color = k < 3 ? colors_[blocks_[i][k]] : fourth(blocks_[i]);
                const std::size_t column = 2 * (i % across_) + k % 2, row = 2 * (i / across_) + k / 2;
                for (glm::length_t c = 0; c < 3; ++c)
                    samples[3 * (row * 2 * across_ + column) + static_cast<std::size_t>(c)] = color[c];
            }
        out->samples = {std::move(samples)};
        return out;
    }

private:
    struct Hash {
        std::size_t operator()(const Corners& c) const
        {
            constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
            return static_cast<std::size_t>(((c[0] * kOdd + c[1]) * kOdd + c[2]) * kOdd >> 16);
        }
    };
    /// May be below 0 or above 1.
    glm::vec3 fourth(const Corners& corners) const
    {
        return colors_[corners[1]] + colors_[corners[2]] - colors_[corners[0]];
    }

    const std::vector<glm::vec3>& colors_;
    std::unordered_map<Corners, std::uint32_t, Hash> known_;
    std::vector<Corners> blocks_;
    std::size_t across_ = 1, down_ = 1;
};

scene::Color color_of(const Working& working, const glm::vec3& color, float opacity)
{
    scene::Color out = scene::Color::of(working(color));
    out.transmit = 1.0f - opacity;
    return out;
}

/// Without alpha.
void make_opaque(image::Picture& picture)
{
    for (std::size_t i = 3; i < picture.palette.size(); i += 4) picture.palette[i] = 1.0f;
    if (picture.channels % 2 != 0 || picture.channels == 0) return;
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::visit(
        [&](auto& samples) {
            std::size_t to = 0;
            for (std::size_t i = 0; i < samples.size(); ++i)
                if (i % channels != channels - 1) samples[to++] = samples[i];
            samples.resize(to);
        },
        picture.samples.kept);
    --picture.channels;
}

/// A picture that stands in the mesh's file.
std::shared_ptr<const image::Picture> inner_picture(MeshState& s, const scene::SourceRef& at, const std::string& path,
                                                    const std::string& bytes, bool opaque)
{
    try {
        auto picture = image::decode_directly(path, {bytes.begin(), bytes.end()});
        if (!picture) s.stream().fail(at, fmt::format("'{}': a picture in it is neither PNG nor JPEG", path));
        if (opaque) make_opaque(*picture);
        return std::make_shared<const image::Picture>(std::move(*picture));
    } catch (const image::FileError& error) {
        s.stream().fail(at, fmt::format("'{}': a picture in it cannot be read: {}", path, error.what()));
    }
}

/// The picture of a material; null: it has none, or none that can be had.
std::shared_ptr<const image::Picture> picture_of(MeshState& s, const scene::SourceRef& at, const std::string& path,
                                                 const model::Model& model, const model::Model::Material& material,
                                                 std::string& name)
{
    if (material.picture != model::kNone) {
        name = path;
        return inner_picture(s, at, path, model.pictures[material.picture], material.opaque);
    }
    if (material.picture_path.empty()) return nullptr;
    name = companion(s, path, material.picture_path);
    if (!name.empty()) return s.build.picture(name, at);
    s.stream().warn(
        at, fmt::format("cannot find the picture '{}' of the material '{}'", material.picture_path, material.name));
    return nullptr;
}

}  // namespace

std::vector<std::uint32_t> textures_told(MeshState& s, const scene::SourceRef& at, const std::string& path,
                                         model::Model& model)
{
    read_libraries(s, at, path, model);
    const Working working(s, model.linear);
    std::vector<std::uint32_t> all;
    for (const model::Model::Material& material : model.materials) {
        all.push_back(scene::MeshData::kNone);
        if (!material.told) continue;
        scene::Pigment pigment;
        std::string name;
        if (const auto picture = picture_of(s, at, path, model, material, name))
            pigment = picture_pigment(picture, name, {scene::GammaCurve::Kind::Srgb}, at);
        else pigment.kind = color_of(working, material.color, material.opacity);
        all.back() = add_look(s, std::move(pigment), working(material.emission));
    }
    return all;
}

void paint_corners(MeshState& s, const scene::SourceRef& at, const std::string& path, const model::Model& model,
                   std::size_t first)
{
    if (model.colors.empty()) return;
    std::vector<glm::vec3> colors;
    const std::vector<std::uint32_t> number = numbered(model.colors, colors);
    const auto corners_of = [&](const model::Model::Face& face) {
        return ColorSheet::Corners{number[face.color[0]], number[face.color[1]], number[face.color[2]]};
    };
    const Working working(s, model.linear);
    for (glm::vec3& color : colors) color = working(color);
    ColorSheet sheet(colors);
    std::vector<std::uint32_t> block(model.faces.size(), model::kNone);
    bool plain = true;
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        if (model.faces[i].color[0] == model::kNone) continue;
        const ColorSheet::Corners corners = corners_of(model.faces[i]);
        plain = plain && corners[0] == corners[1] && corners[0] == corners[2];
        block[i] = sheet.block(corners);
    }
    if (sheet.blocks() == 0) return;
    scene::MeshData& mesh = *s.data;
    constexpr std::size_t kMostTextures = 256;  // of one colour each; a picture serves more
    if (plain && sheet.blocks() <= kMostTextures) {
        std::vector<std::uint32_t> texture;
        for (std::size_t i = 0; i < sheet.blocks(); ++i) {
            scene::Pigment pigment;
            pigment.kind = scene::Color::of(colors[sheet.corners(i)[0]]);
            texture.push_back(add_look(s, std::move(pigment), glm::vec3(0)));
        }
        for (std::size_t i = 0; i < block.size(); ++i)
            if (block[i] != model::kNone) mesh.faces[first + i].texture.fill(texture[block[i]]);
        return;
    }
    sheet.settle();
    const scene::GammaCurve gamma = s.stream().language().assumed_gamma.value_or(scene::GammaCurve{});
    const std::uint32_t texture = add_look(s, picture_pigment(sheet.picture(), path, gamma, at), glm::vec3(0));
    const auto uvs = static_cast<std::uint32_t>(mesh.uvs.size());
    for (std::size_t i = 0; i < sheet.blocks(); ++i)
        for (std::size_t k = 0; k < 3; ++k) mesh.uvs.push_back(sheet.uv(i, k));
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (block[i] == model::kNone) continue;
        scene::MeshData::Face& face = mesh.faces[first + i];
        face.texture.fill(texture);
        face.uv = {uvs + 3 * block[i], uvs + 3 * block[i] + 1, uvs + 3 * block[i] + 2};
    }
}

void settle_look(MeshState& s, scene::Object& object)
{
    scene::MeshData& mesh = *s.data;
    const std::uint32_t first = mesh.faces.front().texture[0];
    if (std::find(s.looks.begin(), s.looks.end(), first) == s.looks.end()) return;
    for (const scene::MeshData::Face& face : mesh.faces)
        for (const std::uint32_t texture : face.texture)
            if (texture != first) return;
    object.texture = mesh.textures[first];
    for (scene::MeshData::Face& face : mesh.faces) face.texture = kNoIndices;
    mesh.textures.clear();
}

}  // namespace parser
