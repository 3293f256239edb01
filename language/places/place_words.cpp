#include "language/places/place_words.h"

#include <map>

namespace language {
namespace {

using parser::Kind;
using Words = std::vector<std::string>;

Words words_of(std::string_view list)
{
    Words words;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(' ', at), list.size());
        if (end > at) words.emplace_back(list.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

// Lists that several blocks share.
#define WHITTLE_MOVES "translate rotate scale matrix transform "
#define WHITTLE_COLORS "color rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft red green blue filter transmit "
#define WHITTLE_LOOK "texture pigment normal finish interior interior_texture material uv_mapping "
#define WHITTLE_OBJECT                                                                                                 \
    WHITTLE_LOOK WHITTLE_MOVES "clipped_by bounded_by photons radiosity no_shadow no_image no_reflection "             \
                               "no_radiosity double_illuminate hollow "                                                \
                               "inverse cutaway_textures "
#define WHITTLE_SOLIDS                                                                                                 \
    "sphere box cylinder cone torus plane prism lathe sor blob text height_field isosurface julia_fractal "            \
    "parametric superellipsoid sphere_sweep ovus quadric cubic quartic poly polynomial mesh mesh2 bicubic_patch disc " \
    "polygon triangle smooth_triangle union merge intersection difference object "
#define WHITTLE_PATTERNS                                                                                               \
    "agate aoi average boxed bozo brick bumps cells checker crackle cubic cylindrical density_file dents facets "      \
    "function gradient granite hexagon image_pattern julia leopard magnet mandel marble object onion pavement "        \
    "pigment_pattern planar quilted radial ripples slope spherical spiral1 spiral2 spotted square tiling "             \
    "triangular waves wood wrinkles "
// What patterns of a kind take behind their name.
#define WHITTLE_PATTERN_ITEMS                                                                                          \
    "agate_turb brick_size mortar control0 control1 coords exponent exterior interior form metric offset solid size "  \
    "interpolate number_of_sides number_of_tiles pattern "
#define WHITTLE_WAVES "ramp_wave triangle_wave sine_wave scallop_wave cubic_wave poly_wave frequency phase "
#define WHITTLE_TURBULENCE "turbulence octaves omega lambda warp noise_generator "
#define WHITTLE_NUMBERS                                                                                                \
    "abs acos acosh asc asin asinh atan atan2 atanh bitwise_and bitwise_or bitwise_xor ceil cos cosh defined degrees " \
    "dimensions dimension_size div exp file_exists floor int inside ln log max min mod pi pow prod radians rand seed " \
    "select sin sinh sqrt strcmp strlen sum tan tanh val vdot vlength clock now true false yes no "
#define WHITTLE_VECTORS "x y z t u v min_extent max_extent trace vaxis_rotate vcross vnormalize vrotate vturbulence "
#define WHITTLE_TEXTS "chr concat datetime str strlwr strupr substr vstr "
#define WHITTLE_PIGMENT                                                                                                \
    WHITTLE_COLORS WHITTLE_PATTERNS WHITTLE_PATTERN_ITEMS                                                              \
        "color_map pigment_map image_map quick_color uv_mapping " WHITTLE_WAVES WHITTLE_TURBULENCE WHITTLE_MOVES
#define WHITTLE_NORMAL                                                                                                 \
    WHITTLE_PATTERNS WHITTLE_PATTERN_ITEMS                                                                             \
        "bump_map normal_map slope_map bump_size accuracy no_bump_scale uv_mapping " WHITTLE_WAVES WHITTLE_TURBULENCE  \
            WHITTLE_MOVES
#define WHITTLE_TEXTURE                                                                                                \
    "pigment normal finish texture_map tiles material_map no_bump_scale uv_mapping " WHITTLE_PATTERNS WHITTLE_WAVES    \
        WHITTLE_TURBULENCE WHITTLE_MOVES
#define WHITTLE_DENSITY                                                                                                \
    WHITTLE_COLORS WHITTLE_PATTERNS WHITTLE_PATTERN_ITEMS                                                              \
        "color_map density_map image_map " WHITTLE_WAVES WHITTLE_TURBULENCE WHITTLE_MOVES
#define WHITTLE_PICTURES "bmp exr gif hdr iff jpeg pgm png pot ppm sys tga tiff "

constexpr std::string_view kDirectives =
    "declare local undef macro if ifdef ifndef else elseif switch case range break while for end include version "
    "default debug warning error render statistics fopen fclose read write";
constexpr std::string_view kScene = WHITTLE_SOLIDS
    "camera light_source light_group background global_settings fog media rainbow sky_sphere default "
    "photons";
constexpr std::string_view kNumbers = WHITTLE_NUMBERS WHITTLE_VECTORS WHITTLE_TEXTS;
constexpr std::string_view kValues = WHITTLE_NUMBERS WHITTLE_VECTORS WHITTLE_TEXTS WHITTLE_COLORS WHITTLE_SOLIDS
    "array function spline texture pigment normal finish interior material transform color_map pigment_map "
    "normal_map slope_map texture_map density media camera fog rainbow sky_sphere light_source";

/// What stands in the block of a keyword; a second table says what differs inside of another block.
struct Row {
    Kind block;
    std::string_view words;
};

constexpr Row kBlocks[] = {
    {Kind::GlobalSettings,
     "adc_bailout ambient_light assumed_gamma charset hf_gray_16 irid_wavelength max_intersections max_trace_level "
     "mm_per_unit noise_generator number_of_waves photons radiosity subsurface"},
    {Kind::Camera, "perspective orthographic fisheye ultra_wide_angle omnimax panoramic cylinder spherical mesh_camera "
                   "location look_at angle right up direction sky aperture blur_samples focal_point confidence "
                   "variance bokeh normal " WHITTLE_MOVES},
    {Kind::LightSource, WHITTLE_COLORS
     "spotlight cylinder point_at radius falloff tightness parallel shadowless area_light adaptive jitter circular "
     "orient area_illumination fade_distance fade_power media_attenuation media_interaction looks_like "
     "projected_through photons whittle_directional " WHITTLE_MOVES},
    {Kind::LightGroup, "light_source light_group global_lights " WHITTLE_SOLIDS WHITTLE_MOVES},
    {Kind::Background, WHITTLE_COLORS},
    {Kind::Fog, "fog_type distance fog_offset fog_alt up turbulence turb_depth octaves omega lambda " WHITTLE_COLORS
                    WHITTLE_MOVES},
    {Kind::Rainbow, "direction angle width distance jitter up arc_angle falloff_angle color_map"},
    {Kind::SkySphere, "pigment emission " WHITTLE_MOVES},
    {Kind::Texture, WHITTLE_TEXTURE},
    {Kind::InteriorTexture, WHITTLE_TEXTURE},
    {Kind::Material, "texture interior_texture interior " WHITTLE_MOVES},
    {Kind::Pigment, WHITTLE_PIGMENT},
    {Kind::Normal, WHITTLE_NORMAL},
    {Kind::Finish, "ambient emission diffuse albedo brilliance crand phong phong_size specular roughness metallic "
                   "reflection reflection_exponent conserve_energy irid subsurface whittle_cool_warm whittle_ink "
                   "whittle_polished"},
    {Kind::Irid, "thickness turbulence"},
    {Kind::Interior,
     "ior dispersion dispersion_samples caustics fade_distance fade_power fade_color media " WHITTLE_MOVES},
    {Kind::Media, "absorption emission scattering density method samples intervals ratio confidence variance jitter "
                  "aa_level aa_threshold collect " WHITTLE_MOVES},
    {Kind::Scattering, "eccentricity extinction"},
    {Kind::Density, WHITTLE_DENSITY},
    {Kind::ColorMap, WHITTLE_COLORS},
    {Kind::PigmentMap, WHITTLE_PIGMENT},
    {Kind::NormalMap, WHITTLE_NORMAL},
    {Kind::TextureMap, WHITTLE_TEXTURE},
    {Kind::DensityMap, WHITTLE_DENSITY},
    {Kind::ImageMap, WHITTLE_PICTURES "map_type interpolate once filter transmit gamma premultiplied use_color "
                                      "use_index"},
    {Kind::BumpMap, WHITTLE_PICTURES "map_type interpolate once bump_size use_color use_index gamma"},
    {Kind::MaterialMap, WHITTLE_PICTURES "map_type interpolate once texture gamma use_color use_index"},
    {Kind::ImagePattern,
     WHITTLE_PICTURES "map_type interpolate once use_alpha use_color use_index gamma premultiplied"},
    {Kind::Warp, "repeat offset flip black_hole falloff strength inverse turbulence octaves omega lambda planar "
                 "cylindrical spherical toroidal cubic orientation dist_exp major_radius " WHITTLE_MOVES},
    {Kind::Photons, "target refraction reflection collect pass_through"},
    {Kind::Radiosity, "importance"},
    {Kind::Transform, WHITTLE_MOVES "inverse"},
    {Kind::ContainedBy, "sphere box"},
    {Kind::ClippedBy, "bounded_by " WHITTLE_SOLIDS},
    {Kind::BoundedBy, "clipped_by " WHITTLE_SOLIDS},
    {Kind::LooksLike, WHITTLE_SOLIDS},
    {Kind::ProjectedThrough, WHITTLE_SOLIDS},
    {Kind::Function, WHITTLE_NUMBERS "x y z u v pattern pigment transform spline internal"},
    {Kind::Spline, "linear_spline quadratic_spline cubic_spline natural_spline"},
    // Solids: what each has besides the modifiers of all.
    {Kind::Sphere, WHITTLE_OBJECT},
    {Kind::Box, WHITTLE_OBJECT},
    {Kind::Plane, WHITTLE_OBJECT},
    {Kind::Disc, WHITTLE_OBJECT},
    {Kind::Polygon, WHITTLE_OBJECT},
    {Kind::Triangle, WHITTLE_OBJECT},
    {Kind::SmoothTriangle, WHITTLE_OBJECT},
    {Kind::Superellipsoid, WHITTLE_OBJECT},
    {Kind::Ovus, WHITTLE_OBJECT},
    {Kind::Quadric, WHITTLE_OBJECT},
    {Kind::Cubic, "sturm " WHITTLE_OBJECT},
    {Kind::Quartic, "sturm " WHITTLE_OBJECT},
    {Kind::Poly, "sturm " WHITTLE_OBJECT},
    {Kind::Polynomial, "sturm xyz " WHITTLE_OBJECT},
    {Kind::Cylinder, "open " WHITTLE_OBJECT},
    {Kind::Cone, "open " WHITTLE_OBJECT},
    {Kind::Torus, "sturm " WHITTLE_OBJECT},
    {Kind::Prism,
     "linear_spline quadratic_spline cubic_spline bezier_spline linear_sweep conic_sweep open sturm " WHITTLE_OBJECT},
    {Kind::Lathe, "linear_spline quadratic_spline cubic_spline bezier_spline sturm " WHITTLE_OBJECT},
    {Kind::Sor, "open sturm " WHITTLE_OBJECT},
    {Kind::SphereSweep, "linear_spline b_spline cubic_spline tolerance " WHITTLE_OBJECT},
    {Kind::Blob, "threshold sphere cylinder sturm hierarchy " WHITTLE_OBJECT},
    {Kind::Text, "ttf internal " WHITTLE_OBJECT},
    {Kind::HeightField, WHITTLE_PICTURES "smooth water_level hierarchy gamma premultiplied function " WHITTLE_OBJECT},
    {Kind::Isosurface, "function contained_by threshold accuracy max_gradient evaluate open max_trace "
                       "all_intersections " WHITTLE_OBJECT},
    {Kind::Parametric, "function contained_by max_gradient accuracy precompute " WHITTLE_OBJECT},
    {Kind::JuliaFractal, "quaternion hypercomplex sqr cube exp reciprocal sin asin sinh asinh cos acos cosh acosh tan "
                         "atan tanh atanh ln pwr max_iteration precision slice " WHITTLE_OBJECT},
    {Kind::BicubicPatch, "type flatness u_steps v_steps uv_vectors " WHITTLE_OBJECT},
    {Kind::Mesh, "triangle smooth_triangle inside_vector hierarchy " WHITTLE_OBJECT},
    {Kind::Mesh2, "vertex_vectors normal_vectors uv_vectors texture_list face_indices normal_indices uv_indices "
                  "inside_vector hierarchy " WHITTLE_OBJECT},
    {Kind::Union, "split_union light_source " WHITTLE_SOLIDS WHITTLE_OBJECT},
    {Kind::Merge, WHITTLE_SOLIDS WHITTLE_OBJECT},
    {Kind::Intersection, WHITTLE_SOLIDS WHITTLE_OBJECT},
    {Kind::Difference, WHITTLE_SOLIDS WHITTLE_OBJECT},
    {Kind::Object, "light_source " WHITTLE_SOLIDS WHITTLE_OBJECT},
    {Kind::Default, "texture pigment normal finish radiosity camera"},
};

struct InnerRow {
    Kind outer, block;
    std::string_view words;
};

constexpr InnerRow kInner[] = {
    {Kind::Finish, Kind::Reflection, "fresnel falloff exponent metallic whittle_gloss whittle_schlick " WHITTLE_COLORS},
    {Kind::GlobalSettings, Kind::Radiosity,
     "adc_bailout always_sample brightness count error_bound gray_threshold low_error_factor max_sample maximum_reuse "
     "load_file media minimum_reuse nearest_count normal pretrace_end pretrace_start recursion_limit save_file "
     "subsurface"},
    {Kind::GlobalSettings, Kind::Photons,
     "spacing count gather max_trace_level media jitter autostop expand_thresholds radius adc_bailout save_file "
     "load_file"},
    {Kind::GlobalSettings, Kind::Subsurface, "samples radiosity"},
    {Kind::Finish, Kind::Subsurface, "translucency anisotropy"},
    {Kind::LightSource, Kind::Photons, "refraction reflection area_light"},
    {Kind::Blob, Kind::Sphere, "strength texture pigment normal finish " WHITTLE_MOVES},
    {Kind::Blob, Kind::Cylinder, "strength texture pigment normal finish " WHITTLE_MOVES},
    {Kind::ContainedBy, Kind::Sphere, ""},
    {Kind::ContainedBy, Kind::Box, ""},
};

}  // namespace

const Words& directive_words()
{
    static const Words words = words_of(kDirectives);
    return words;
}

const Words& scene_words()
{
    static const Words words = words_of(kScene);
    return words;
}

const Words& number_words()
{
    static const Words words = words_of(kNumbers);
    return words;
}

const Words& value_words()
{
    static const Words words = words_of(kValues);
    return words;
}

Words block_words(Kind block, Kind outer)
{
    for (const InnerRow& row : kInner)
        if (row.outer == outer && row.block == block) return words_of(row.words);
    for (const Row& row : kBlocks)
        if (row.block == block) return words_of(row.words);
    return {};
}

std::string_view keyword_line(Kind keyword)
{
    static const std::map<Kind, std::string_view> lines = {
#define WHITTLE_LINE(kind, line) {Kind::kind, line},
#include "language/places/keyword_lines.inc"
#undef WHITTLE_LINE
    };
    const auto found = lines.find(keyword);
    return found == lines.end() ? std::string_view() : found->second;
}

}  // namespace language
