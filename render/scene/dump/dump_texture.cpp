#include "render/scene/description.h"
#include "render/scene/base/dump_writer.h"
#include "render/scene/textures/color_functions.h"
#include "render/scene/textures/image_map.h"

#include <fmt/format.h>

namespace scene {
namespace {

const char* name_of(WaveForm wave)
{
    switch (wave) {
    case WaveForm::Ramp: return "ramp_wave";
    case WaveForm::Sine: return "sine_wave";
    case WaveForm::Triangle: return "triangle_wave";
    case WaveForm::Scallop: return "scallop_wave";
    case WaveForm::Cubic: return "cubic_wave";
    case WaveForm::Poly: return "poly_wave";
    case WaveForm::Raw: return "none";
    }
    return "";
}

const char* name_of(MappingWarp::Kind kind)
{
    switch (kind) {
    case MappingWarp::Kind::Planar: return "planar";
    case MappingWarp::Kind::Cylindrical: return "cylindrical";
    case MappingWarp::Kind::Spherical: return "spherical";
    case MappingWarp::Kind::Toroidal: return "toroidal";
    case MappingWarp::Kind::Cubic: return "cubic";
    }
    return "";
}

struct WarpDump {
    DumpWriter& out;
    void operator()(const csg::Transform& t) const { out.value("transform", t); }
    void operator()(const Turbulence& t) const
    {
        out.open("warp turbulence");
        dump(out, t);
        out.close();
    }
    void operator()(const RepeatWarp& w) const
    {
        out.line("warp", fmt::format("repeat {} offset {} flip {}", text(w.width), text(w.offset), text(w.flip)));
    }
    void operator()(const BlackHoleWarp& w) const
    {
        out.line("warp", fmt::format("black_hole {} {} strength {} falloff {} inverse {} repeat {} turbulence {}",
                                     text(w.center), text(w.radius), text(w.strength), text(w.falloff), w.inverse,
                                     text(w.repeat), text(w.turbulence)));
    }
    void operator()(const MappingWarp& w) const
    {
        out.line("warp", fmt::format("{} orientation {} distance {} dist_exp {} major_radius {}", name_of(w.kind),
                                     text(w.orientation), text(w.distance), text(w.dist_exp), text(w.major_radius)));
    }
};

struct DataDump {
    DumpWriter& out;
    const std::string& name;
    void operator()(std::monostate) const {}
    template <class Data>
    void operator()(const std::shared_ptr<const Data>& data) const
    {
        out.open(name);
        data->dump(out);
        out.close();
    }
    void operator()(const std::shared_ptr<const Object>& object) const
    {
        out.open(name);
        out.word("-");
        dump(out, *object);
        out.close();
    }
};

void dump(DumpWriter& out, const Pattern& p)
{
    out.open("pattern " + p.name);
    out.value("vector", p.vector);
    for (const double n : p.numbers) out.value("number", n);
    if (p.function) out.steps(p.function);
    if (p.pigment) dump(out, *p.pigment);
    std::visit(DataDump{out, p.name}, p.data);
    if (p.noise_generator != 0) out.value("noise_generator", p.noise_generator);
    out.value("frequency", p.frequency);
    out.value("phase", p.phase);
    out.line("wave", p.wave == WaveForm::Poly ? "poly_wave " + text(p.poly_exponent) : name_of(p.wave));
    for (auto step = p.warps.rbegin(); step != p.warps.rend(); ++step) std::visit(WarpDump{out}, *step);
    if (p.turbulence) {
        out.open("turbulence");
        dump(out, *p.turbulence);
        out.close();
    }
    out.close();
}

void dump(DumpWriter& out, const Finish& f)
{
    out.open("finish");
    out.value("ambient", f.ambient);
    out.value("emission", f.emission);
    out.line("diffuse", text(f.diffuse) + ", " + text(f.diffuse_back) + (f.diffuse_albedo ? " albedo" : ""));
    out.line("brilliance", text(f.brilliance));
    out.line("crand", text(f.crand));
    out.line("phong", text(f.phong) + " size " + text(f.phong_size) + (f.phong_albedo ? " albedo" : ""));
    out.line("specular", text(f.specular) + " roughness " + text(f.roughness) + (f.specular_albedo ? " albedo" : ""));
    out.line("metallic", text(f.metallic));
    out.value("reflection_min", f.reflection.min);
    out.value("reflection_max", f.reflection.max);
    out.flag("reflection_fresnel", f.reflection.fresnel);
    out.line("reflection_falloff", text(f.reflection.falloff));
    out.line("reflection_exponent", text(f.reflection.exponent));
    out.line("reflection_metallic", text(f.reflection.metallic));
    if (f.reflection.schlick) out.flag("whittle_schlick", true);
    if (f.reflection.gloss > 0)
        out.line("whittle_gloss", text(f.reflection.gloss) + ", " + std::to_string(f.reflection.gloss_samples));
    if (f.polished > 0) out.line("whittle_polished", text(f.polished));
    if (f.cool_warm) out.value("whittle_cool", f.cool), out.value("whittle_warm", f.warm);
    if (f.ink > 0) out.line("whittle_ink", text(f.ink) + ", " + text(f.ink_crease_deg));
    out.flag("conserve_energy", f.conserve_energy);
    if (f.fresnel != 0) out.line("fresnel", text(f.fresnel));
    if (f.use_alpha) out.word("use_alpha");
    out.line("irid", text(f.irid) + " thickness " + text(f.irid_thickness) + " turbulence " + text(f.irid_turbulence));
    if (f.legacy_ior >= 0) out.line("ior", text(f.legacy_ior));
    if (f.legacy_caustics >= 0) out.line("caustics", text(f.legacy_caustics));
    out.line("refraction", text(f.legacy_refraction));
    if (f.subsurface) f.subsurface->dump(out);
    out.close();
}

}  // namespace

void dump(DumpWriter& out, const Normal& normal)
{
    out.open("normal");
    dump(out, normal.pattern);
    out.value("amount", normal.amount);
    out.value("accuracy", normal.accuracy);
    out.flag("no_bump_scale", normal.no_bump_scale);
    if (const auto* map = std::get_if<std::vector<MapEntry<NormalPtr>>>(&normal.map)) {
        for (const auto& entry : *map) {
            out.open("entry " + text(entry.key));
            if (entry.value) dump(out, *entry.value);
            out.close();
        }
    } else if (const auto* slopes = std::get_if<std::vector<MapEntry<glm::dvec2>>>(&normal.map)) {
        for (const auto& entry : *slopes)
            out.line("slope", text(entry.key) + " <" + text(entry.value.x) + ", " + text(entry.value.y) + ">");
    }
    out.close();
}

void dump(DumpWriter& out, const Turbulence& t)
{
    out.value("amount", t.amount);
    out.value("octaves", t.octaves);
    out.value("lambda", t.lambda);
    out.value("omega", t.omega);
}

namespace {

void dump(DumpWriter& out, const Blending& blending)
{
    if (blending == Blending()) return;
    out.value("blend_mode", static_cast<double>(blending.mode));
    out.value("blend_gamma", static_cast<double>(blending.gamma));
}

}  // namespace

void dump(DumpWriter& out, const Pigment& pigment)
{
    out.open("pigment");
    if (pigment.quick_color) out.value("quick_color", *pigment.quick_color);
    if (const auto* color = std::get_if<Color>(&pigment.kind)) {
        out.value("color", *color);
    } else {
        const PatternedPigment& patterned = *std::get<Shared<PatternedPigment>>(pigment.kind);
        dump(out, patterned.pattern);
        std::visit([&](const auto& map) { dump(out, map.blending); }, patterned.map);
        if (const auto* colors = std::get_if<ColorMap>(&patterned.map)) {
            for (const auto& entry : *colors) out.line("entry", text(entry.key) + " " + text(entry.value));
        } else {
            for (const auto& entry : std::get<PigmentMap>(patterned.map)) {
                out.open("entry " + text(entry.key));
                if (entry.value) dump(out, *entry.value);
                out.close();
            }
        }
    }
    out.close();
}

void dump(DumpWriter& out, const Texture& texture)
{
    out.open("texture");
    if (const auto* shared = std::get_if<Shared<PatternedTexture>>(&texture.kind)) {
        const PatternedTexture& patterned = **shared;
        dump(out, patterned.pattern);
        for (const auto& entry : patterned.map) {
            out.open("entry " + text(entry.key));
            if (entry.value) dump(out, *entry.value);
            out.close();
        }
    } else {
        for (const Layer& layer : std::get<std::vector<Layer>>(texture.kind)) {
            out.open("layer");
            dump(out, layer.pigment);
            if (layer.normal) dump(out, *layer.normal);
            dump(out, *layer.finish);
            out.close();
        }
    }
    out.close();
}

void dump(DumpWriter& out, const Interior& i)
{
    out.open("interior");
    out.line("ior", text(i.ior));
    out.line("dispersion", text(i.dispersion) + " samples " + text(static_cast<double>(i.dispersion_samples)));
    out.line("caustics", text(i.caustics));
    out.line("fade", text(i.fade_distance) + " power " + text(i.fade_power));
    out.value("fade_color", i.fade_color);
    out.flag("hollow", i.hollow);
    out.line("refraction", text(i.refraction));
    for (const auto& medium : i.media) medium->dump(out);
    out.close();
}

}  // namespace scene
