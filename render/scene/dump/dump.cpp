#include "render/scene/description.h"
#include "render/scene/base/dump_writer.h"
#include "render/scene/solids.h"

#include <fmt/format.h>

namespace scene {
namespace {

struct ShapeDump {
    DumpWriter& out;

    void operator()(const Sphere& s) const { out.line("sphere", text(s.center) + " " + text(s.radius)); }
    void operator()(const Box& b) const { out.line("box", text(b.lower) + " " + text(b.upper)); }
    void operator()(const Plane& p) const { out.line("plane", text(p.normal) + " " + text(p.offset)); }
    void operator()(const Cylinder& c) const
    {
        out.line("cylinder",
                 fmt::format("{} {} {}{}", text(c.base), text(c.cap), text(c.radius), c.open ? " open" : ""));
    }
    void operator()(const Cone& c) const
    {
        out.line("cone", fmt::format("{} {} {} {}{}", text(c.base), text(c.base_radius), text(c.cap),
                                     text(c.cap_radius), c.open ? " open" : ""));
    }
    void operator()(const Torus& t) const
    {
        static constexpr const char* kSpindles[] = {"", " union", " merge", " difference", " intersection"};
        out.line("torus", text(t.major) + " " + text(t.minor) + kSpindles[static_cast<std::size_t>(t.spindle)]);
    }
    void operator()(const Shared<Quadric>& q) const
    {
        out.line("quadric",
                 fmt::format("{} {} {} {}", text(q->square), text(q->mixed), text(q->linear), text(q->constant)));
    }
    void operator()(const Polynomial& p) const
    {
        out.open(fmt::format("polynomial of degree {}", p.shape->degree()));
        for (const double c : p.shape->coefficients()) out.value("coefficient", c);
        out.close();
    }
    void operator()(const Disc& d) const
    {
        out.line("disc", fmt::format("{} {} {} {}", text(d.center), text(d.normal), text(d.radius), text(d.hole)));
    }
    void operator()(const Triangle& t) const { corners("triangle", t.vertex); }
    void operator()(const Shared<SmoothTriangle>& t) const
    {
        corners("triangle", t->vertex);
        corners("normals", t->normal);
    }
    void corners(std::string_view name, const std::array<glm::dvec3, 3>& at) const
    {
        out.line(name, text(at[0]) + " " + text(at[1]) + " " + text(at[2]));
    }
    void operator()(const Mesh& mesh) const;
    void operator()(const Extrusion& e) const
    {
        out.line("extrusion", fmt::format("{} pieces, {} to {}{}", e.outline->pieces().size(), text(e.low),
                                          text(e.high), e.open ? " open" : ""));
    }
    void operator()(const Freeform&) const {}  // told as it was written
    void operator()(const Csg& csg) const;
    void operator()(const Shared<Light>& light) const;
};

void ShapeDump::operator()(const Mesh& mesh) const
{
    const MeshData& d = *mesh.data;
    out.open(fmt::format("mesh {} vertices {} normals {} uvs {} faces {} textures", d.vertices.size(), d.normals.size(),
                         d.uvs.size(), d.faces.size(), d.textures.size()));
    for (const glm::dvec3& v : d.vertices) out.value("vertex", v);
    for (const glm::dvec3& n : d.normals) out.value("normal", n);
    for (const glm::dvec2& uv : d.uvs) out.line("uv", fmt::format("<{}, {}>", text(uv.x), text(uv.y)));
    const auto indices = [](const std::array<std::uint32_t, 3>& i) {
        return i[0] == MeshData::kNone ? std::string("-") : fmt::format("{},{},{}", i[0], i[1], i[2]);
    };
    for (const MeshData::Face& f : d.faces)
        out.line("face", indices(f.vertex) + " " + indices(f.normal) + " " + indices(f.uv) + " " + indices(f.texture));
    for (const TexturePtr& t : d.textures)
        if (t) scene::dump(out, *t);
    if (d.has_inside_vector) out.value("inside_vector", d.inside_vector);
    out.close();
}

void ShapeDump::operator()(const Csg& csg) const
{
    static constexpr const char* kNames[] = {"union", "intersection", "difference", "merge"};
    out.open(csg.light_group ? "light_group" : kNames[static_cast<int>(csg.op)]);
    if (csg.light_group) out.flag("global_lights", csg.global_lights);
    out.flag("split_union", csg.split_union);
    out.flag("cutaway_textures", csg.cutaway_textures);
    if (csg.operands)
        for (const Object& operand : *csg.operands) dump(out, operand);
    out.close();
}

void ShapeDump::operator()(const Shared<Light>& light) const
{
    const Light& l = *light;
    static constexpr const char* kNames[] = {"point", "spotlight", "cylinder"};
    out.open(fmt::format("light_source {}", kNames[static_cast<int>(l.kind)]));
    out.value("location", l.location);
    out.value("color", l.color);
    out.value("point_at", l.point_at);
    out.line("cone", text(l.radius_deg) + " " + text(l.falloff_deg) + " tightness " + text(l.tightness));
    out.flag("parallel", l.parallel);
    out.flag("shadowless", l.shadowless);
    out.line("fade", text(l.fade_distance) + " power " + text(l.fade_power));
    if (l.area) {
        out.line("area_light",
                 fmt::format("{} {} {} {} adaptive {}", text(l.axis1), text(l.axis2), l.size1, l.size2, l.adaptive));
        out.line("area", fmt::format("circular {} orient {} jitter {} illumination {}", l.circular, l.orient, l.jitter,
                                     l.area_illumination));
    }
    out.flag("media_interaction", l.media_interaction);
    out.flag("media_attenuation", l.media_attenuation);
    if (l.looks_like) dump(out, *l.looks_like);
    if (l.projected_through) dump(out, *l.projected_through);
    out.close();
}

void dump(DumpWriter& out, const WrittenSolid& solid)
{
    out.open(solid.keyword);
    std::visit([&](const auto& parameters) { parameters.dump(out); }, solid.parameters);
    out.close();
}

void dump_flags(DumpWriter& out, const Flags& f)
{
    if (f.no_shadow) out.flag("no_shadow", true);
    if (f.no_image) out.flag("no_image", true);
    if (f.no_reflection) out.flag("no_reflection", true);
    if (f.no_radiosity) out.flag("no_radiosity", true);
    if (f.double_illuminate) out.flag("double_illuminate", true);
    if (f.hollow) out.flag("hollow", *f.hollow);
    if (f.uv_mapping) out.flag("uv_mapping", true);
}

}  // namespace

void dump(DumpWriter& out, const Object& object, const Texture* default_texture)
{
    const ObjectDetails& details = *object.details;
    out.open("object");
    const bool told_as_written = !object.drawn() || std::holds_alternative<Freeform>(object.shape);
    if (!told_as_written) std::visit(ShapeDump{out}, object.shape);
    else if (details.written) dump(out, *details.written);
    out.value("transform", *object.transform);
    if (object.inverse) out.flag("inverse", true);
    dump_flags(out, object.flags);
    if (object.texture) scene::dump(out, *object.texture);
    if (details.interior_texture) {
        out.open("interior_texture");
        scene::dump(out, *details.interior_texture);
        out.close();
    }
    if (default_texture && !object.texture && !is_light(object)) {
        out.open("default_texture");
        scene::dump(out, *default_texture);
        out.close();
    }
    if (details.interior) scene::dump(out, *details.interior);
    const auto group = [&](const char* title, const std::vector<Object>& members) {
        if (members.empty()) return;
        out.open(title);
        for (const Object& o : members) dump(out, o);
        out.close();
    };
    group(details.bounded_by_clip ? "clipped_by bounded_by" : "clipped_by", details.clipped_by);
    group("bounded_by", details.bounded_by);
    if (details.photons) details.photons->dump(out);
    if (details.radiosity_importance) {
        out.open("radiosity");
        out.words("importance", *details.radiosity_importance);
        out.close();
    }
    out.close();
}

namespace {

void dump(DumpWriter& out, const Camera& c)
{
    static constexpr const char* kKinds[] = {"perspective", "orthographic", "fisheye",  "ultra_wide_angle",
                                             "omnimax",     "panoramic",    "cylinder", "spherical",
                                             "mesh_camera", "user_defined"};
    out.open("camera");
    out.line("kind", kKinds[static_cast<int>(c.kind)]);
    if (c.kind == Camera::Kind::Cylinder) out.value("cylinder_type", c.cylinder_type);
    out.value("location", c.location);
    out.value("direction", c.direction);
    out.value("right", c.right);
    out.value("up", c.up);
    out.value("sky", c.sky);
    out.line("angle", text(c.angle_deg) + " " + text(c.angle2_deg));
    out.line("focus", fmt::format("aperture {} distance {} samples {}{} confidence {} variance {}", text(c.aperture),
                                  text(c.focal_distance), c.blur_samples,
                                  c.blur_fewest > 0 ? fmt::format(" at least {}", c.blur_fewest) : "",
                                  text(c.confidence), text(c.variance)));
    if (c.mesh) c.mesh->dump(out);
    if (c.functions) c.functions->dump(out);
    if (c.normal) dump(out, *c.normal);
    if (c.bokeh) {
        out.open("bokeh");
        if (c.bokeh->pigment) {
            out.word("pigment");
            dump(out, *c.bokeh->pigment);
        }
        out.close();
    }
    out.close();
}

void dump(DumpWriter& out, const GlobalSettings& g)
{
    out.open("global_settings");
    out.line("assumed_gamma", g.assumed_gamma
                                  ? fmt::format("{} {}", g.assumed_gamma->name(), text(g.assumed_gamma->exponent))
                                  : "unset 1");
    out.value("adc_bailout", g.adc_bailout);
    out.value("ambient_light", g.ambient_light);
    out.value("max_trace_level", g.max_trace_level);
    out.value("number_of_waves", g.number_of_waves);
    out.value("noise_generator", g.noise_generator);
    out.value("irid_wavelength", g.irid_wavelength);
    out.value("mm_per_unit", g.mm_per_unit);
    out.line("requested", fmt::format("radiosity {} photons {} subsurface {}", g.radiosity.has_value(),
                                      g.photons.has_value(), g.subsurface.has_value()));
    if (g.radiosity) g.radiosity->dump(out);
    if (g.photons) g.photons->dump(out);
    if (g.subsurface) g.subsurface->dump(out);
    out.close();
}

void dump(DumpWriter& out, const Fog& fog)
{
    out.open("fog");
    out.value("type", fog.type);
    out.value("distance", fog.distance);
    out.value("offset", fog.offset);
    out.value("altitude", fog.altitude);
    out.value("color", fog.color);
    dump(out, fog.turbulence);
    out.value("turb_depth", fog.turb_depth);
    out.value("up", fog.up);
    out.close();
}

}  // namespace

std::string dump(const Description& d)
{
    DumpWriter out;
    out.line("version", fmt::format("{} effective {}", d.version, d.effective_version));
    if (d.povray == PovRay::V38) out.line("drawn as", "3.8");
    dump(out, d.global);
    dump(out, d.camera);
    const bool older = d.background_before_37 && d.effective_version >= 370;
    out.line("background", text(d.background) + (!d.background_given ? " (default)" : older ? " (before 3.7)" : ""));
    if (d.sky_sphere) {
        out.open("sky_sphere");
        out.value("emission", d.sky_sphere->emission);
        for (const Pigment& layer : d.sky_sphere->layers) dump(out, layer);
        out.close();
    }
    for (const Fog& fog : d.fogs) dump(out, fog);
    for (const Media& media : d.media) media.dump(out);
    for (const Rainbow& rainbow : d.rainbows) rainbow.dump(out);
    for (const Object& object : d.objects) dump(out, object, d.default_of(object).get());
    for (const Object& object : d.unsupported_objects) {
        out.open("not drawn yet");
        dump(out, object, d.default_of(object).get());
        out.close();
    }
    for (const Unsupported& u : d.unsupported)
        out.line("unsupported",
                 fmt::format("{} at {}:{}", u.what, d.line_of(u.source).line, d.line_of(u.source).column));
    return out.take();
}

}  // namespace scene
