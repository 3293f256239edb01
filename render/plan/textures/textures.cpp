#include "render/plan/textures/textures.h"

#include "numbers/single_precision.h"
#include "function/build/link.h"
#include "render/plan/rendering_stack.h"
#include "render/plan/textures/pattern_kinds.h"
#include "render/scene/function.h"
#include "render/scene/textures/color_functions.h"
#include "render/scene/unsupported_features.h"
#include "render/texture/noise/noise.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace plan {
namespace {

constexpr int kLegacyVersion = 370;  // formulas of before hold below it

std::uint32_t count_of(std::size_t n) { return static_cast<std::uint32_t>(n); }

template <class T>
std::string_view bytes_of(const std::vector<T>& all, std::size_t first, std::size_t count)
{
    return {reinterpret_cast<const char*>(all.data() + first), count * sizeof(T)};
}

/// 3000 patterns inside of each other, or what the stacks of threads that render them hold.
int deepest_nest()
{
    constexpr std::size_t kLevel = 40 << 10;  // bytes of stack: 25 KB measured at most
    constexpr std::size_t kMost = 3000;       // the first thread's 120 MB
    return static_cast<int>(std::min(kMost, rendering_stack() / kLevel));
}

}  // namespace

TextureCompiler::TextureCompiler(const scene::Description& scene, const Quality& quality, texture::TextureSet& out,
                                 std::vector<scene::Unsupported>& notes)
    : scene_(scene), quality_(quality),
      ambient_(scene.effective_version < kLegacyVersion || !has_radiosity(scene.global, quality)), out_(out),
      notes_(notes), deepest_(deepest_nest())
{
    const scene::GlobalSettings& global = scene.global;
    out_.noise_generator = global.noise_generator;
    out_.irid_wavelength = global.irid_wavelength;
    out_.working = working_curve(scene);
    out_.legacy_opacity = scene.effective_version < kLegacyVersion;
    const auto waves = static_cast<std::size_t>(std::max(1, global.number_of_waves));
    out_.wave_sources.resize(waves);
    out_.wave_frequencies.resize(waves);
    texture::wave_sources(static_cast<int>(waves), out_.wave_sources.data(), out_.wave_frequencies.data());
}

TextureCompiler::Level::Level(TextureCompiler& of, const scene::Pattern& pattern) : depth_(of.depth_)
{
    if (depth_ >= of.deepest_)
        throw scene::Error(of.scene_.place(pattern.source),
                           "patterns lie inside of each other more than " + std::to_string(of.deepest_) + " deep");
    ++depth_;
}

void TextureCompiler::note(const std::string& what, const scene::SourceRef& source)
{
    notes_.push_back({what, source});
}

std::uint32_t TextureCompiler::keep_map(const std::vector<MapEntry>& entries)
{
    const std::size_t first = out_.keys.size(), count = entries.size();
    for (const MapEntry& entry : entries) {
        out_.keys.push_back(entry.key);
        out_.colors.push_back(entry.color);
        out_.children.push_back(entry.child);
        out_.slopes.push_back(entry.slope);
    }
    const auto bytes = [&](std::size_t from) {
        return std::array{bytes_of(out_.keys, from, count), bytes_of(out_.colors, from, count),
                          bytes_of(out_.children, from, count), bytes_of(out_.slopes, from, count)};
    };
    const auto written = bytes(first);
    std::size_t hash = 0;
    for (const std::string_view part : written) hash = 31 * hash + std::hash<std::string_view>()(part);
    const auto [begin, end] = known_maps_.equal_range(hash);
    for (auto known = begin; known != end; ++known) {
        const auto [at, length] = known->second;
        if (length != count || bytes(at) != written) continue;
        out_.keys.resize(first);
        out_.colors.resize(first);
        out_.children.resize(first);
        out_.slopes.resize(first);
        return at;
    }
    known_maps_.emplace(hash, MapRange{count_of(first), count_of(count)});
    return count_of(first);
}

