#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parser {
namespace {

using LightKind = scene::Light::Kind;

struct LightState : BlockState {
    LightState(SceneBuilder& b, scene::Object& o) : BlockState(b), object(o) {}
    scene::Object& object;
    scene::Light& light() { return std::get<scene::Shared<scene::Light>>(object.shape).edit(); }
    void need_cone(const char* what)
    {
        if (light().kind == LightKind::Point)
            stream().fail(stream().last(), std::string("'") + what + "' needs 'spotlight' or 'cylinder' before it");
    }
};

void set_kind(LightState& s, LightKind kind)
{
    scene::Light& l = s.light();
    l.kind = kind;
    l.shadowless = false;  // the last of spotlight, cylinder, shadowless counts (spec 3, 12.1)
    l.radius_deg = kind == LightKind::Cylinder ? 0.75 : 30;
    l.falloff_deg = kind == LightKind::Cylinder ? 1 : 45;
    l.tightness = 0;
    if (kind == LightKind::Cylinder) l.parallel = true;
}
struct spotlight : item<Kind::Spotlight> {
    static void act(LightState& s) { set_kind(s, LightKind::Spot); }
};
struct cylinder : item<Kind::Cylinder> {
    static void act(LightState& s) { set_kind(s, LightKind::Cylinder); }
};
struct shadowless : item<Kind::Shadowless> {
    static void act(LightState& s)
    {
        s.light().kind = LightKind::Point;
        s.light().shadowless = true;
    }
};
struct parallel : item<Kind::Parallel> {
    static void act(LightState& s) { s.light().parallel = true; }
};
/// docs/extensions.md: from so far that it comes from one direction everywhere.
struct directional : item<Kind::WhittleDirectional, a_vector> {
    static void act(LightState& s)
    {
        s.light().parallel = s.light().directional = true;
        s.light().point_at = s.pop_vector();
        if (s.light().point_at == glm::dvec3(0))
            s.stream().fail(s.stream().last(), "the direction of a light must not be <0, 0, 0>");
    }
};
struct point_at : item<Kind::PointAt, a_vector> {
    static void act(LightState& s)
    {
        if (!s.light().parallel) s.need_cone("point_at");
        s.light().point_at = s.pop_vector();
    }
};
struct radius : item<Kind::Radius, a_number> {
    static void act(LightState& s)
    {
        s.need_cone("radius");
        s.light().radius_deg = s.pop_float();
    }
};
struct falloff : item<Kind::Falloff, a_number> {
    static void act(LightState& s)
    {
        s.need_cone("falloff");
        s.light().falloff_deg = s.pop_float();
    }
};
struct tightness : item<Kind::Tightness, a_number> {
    static void act(LightState& s)
    {
        s.need_cone("tightness");
        s.light().tightness = s.pop_float();
    }
};
struct light_fade_distance : item<Kind::FadeDistance, a_number> {
    static void act(LightState& s) { s.light().fade_distance = s.pop_float(); }
};
struct light_fade_power : item<Kind::FadePower, a_number> {
    static void act(LightState& s) { s.light().fade_power = s.pop_float(); }
};

constexpr int kMostLamps = std::numeric_limits<int>::max();  ///< each way; the least int has no absolute value

struct second_axis : seq<opt_comma, a_vector> {};
struct area_size : seq<opt_comma, a_number> {};
struct area_light : item<Kind::AreaLight, a_vector, second_axis, must<area_size>, must<area_size>> {
    static void act(LightState& s)
    {
        scene::Light& l = s.light();
        l.area = true;
        l.size2 = std::abs(std::max(s.pop_int(), -kMostLamps));
        l.size1 = std::abs(std::max(s.pop_int(), -kMostLamps));
        l.axis2 = s.pop_vector();
        l.axis1 = s.pop_vector();
        if (l.adaptive == 0) l.adaptive = 100;
        if (l.size1 == 0 || l.size2 == 0)
            s.stream().fail(s.stream().last(), "an area light needs at least one lamp each way");
    }
};
/// What POV-Ray says at the end of the block (3.7).
void check_circular(LightState& s)
{
    scene::Light& l = s.light();
    TokenStream& in = s.stream();
    const bool enough = l.size1 > 1 && l.size2 > 1;
    if (l.circular && !enough)
        in.fail(s.object.source, "a circular area light needs more than one lamp along each axis");
    if (!l.orient) return;
    if (!l.circular) in.warn(s.object.source, "'orient' without 'circular': this area light is circular now");
    l.circular = true;
    if (l.size1 != l.size2) in.warn(s.object.source, "'orient' wants as many lamps along one axis as along the other");
    if (std::abs(glm::length(l.axis1) - glm::length(l.axis2)) > 1e-10)
        in.warn(s.object.source, "'orient' wants axes of equal length: the first one's is used");
    if (!enough) in.warn(s.object.source, "a circular area light should have more than one lamp along each axis");
}
/// An item that acts on an area light alone.
void warn_if_no_area(LightState& s, const char* item)
{
    if (!s.light().area)
        s.stream().warn(s.stream().last(),
                        std::string("'") + item + "' acts on an area_light alone, and none stands before it");
}
struct adaptive : item<Kind::Adaptive, a_number> {
    static void act(LightState& s) { s.light().adaptive = s.pop_int(); }
};
struct area_illumination : item<Kind::AreaIllumination> {
    static void act(LightState& s)
    {
        warn_if_no_area(s, "area_illumination");
        s.light().area_illumination = optional_flag(s.stream());
    }
};
struct circular : item<Kind::Circular> {
    static void act(LightState& s)
    {
        warn_if_no_area(s, "circular");
        s.light().circular = true;
    }
};
struct orient : item<Kind::Orient> {
    static void act(LightState& s)
    {
        warn_if_no_area(s, "orient");
        s.light().orient = true;
    }
};
struct jitter : item<Kind::Jitter> {
    static void act(LightState& s) { s.light().jitter = true; }
};
struct media_attenuation : item<Kind::MediaAttenuation> {
    static void act(LightState& s) { s.light().media_attenuation = optional_flag(s.stream()); }
};
struct media_interaction : item<Kind::MediaInteraction> {
    static void act(LightState& s) { s.light().media_interaction = optional_flag(s.stream()); }
};
std::shared_ptr<const scene::Object> read_inner(LightState& s, const char* what)
{
    const auto opened = s.build.open_block(what);
    auto object = read_object(s.build);
    if (!object) s.build.fail_unknown("an object");
    read_modifiers(s.build, *object);
    s.build.close_block(what, opened);
    if (!object->drawn()) {
        s.build.set_aside(std::move(*object));
        return nullptr;
    }
    return std::make_shared<scene::Object>(std::move(*object));
}
struct looks_like : item<Kind::LooksLike> {
    static void act(LightState& s)
    {
        if (s.light().looks_like) s.stream().fail(s.stream().last(), "a light_source looks like one object only");
        auto object = read_inner(s, "looks_like");
        if (!object) return;
        // The lamp's body stands at the light and does not block it.
        auto body = std::make_shared<scene::Object>(*object);
        body->transform_by(csg::Transform::translate(s.light().location));
        body->flags.no_shadow = true;
        s.light().looks_like = std::move(body);
    }
};
struct projected_through : item<Kind::ProjectedThrough> {
    static void act(LightState& s) { s.light().projected_through = read_inner(s, "projected_through"); }
};
struct light_photons : item<Kind::Photons> {
    static void act(LightState& s)
    {
        std::shared_ptr<const scene::PhotonFlags>& own = s.object.details.edit().photons;
        own = read_photon_flags(s.build, true, own.get());
    }
};
struct color_map : item<Kind::ColorMap> {
    static void act(LightState& s)
    {
        glm::vec3 sum(0);
        for (const auto& entry : read_color_map(s.build)) sum += static_cast<float>(entry.key) * entry.value.rgb();
        s.light().color = sum;
    }
};

struct LightItems {
    static bool match(SceneBuilder& build, LightState& s)
    {
        using Items = table<LightState, directional, spotlight, cylinder, shadowless, parallel, point_at, radius,
                            falloff, tightness, light_fade_distance, light_fade_power, area_light, adaptive,
                            area_illumination, circular, orient, jitter, media_attenuation, media_interaction,
                            looks_like, projected_through, light_photons, color_map>;
        if (Items::match(build, s)) return true;
        const auto t = read_transformation(build);
        if (t) s.object.transform_by(*t);
        return t.has_value();
    }
};

}  // namespace

template <>
inline constexpr auto expected<second_axis> = "the area light's second axis";
template <>
inline constexpr auto expected<area_size> = "the area light's number of lamps along each axis";
template <>
inline constexpr auto expected<must<area_size>> = "the area light's number of lamps along each axis";

scene::Object read_light(SceneBuilder& build, const scene::SourceRef& source)
{
    TokenStream& in = build.stream();
    scene::Object object;
    object.source = source;
    object.shape = scene::Light{};
    LightState s(build, object);
    read_block<LightItems>(build, s, "light_source", [&] {
        if (const auto declared = in.accept_identifier<std::shared_ptr<const scene::Object>>()) {
            if (!scene::is_light(**declared)) in.fail(in.last(), "this identifier is no light_source");
            object = **declared;
            return;
        }
        if (!at_expression(in)) build.fail_unknown("the light's location, as in <0, 10, 0>");
        s.light().location = parser::vector_expr(in);
        s.light().point_at = {0, 0, 1};
        in.accept_comma();
        s.light().color = at_color(in) ? parser::rgb_expr(in).rgb() : glm::vec3(0);
    });
    check_circular(s);
    return object;
}

}  // namespace parser
