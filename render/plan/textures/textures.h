#pragma once

#include "render/plan/quality.h"
#include "render/scene/description.h"
#include "render/texture/sky.h"
#include "render/texture/texture_set.h"

#include <compare>
#include <map>
#include <string>
#include <unordered_map>

namespace plan {

/// The curve that the scene's colours are levels of: of light where it gives none.
image::TransferCurve working_curve(const scene::Description& scene);

/// A texture of the text and where it stands. Few textures differ from each other by more than that, and a copy of the
/// text for each takes more room than what is made of it.
struct PlacedTexture {
    scene::TexturePtr texture;
    const csg::Transform* by = nullptr;  ///< moves it there; null: as written. Of equal ones one is named
    explicit operator bool() const { return texture != nullptr; }
    friend auto operator<=>(const PlacedTexture&, const PlacedTexture&) = default;
};

/// Turns descriptions of textures into the flat set, each shared description once.
class TextureCompiler {
public:
    /// quality: of it patterns and normals count. `notes` receives what is not rendered yet.
    TextureCompiler(const scene::Description& scene, const Quality& quality, texture::TextureSet& out,
                    std::vector<scene::Unsupported>& notes);

    /// Index into TextureSet::textures, or texture::kNone for a null pointer.
    std::uint32_t texture(const PlacedTexture& placed);
    /// Index into TextureSet::pigments. by: see PlacedTexture, also below.
    std::uint32_t pigment(const scene::Pigment& description, const csg::Transform* by = nullptr);
    /// First of the map's entries in TextureSet::keys and colors.
    std::uint32_t color_map(const scene::ColorMap& description);
    /// Index into TextureSet::normals; texture::kNone if it cannot be evaluated (noted).
    std::uint32_t normal(const scene::Normal& description, bool no_bump_scale, const csg::Transform* by = nullptr);
    /// Index into TextureSet::functions; texture::kNone if it needs a pattern that cannot be evaluated (noted).
    std::uint32_t function(const function::FunctionPtr& description);

private:
    struct MapEntry {
        float key = 0;
        scene::Color color;
        std::uint32_t child = texture::kNone;
        glm::dvec2 slope{0};
    };
    static std::vector<MapEntry> entries_of(const scene::ColorMap& map);
    template <class Part, class Compile>
    static std::vector<MapEntry> entries_of(const std::vector<scene::MapEntry<Part>>& map, Compile&& compile);
    /// First of the entries in the set, where equal maps share theirs.
    std::uint32_t keep_map(const std::vector<MapEntry>& entries);
    struct MapRange {
        std::uint32_t first = 0, count = 0;
    };
    /// Of the entries that make() makes of what the description has. All places of a texture share it, see
    /// PlacedTexture.
    template <class Make>
    MapRange map_of(const void* description, const csg::Transform* by, Make&& make);
    /// A pigment or a normal inside of another: all that use a declared one share it, wherever they stand, for what is
    /// moved is the outer one's pattern.
    std::uint32_t part(const scene::PigmentPtr& description);
    std::uint32_t part(const scene::NormalPtr& description, bool no_bump_scale);
    std::uint32_t layers(const std::vector<scene::Layer>& description, const csg::Transform* by);
    std::uint32_t patterned(const scene::PatternedTexture& description, const csg::Transform* by);
    /// A texture of the set, whole in it, at another place.
    std::uint32_t again(std::uint32_t known, const scene::Texture& description, const csg::Transform& by);
    std::uint32_t pattern_again(std::uint32_t known, const scene::Pattern& description, const csg::Transform& by);
    std::uint32_t color_functions(const scene::ColorFunctions& description);
    std::uint32_t pigment_map(const scene::PatternedPigment& description, const csg::Transform* by);
    void extend(const scene::Finish& from, texture::Finish& to);
    std::uint32_t finish(const scene::Shared<scene::Finish>& description);
    std::uint32_t pattern(const scene::Pattern& description, const csg::Transform* by = nullptr);
    /// Index of what the pattern looks its value up in; texture::kNone for those that look nothing up.
    std::uint32_t pattern_data(const scene::Pattern& description, texture::PatternKind kind);
    /// While it is there, patterns are one level deeper. Throws scene::Error about a nest that is too deep.
    class Level {
    public:
        Level(TextureCompiler& of, const scene::Pattern& pattern);
        ~Level() { --depth_; }

    private:
        int& depth_;
    };
    texture::Potential potential(const scene::Object& object);
    void note(const std::string& what, const scene::SourceRef& source);
    /// Puts it into the set, after those inside of it.
    std::uint32_t add(const texture::Pigment& pigment);
    bool opaque(const texture::Pigment& pigment) const;
    /// By POV-Ray's judgement (shadow_opacity.cpp), which changes from one question to the next.
    bool lets_light_through(const scene::Pigment& pigment);
    bool entry_lets_light_through(const scene::Pigment& entry);
    /// Of an image_map, else nothing.
    const texture::Image* picture_of(const scene::PatternedPigment& pigment);

    const scene::Description& scene_;
    Quality quality_;
    bool ambient_;  ///< finishes have theirs: radiosity takes its place since 3.7 (spec 6, 4.2)
    texture::TextureSet& out_;
    std::vector<scene::Unsupported>& notes_;
    const int deepest_;  ///< patterns that may lie inside of each other
    int depth_ = 0;      ///< see Level
    struct HashOfPlaced {
        std::size_t operator()(const PlacedTexture& t) const
        {
            return std::hash<scene::TexturePtr>()(t.texture) ^ 0x9e3779b97f4a7c15u * std::hash<const void*>()(t.by);
        }
    };
    std::unordered_map<PlacedTexture, std::uint32_t, HashOfPlaced> known_;
    std::unordered_map<const scene::Texture*, std::uint32_t> first_placed_;     ///< of textures in known_ that moved
    std::unordered_map<scene::PigmentPtr, std::uint32_t> known_pigments_;       ///< inside of others
    std::map<std::pair<scene::NormalPtr, bool>, std::uint32_t> known_normals_;  ///< the same
    std::unordered_map<const scene::Finish*, std::uint32_t> known_finishes_;    ///< of textures in known_
    std::unordered_multimap<std::size_t, MapRange> known_maps_;                 ///< to first, count
    std::unordered_map<const void*, MapRange> placed_maps_;  ///< by description, of textures in known_
    std::unordered_map<function::FunctionPtr, std::uint32_t> known_functions_;
    std::unordered_map<std::shared_ptr<const void>, std::uint32_t> known_data_;
    std::vector<bool> opaque_pigments_;                       ///< by index
    std::unordered_map<const scene::Pigment*, bool> judged_;  ///< entries of maps: whether they let light through
};

/// alpha_output: the picture is written with an alpha channel (+UA).
texture::Sky compile_sky(const scene::Description& scene, TextureCompiler& textures, bool alpha_output);
std::vector<texture::Fog> compile_fogs(const scene::Description& scene);
/// Those that can be seen.
std::vector<texture::Rainbow> compile_rainbows(const scene::Description& scene, TextureCompiler& textures);

}  // namespace plan