template <class Make>
TextureCompiler::MapRange TextureCompiler::map_of(const void* description, const csg::Transform* by, Make&& make)
{
    if (by == nullptr) {
        const std::vector<MapEntry> entries = make();
        return {keep_map(entries), count_of(entries.size())};
    }
    if (const auto known = placed_maps_.find(description); known != placed_maps_.end()) return known->second;
    return placed_maps_.emplace(description, map_of(description, nullptr, make)).first->second;
}

std::uint32_t TextureCompiler::pattern(const scene::Pattern& description, const csg::Transform* by)
{
    const auto kind = pattern_kind(description.name);
    if (!kind) return texture::kNone;
    texture::Pattern compiled =
        compile_pattern(description, by, *kind, scene_.global.noise_generator, scene_.povray, out_.warps);
    for (std::size_t i = out_.reach.far.size(); i < out_.warps.size(); ++i) out_.reach.add(out_.warps[i]);
    if (*kind == texture::PatternKind::PigmentPattern) {
        if (!description.pigment) return texture::kNone;
        compiled.pigment = part(description.pigment);
    }
    if (*kind == texture::PatternKind::Function) {
        compiled.function = description.function ? function(description.function) : texture::kNone;
        if (compiled.function == texture::kNone) return texture::kNone;
    }
    compiled.data = pattern_data(description, *kind);
    out_.patterns.push_back(compiled);
    return count_of(out_.patterns.size() - 1);
}

std::uint32_t TextureCompiler::function(const function::FunctionPtr& description)
{
    if (const auto known = known_functions_.find(description); known != known_functions_.end()) return known->second;
    bool complete = true;
    const auto slot_of = [&](const function::SceneUse& use) {
        if (use.kind == function::SceneUse::Kind::Pigment)
            return pigment(static_cast<const scene::PigmentFunction&>(*use.external).pigment);
        const scene::Pattern& inner = static_cast<const scene::PatternFunction&>(*use.external).pattern;
        const std::uint32_t slot = pattern(inner);
        if (slot == texture::kNone) note("pattern '" + inner.name + "' in a function", inner.source);
        complete = complete && slot != texture::kNone;
        return slot;
    };
    const function::FunctionPtr linked = function::link(description, slot_of);
    std::uint32_t index = texture::kNone;
    if (complete) {
        index = count_of(out_.functions.size());
        out_.functions.push_back(linked);
    }
    known_functions_.emplace(description, index);
    return index;
}

std::uint32_t TextureCompiler::pigment(const scene::Pigment& description, const csg::Transform* by)
{
    // A quick colour with a component of exactly -1 counts as not given (spec 3, 16).
    const auto& quick = description.quick_color;
    if (quick && !quality_.patterns && quick->red != -1.0f && quick->green != -1.0f && quick->blue != -1.0f) {
        return add({texture::Pigment::Kind::Solid, *quick});
    } else if (const auto* color = std::get_if<scene::Color>(&description.kind)) {
        return add({texture::Pigment::Kind::Solid, *color});
    }
    return pigment_map(*std::get<scene::Shared<scene::PatternedPigment>>(description.kind), by);
}

std::uint32_t TextureCompiler::add(const texture::Pigment& pigment)
{
    opaque_pigments_.push_back(opaque(pigment));
    out_.pigments.push_back(pigment);
    return count_of(out_.pigments.size() - 1);
}

std::uint32_t TextureCompiler::part(const scene::PigmentPtr& description)
{
    if (const auto known = known_pigments_.find(description); known != known_pigments_.end()) return known->second;
    const std::uint32_t index = pigment(*description);
    known_pigments_.emplace(description, index);
    return index;
}

std::uint32_t TextureCompiler::part(const scene::NormalPtr& description, bool no_bump_scale)
{
    const std::pair key(description, no_bump_scale);
    if (const auto known = known_normals_.find(key); known != known_normals_.end()) return known->second;
    const std::uint32_t index = normal(*description, no_bump_scale);
    known_normals_.emplace(key, index);
    return index;
}

std::vector<TextureCompiler::MapEntry> TextureCompiler::entries_of(const scene::ColorMap& map)
{
    std::vector<MapEntry> entries;
    for (const auto& entry : map) entries.push_back({static_cast<float>(entry.key), entry.value});
    return entries;
}

