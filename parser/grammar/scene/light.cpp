#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace parser {
namespace {

using LightKind = scene::Light::Kind;

struct LightState : BlockState {
    LightState(SceneBuilder& b, scene::Object& o) : BlockState(b), object(o) {}
    scene::Object& object;
    scene::Light& subject() { return light(); }
    void take(const std::shared_ptr<const scene::Object>& declared)
    {
        if (!scene::is_light(*declared)) fail("this identifier is no light_source");
        object = *declared;
    }
    void move(const csg::Transform& by) { object.transform_by(by); }
    scene::Light& light() { return std::get<scene::Shared<scene::Light>>(object.shape).edit(); }
    void need_cone(std::string_view what)
    {
        if (light().kind == LightKind::Point)
            fail("'" + std::string(what) + "' needs 'spotlight' or 'cylinder' before it");
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
/// docs/extensions.md: from so far that it comes from one direction everywhere.
struct directional : item<Kind::WhittleDirectional, a_vector> {
    static void act(LightState& s)
    {
        s.light().parallel = s.light().directional = true;
        s.light().point_at = s.pop_vector();
        if (s.light().point_at == glm::dvec3(0)) s.fail("the direction of a light must not be <0, 0, 0>");
    }
};
struct point_at : item<Kind::PointAt, a_vector> {
    static void act(LightState& s)
    {
        if (!s.light().parallel) s.need_cone("point_at");
        s.light().point_at = s.pop_vector();
    }
};
template <Kind kind, double scene::Light::*angle>
struct of_cone : item<kind, a_number> {
    static void act(LightState& s)
    {
        s.need_cone(spelling(kind));
        s.light().*angle = s.pop_float();
    }
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
        if (l.size1 == 0 || l.size2 == 0) s.fail("an area light needs at least one lamp each way");
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
    if (!s.light().area) s.warn(std::string("'") + item + "' acts on an area_light alone, and none stands before it");
}
struct area_illumination : item<Kind::AreaIllumination, by_action<a_flag>> {
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
/// An object within the light's statement. place: where it is moved before its modifiers are read.
std::shared_ptr<scene::Object> read_inner(LightState& s, const char* what, std::optional<glm::dvec3> place = {})
{
    const auto opened = s.build.open_block(what);
    auto object = read_object(s.build);
    if (!object) s.build.fail_unknown("an object");
    if (place) object->transform_by(csg::Transform::translate(*place));
    read_modifiers(s.build, *object);
    s.build.close_block(what, opened);
    if (!object->drawn()) {
        s.build.set_aside(std::move(*object));
        return nullptr;
    }
    return std::make_shared<scene::Object>(std::move(*object));
}
Production inner_block()
{
    return {"inner_block", Form::braces({Form::named(any_object), Form::repeated(Form::named(object_modifier))})};
}
struct looks_like : item<Kind::LooksLike, reads<inner_block>> {
    static void act(LightState& s)
    {
        if (s.light().looks_like) s.fail("a light_source looks like one object only");
        // The lamp's body stands at the light and does not block it.
        auto body = read_inner(s, "looks_like", s.light().location);
        if (!body) return;
        body->flags.no_shadow = true;
        s.light().looks_like = std::move(body);
    }
};
struct projected_through : item<Kind::ProjectedThrough, reads<inner_block>> {
    static void act(LightState& s) { s.light().projected_through = read_inner(s, "projected_through"); }
};
struct light_photons : item<Kind::Photons, reads<light_photons_block>> {
    static void act(LightState& s)
    {
        std::shared_ptr<const scene::PhotonFlags>& own = s.object.details.edit().photons;
        own = read_photon_flags(s.build, true, own.get());
    }
};
struct color_map : item<Kind::ColorMap, reads<color_map_block>> {
    static void act(LightState& s)
    {
        glm::vec3 sum(0);
        for (const auto& entry : read_color_map(s.build)) sum += static_cast<float>(entry.key) * entry.value.rgb();
        s.light().color = sum;
    }
};

/// From this #version on a power counts without a fade_distance (spec 7c, 8); in hundredths.
constexpr int kFadesAlone = 380;

using scene::Light;
using LightItems = either<
    table<LightState, directional, spotlight, cylinder, shadowless, point_at, of_cone<Kind::Radius, &Light::radius_deg>,
          of_cone<Kind::Falloff, &Light::falloff_deg>, of_cone<Kind::Tightness, &Light::tightness>, area_light,
          area_illumination, circular, orient, looks_like, projected_through, light_photons, color_map,
          word<Kind::Parallel, &Light::parallel>, member<Kind::FadeDistance, &Light::fade_distance>,
          member<Kind::FadePower, &Light::fade_power>, member<Kind::Adaptive, &Light::adaptive>,
          word<Kind::Jitter, &Light::jitter>, member<Kind::MediaAttenuation, &Light::media_attenuation>,
          member<Kind::MediaInteraction, &Light::media_interaction>>,
    moves>;
struct light_location : a_vector, item_base {
    static void act(LightState& s)
    {
        s.light().location = s.pop_vector();
        s.light().point_at = {0, 0, 1};
    }
};
struct light_color : a_rgb, item_base {
    static void act(LightState& s) { s.light().color = s.pop_rgb(); }
};
struct declared_light : declared<std::shared_ptr<const scene::Object>> {};
struct light_head : pegtl::sor<declared_light, seq<light_location, opt_comma, opt<light_color>>> {};
using LightBlock = block<Kind::LightSource, LightItems, light_head>;

}  // namespace

template <>
inline constexpr auto expected<light_head> = "the light's location, as in <0, 10, 0>";
template <>
inline constexpr auto expected<second_axis> = "the area light's second axis";
template <>
inline constexpr auto expected<area_size> = "the area light's number of lamps along each axis";
template <>
inline constexpr auto expected<must<area_size>> = "the area light's number of lamps along each axis";

Production light_source_block() { return {"light_source_block", LightBlock::form()}; }

scene::Object read_light(SceneBuilder& build, const scene::SourceRef& source)
{
    scene::Object object;
    object.source = source;
    object.shape = scene::Light{};
    LightState s(build, object);
    s.light().color = glm::vec3(0);
    LightBlock::read(build, s);
    s.light().fades_from_start = build.stream().povray() == scene::PovRay::V38 && build.version() >= kFadesAlone;
    check_circular(s);
    return object;
}

}  // namespace parser