template <class Part, class Compile>
std::vector<TextureCompiler::MapEntry> TextureCompiler::entries_of(const std::vector<scene::MapEntry<Part>>& map,
                                                                   Compile&& compile)
{
    std::vector<MapEntry> entries;
    for (const auto& entry : map) entries.push_back({static_cast<float>(entry.key), {}, compile(entry.value)});
    return entries;
}

std::uint32_t TextureCompiler::pigment_map(const scene::PatternedPigment& description, const csg::Transform* by)
{
    using Kind = texture::Pigment::Kind;
    const Level level(*this, description.pattern);
    texture::Pigment out;
    out.pattern = pattern(description.pattern, by);
    if (description.pattern.name == "image_map") {
        out.kind = Kind::Image;
        return add(out);
    }
    if (const auto* functions = std::get_if<std::shared_ptr<const scene::ColorFunctions>>(&description.pattern.data)) {
        out.kind = Kind::Functions;
        out.first = color_functions(**functions);
        return add(out);
    }
    const auto* colors = std::get_if<scene::ColorMap>(&description.map);
    const auto* pigments = std::get_if<scene::PigmentMap>(&description.map);
    const MapRange map = map_of(&description, by, [&] {
        return colors ? entries_of(*colors)
                      : entries_of(*pigments, [this](const scene::PigmentPtr& entry) { return part(entry); });
    });
    out.first = map.first;
    out.count = map.count;
    out.kind = colors ? Kind::ColorMap : Kind::PigmentMap;
    out.blending = colors ? colors->blending : pigments->blending;
    if (out.count == 0) {
        out = {};
    } else if (out.pattern == texture::kNone) {
        // Something must be shown: the first entry stands for the whole map, and the note says so.
        note("pattern '" + description.pattern.name + "' (its first map entry is shown)", description.pattern.source);
        if (!colors) return out_.children[out.first];
        out.kind = Kind::Solid;
        out.color = out_.colors[out.first];
    } else if (!colors) {
        const texture::PatternKind kind = out_.patterns[out.pattern].kind;
        if (kind == texture::PatternKind::Average) out.kind = Kind::Average;
        if (kind == texture::PatternKind::Uv) out.kind = Kind::Uv;
    }
    return add(out);
}

std::uint32_t TextureCompiler::color_functions(const scene::ColorFunctions& description)
{
    texture::ColorFunctions out;
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = description.parts[i] ? function(description.parts[i]) : texture::kNone;
    out_.color_functions.push_back(out);
    return count_of(out_.color_functions.size() - 1);
}

std::uint32_t TextureCompiler::color_map(const scene::ColorMap& description)
{
    return keep_map(entries_of(description));
}

std::uint32_t TextureCompiler::normal(const scene::Normal& description, bool no_bump_scale, const csg::Transform* by)
{
    using Map = texture::Normal::Map;
    const Level level(*this, description.pattern);
    texture::Normal out;
    out.no_bump_scale = description.no_bump_scale || no_bump_scale;
    out.amount = numbers::single(description.amount);
    out.accuracy = numbers::single(description.accuracy);
    out.pattern = pattern(description.pattern, by);
    if (out.pattern == texture::kNone) {
        if (!description.pattern.name.empty())
            note("normal '" + description.pattern.name + "'", description.pattern.source);
        return texture::kNone;
    }
    if (const auto* map = std::get_if<std::vector<scene::MapEntry<scene::NormalPtr>>>(&description.map)) {
        const texture::PatternKind kind = out_.patterns[out.pattern].kind;
        out.map = kind == texture::PatternKind::Average ? Map::Average
                  : kind == texture::PatternKind::Uv    ? Map::Uv
                                                        : Map::Normals;
        const MapRange range = map_of(&description, by, [&] {
            return entries_of(*map, [&](const scene::NormalPtr& entry) { return part(entry, out.no_bump_scale); });
        });
        out.first = range.first;
        out.count = range.count;
        const auto entry = out_.children.begin() + out.first;
        if (std::find(entry, entry + out.count, texture::kNone) != entry + out.count)
            return texture::kNone;  // noted where it was found
    } else if (const auto* slopes = std::get_if<std::vector<scene::MapEntry<glm::dvec2>>>(&description.map)) {
        out.map = Map::Slopes;
        std::vector<MapEntry> entries;
        for (const auto& [key, value] : *slopes)
            entries.push_back({static_cast<float>(key), {}, texture::kNone, value});
        out.count = count_of(entries.size());
        out.first = keep_map(entries);
    }
    if (description.pattern.name == "bump_map") out.map = Map::Image;
    else if (out.map != Map::None && out.count == 0) return texture::kNone;
    out_.normals.push_back(out);
    return count_of(out_.normals.size() - 1);
}

std::uint32_t TextureCompiler::layers(const std::vector<scene::Layer>& description, const csg::Transform* by)
{
    texture::Texture out;
    std::vector<texture::Layer> compiled;
    out.opaque = false;
    out.stops_light = false;
    out.lit = false;
    for (const scene::Layer& from : description) {
        texture::Layer to;
        to.pigment = pigment(from.pigment, by);
        if (from.normal && quality_.normals) to.normal = normal(*from.normal, false, by);
        to.finish = finish(from.finish);
        out.opaque = out.opaque || opaque_pigments_[to.pigment];
        const bool clear = lets_light_through(from.pigment);  // asked of each layer: it remembers what it finds
        out.stops_light = out.stops_light || out.opaque || !clear;
        out.lit = out.lit || out_.finishes[to.finish].lit();
        compiled.push_back(to);
    }
    out.first = count_of(out_.layers.size());
    out.count = count_of(compiled.size());
    out_.layers.insert(out_.layers.end(), compiled.begin(), compiled.end());
    out.plain = out.count == 1 && out.opaque && compiled[0].normal == texture::kNone &&
                !out_.finishes[compiled[0].finish].reflects();
    out_.textures.push_back(out);
    return count_of(out_.textures.size() - 1);
}

std::uint32_t TextureCompiler::patterned(const scene::PatternedTexture& description, const csg::Transform* by)
{
    using Kind = texture::Texture::Kind;
    const Level level(*this, description.pattern);
    texture::Texture out;
    out.kind = Kind::Map;
    out.opaque = out.stops_light = false;  // never classified opaque (spec 3, 13.2)
    out.no_bump_scale = description.no_bump_scale;
    out.pattern = pattern(description.pattern, by);
    out.count = count_of(description.map.size());
    if (out.count == 0) return texture::kNone;
    out.first =
        map_of(&description, by, [&] {
            return entries_of(description.map, [this](const scene::TexturePtr& entry) { return texture({entry}); });
        }).first;
    if (out.pattern == texture::kNone) {
        note("pattern '" + description.pattern.name + "' of a texture (its first entry is shown)",
             description.pattern.source);
        return out_.children[out.first];
    }
    const texture::PatternKind kind = out_.patterns[out.pattern].kind;
    if (kind == texture::PatternKind::Average) out.kind = Kind::Average;
    if (kind == texture::PatternKind::Uv) out.kind = Kind::Uv;
    if (description.pattern.name == "material_map") out.kind = Kind::Material;
    out_.textures.push_back(out);
    return count_of(out_.textures.size() - 1);
}

std::uint32_t TextureCompiler::texture(const PlacedTexture& placed)
{
    if (!placed) return texture::kNone;
    const auto [known, fresh] = known_.try_emplace(placed, texture::kNone);
    std::uint32_t& index = known->second;  // stays where it is while textures within are made known
    if (!fresh) return index;
    if (placed.by != nullptr)
        if (const auto first = first_placed_.find(placed.texture.get()); first != first_placed_.end())
            return index = again(first->second, *placed.texture, *placed.by);
    const std::size_t noted = notes_.size();
    const auto* plain = std::get_if<std::vector<scene::Layer>>(&placed.texture->kind);
    index = plain ? layers(*plain, placed.by)
                  : patterned(*std::get<scene::Shared<scene::PatternedTexture>>(placed.texture->kind), placed.by);
    const bool complete = index != texture::kNone && notes_.size() == noted;  // what is missing is told each time
    if (placed.by != nullptr && complete) first_placed_.emplace(placed.texture.get(), index);
    return index;
}

}  // namespace plan
