#include "render/explain/pixel.h"
#include "render/explain/ray_spans.h"
#include "render/explain/reasons.h"
#include "render/kernel/tile/nearly_zero.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace explain {
namespace {

constexpr std::size_t kMostRays = 256;    // that one pixel is explained by
constexpr std::size_t kMostObjects = 24;  // whose spans a ray is told with
constexpr double kRounding = 1e-6;        // less than this share of a sum of single precision is no highlight

using trace::RecordedRay;
using trace::RecordedRow;
using trace::ShadeNode;
using trace::ShadeTerm;

std::string told(const glm::dvec3& v) { return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", v.x, v.y, v.z); }
std::string told(const glm::vec3& v) { return fmt::format("<{:.5g}, {:.5g}, {:.5g}>", v.x, v.y, v.z); }
std::string told(double t)
{
    return std::isfinite(t) ? fmt::format("{:.6g}", t) : t > 0 ? "without end" : "without beginning";
}
std::string sum_of(const glm::dvec3& v) { return told(glm::vec3(v)); }

class PixelText {
public:
    PixelText(const Pixel& pixel, const scene::Description& description, const plan::CompiledScene& scene)
        : pixel_(pixel), record_(pixel.record), scene_(scene), names_(description), spans_(description)
    {}

    std::string all(const glm::ivec3& shown)
    {
        out_ = fmt::format("pixel {},{} of {}x{}: {} {} {} of 255, light {}\n", pixel_.x, pixel_.y,
                           scene_.options.width, scene_.options.height, shown.x, shown.y, shown.z,
                           told(pixel_.rendered));
        if (record_.camera.empty()) return out_ + "the camera has no ray there\n";
        const bool many = record_.camera.size() > 1;
        if (many)
            line(0, fmt::format("the mean of {} rays; the first of them:",
                                record_.camera.size() + static_cast<std::size_t>(record_.without_ray)));
        ray(0, "camera", 0);
        for (std::size_t i = 1; i < record_.camera.size(); ++i) {
            const RecordedRay& of = record_.rays[*ray_of(record_.camera[i], {})];
            line(0, fmt::format("ray {} {}: {}", i + 1,
                                of.met.found() ? "meets " + names_.object(scene_, of.met.surface) : "meets nothing",
                                color(of.slot)));
        }
        const glm::vec3 off = glm::abs(pixel_.sum - pixel_.rendered);
        line(0,
             "sum " + told(pixel_.sum) + fmt::format(", off the picture's by {:.2g}", std::max({off.x, off.y, off.z})));
        line(0, "antialiasing and jitter are not told: this is the pixel without them");
        return out_;
    }

private:
    void line(int depth, const std::string& text)
    {
        out_.append(2 * static_cast<std::size_t>(depth), ' ');
        out_ += text + "\n";
    }

    std::string color(trace::ColorSlot slot) const { return told(pixel_.colors[slot].rgb()); }

    /// The ray whose colour lies there, the first one behind another ray.
    std::optional<std::uint32_t> ray_of(trace::ColorSlot slot, std::optional<std::uint32_t> behind) const
    {
        for (std::uint32_t i = behind ? *behind + 1 : 0; i < record_.rays.size(); ++i)
            if (record_.rays[i].slot == slot) return i;
        return {};
    }

    /// The node of a ray that makes this colour.
    const ShadeNode* node_of(std::uint32_t ray, trace::ColorSlot slot) const
    {
        for (std::size_t i = 0; i < record_.nodes.size(); ++i)
            if (record_.nodes[i].out == slot && record_.owners[i].ray == ray) return &record_.nodes[i];
        return nullptr;
    }

    void spans(const std::vector<ObjectSpans>& of, int depth)
    {
        if (of.empty()) return;
        const auto end = [&](const End& at) {
            return at.leaf != nullptr ? told(at.t) + " " + names_.solid(at.leaf->source) : told(at.t);
        };
        line(depth, "in and out of solids:");
        for (const ObjectSpans& object : of) {
            line(depth + 1, names_.solid(object.object->source));
            for (const Piece& piece : object.pieces) line(depth + 2, "in " + end(piece.in) + ", out " + end(piece.out));
        }
    }

    /// The solid that a hit lies on, where spans tell: they and hits come from the same formulas.
    const scene::Object* solid_at(double t, const std::vector<ObjectSpans>& of) const
    {
        const scene::Object* solid = nullptr;
        double nearest = 1e-6 * (1.0 + t);
        for (const ObjectSpans& object : of)
            for (const Piece& piece : object.pieces)
                for (const End* end : {&piece.in, &piece.out})
                    if (end->leaf != nullptr && std::abs(end->t - t) < nearest) {
                        nearest = std::abs(end->t - t);
                        solid = end->leaf;
                    }
        return solid;
    }

    void ray(std::uint32_t number, const std::string& kind, int depth)
    {
        const RecordedRay& of = record_.rays[number];
        if (++rays_ > kMostRays)
            return line(depth, fmt::format("its colour is {}; {} rays are told, no more", color(of.slot), kMostRays));
        const bool one_wave = of.state.wavelength > 0.0f;
        line(depth, fmt::format("{} ray, level {}{}, from {} towards {}", kind, of.level,
                                one_wave ? fmt::format(", of {:.4g} nm", of.state.wavelength) : "",
                                told(of.state.ray.origin), told(of.state.ray.direction)));
        const std::vector<ObjectSpans> met = spans_.along(of.state.ray, kMostObjects);
        spans(met, depth + 1);
        if (of.met.found()) hit(of, solid_at(of.met.t, met), depth + 1);
        else sky(of, depth + 1);
        if (of.ends) {
            for (std::size_t i = 0; i < of.rows.size(); ++i) layer(of, i, i + 1, of.rows.size(), depth + 1);
            if (!of.air.empty()) air(of, depth + 1);
        } else {
            colour(number, of.slot, 1.0f, depth + 1);
        }
        if (of.met.found() || !of.air.empty()) line(depth + 1, "together " + color(of.slot));
    }

    void hit(const RecordedRay& of, const scene::Object* solid, int depth)
    {
        const plan::Surface& surface = scene_.surfaces[of.met.surface];
        const std::string whole = names_.solid(scene_, surface);
        std::string met = solid != nullptr ? names_.solid(solid->source) : whole;
        if (whole != met) met += " of " + whole;
        line(depth, fmt::format("meets {} at t {:.6g}, {}{}", met, of.met.t, told(of.point),
                                of.from_inside ? ", from inside" : ""));
        line(depth, "normal " + told(of.normal));
    }

    void sky(const RecordedRay& of, int depth)
    {
        const std::size_t layers = scene_.sky.layers.size();
        line(depth, (layers == 0 ? "sees nothing but the background: "
                                 : fmt::format("sees the sky, {} layer{}: ", layers, layers == 1 ? "" : "s")) +
                        told(of.seen.rgb()));
    }

    /// What is between the ray's origin and what it sees.
    void air(const RecordedRay& of, int depth)
    {
        constexpr std::array<const char*, 4> kNames{"media inside", "rainbows", "media all over", "fog"};
        trace::Air before;
        for (const trace::RecordedAir& step : of.air) {
            const glm::vec3 share = step.so_far.share / before.share;
            const bool dark = before.share == glm::vec3(0);
            line(depth, fmt::format("{}: {} comes through, {} is added", kNames[static_cast<std::size_t>(step.effect)],
                                    told(dark ? glm::vec3(0) : share),
                                    told(step.so_far.glow - (dark ? glm::vec3(0) : share) * before.glow)));
            before = step.so_far;
        }
        if (of.air.size() > 1)
            line(depth,
                 fmt::format("all the air: {} comes through, {} is added", told(before.share), told(before.glow)));
    }

    /// Which of several textures a colour is that of. share: of the whole.
    bool entries(std::uint32_t ray, trace::ColorSlot slot, float share, int depth)
    {
        std::string of;
        for (const trace::RecordedEntry& entry : record_.entries)
            if (entry.slot == slot) of += (of.empty() ? "" : ", ") + name_of(entry, record_.rays[ray]);
        if (of.empty()) return false;
        line(depth, fmt::format("{}, weight {:.4g}:", of, share));
        return true;
    }
    std::string name_of(const trace::RecordedEntry& entry, const RecordedRay& of) const
    {
        constexpr std::array<const char*, 3> kCorners{"first corner", "second corner", "third corner"};
        if (!entry.of_map)
            return scene_.surfaces[of.met.surface].part_count != 0 ? fmt::format("part {}", entry.entry + 1)
                                                                   : kCorners[entry.entry];
        for (const texture::Texture& map : scene_.textures.textures)
            if (map.kind == texture::Texture::Kind::Map && entry.entry - map.first < map.count)
                return fmt::format("of a texture_map, entry {}", entry.entry - map.first + 1);
        return "of a texture_map";
    }

    /// A colour that a hit's nodes put together, or that of a ray that goes on. share: of the whole.
    void colour(std::uint32_t ray, trace::ColorSlot slot, float share, int depth)
    {
        if (entries(ray, slot, share, depth)) ++depth;
        if (const ShadeNode* made = node_of(ray, slot)) return node(ray, *made, share, depth);
        if (const auto next = ray_of(slot, ray)) {
            line(depth, "lets all light through as it is, and asks no lamp:");
            return this->ray(*next, "straight on", depth + 1);
        }
        line(depth, "black: it has no texture there, an ink line is drawn, or its ray was cut off");
    }

    void node(std::uint32_t ray, const ShadeNode& of, float share, int depth)
    {
        const auto first = record_.terms.begin() + of.first;
        const auto each = [&](auto&& f) {
            for (std::uint32_t i = 0; i < of.count; ++i) f(i, first[i]);
        };
        switch (of.kind) {
        case ShadeNode::Kind::Surface: return surface(ray, of, depth);
        case ShadeNode::Kind::Air: colour(ray, of.through, share, depth); return air(record_.rays[ray], depth);
        case ShadeNode::Kind::Mix: {
            const auto upper = static_cast<float>(of.share);
            colour(ray, of.through, share * (1.0f - upper), depth);
            return colour(ray, first->slot, share * upper, depth);
        }
        case ShadeNode::Kind::Sum:
            return each([&](std::uint32_t, const ShadeTerm& term) {
                if (term.slot != trace::kNoSlot) colour(ray, term.slot, share * term.factor.x, depth);
            });
        case ShadeNode::Kind::Mean: return mean(ray, of, share, depth);
        case ShadeNode::Kind::Spectrum:
            line(depth, fmt::format("the mean of {} wavelengths:", of.count));
            return each([&](std::uint32_t, const ShadeTerm& term) {
                onward(ray, "a hue of " + told(term.factor * term.film), "refracted", term.slot, depth);
            });
        }
    }

    /// An average of textures, or of rays off a rough mirror.
    void mean(std::uint32_t ray, const ShadeNode& of, float share, int depth)
    {
        for (std::uint32_t i = 0; i < of.count; ++i) {
            const ShadeTerm& term = record_.terms[of.first + i];
            const float weight = share * term.factor.x / of.weights;
            if (term.slot == trace::kNoSlot || node_of(ray, term.slot) == nullptr) {
                onward(ray, fmt::format("weight {:.4g}", weight), "roughly reflected", term.slot, depth);
            } else {
                line(depth, fmt::format("of an average, entry {}, weight {:.4g}:", i + 1, weight));
                colour(ray, term.slot, weight, depth + 1);
            }
        }
    }

    /// Layers with what they leave to other rays.
    void surface(std::uint32_t ray, const ShadeNode& of, int depth)
    {
        const RecordedRay& hit = record_.rays[ray];
        const auto at = static_cast<std::size_t>(&of - record_.nodes.data());
        const trace::RecordedOwner& owner = record_.owners[at];
        const std::size_t layers = owner.last - owner.first;
        for (std::size_t i = owner.first; i < owner.last; ++i) layer(hit, i, i - owner.first + 1, layers, depth);
        if (layers == 0 && of.own != glm::vec3(0)) line(depth, "colour " + told(of.own));
        through(ray, of, depth);
        for (std::uint32_t i = 0; i < of.count; ++i) {
            const ShadeTerm& term = record_.terms[of.first + i];
            std::string how = "reflects " + told(term.factor * term.film);
            if (term.power != 1.0f) how += fmt::format(" of the power {:.4g}", term.power);
            if (term.slot == trace::kNoSlot)
                line(depth, how + " of nothing, cut off: " + why_cut(scene_, hit, mirror_weight(record_, of, i)));
            else onward(ray, how, "reflected", term.slot, depth);
        }
    }

    void through(std::uint32_t ray, const ShadeNode& of, int depth)
    {
        const RecordedRay& hit = record_.rays[ray];
        const std::string factor = told(of.film * of.fade * (of.total ? glm::vec3(1) : of.filter));
        if (of.through != trace::kNoSlot) {
            const auto next = ray_of(of.through, ray);
            const bool bent = !next || record_.rays[*next].level != hit.level;
            return of.total ? onward(ray, "reflects within " + factor, "reflected within", of.through, depth)
                   : bent   ? onward(ray, "refracts " + factor, "refracted", of.through, depth)
                            : onward(ray, "lets through " + factor, "straight on", of.through, depth);
        }
        if (of.residual <= 0.0f || scene_.surfaces[hit.met.surface].interior == plan::kNone ||
            !scene_.settings.quality.transmission)
            return;
        const bool little = !(of.residual > static_cast<float>(scene_.settings.adc_bailout));
        line(depth, (of.total ? "reflects within " : "lets through ") + factor + " of nothing, cut off: " +
                        (little ? fmt::format("what is let through, {:.4g}, is below adc_bailout {:.4g}", of.residual,
                                              scene_.settings.adc_bailout)
                                : why_cut(scene_, hit, hit.state.weight * trace::largest(glm::abs(of.filter)))));
    }

    /// A ray that goes on, or a node of such rays.
    void onward(std::uint32_t ray, const std::string& how, const char* kind, trace::ColorSlot slot, int depth)
    {
        if (slot == trace::kNoSlot)
            return line(depth, how + " of nothing, cut off: " + why_cut(scene_, record_.rays[ray], -1.0f));
        line(depth, how + " of:");
        if (node_of(ray, slot) != nullptr) colour(ray, slot, 1.0f, depth + 1);
        else if (const auto next = ray_of(slot, ray)) this->ray(*next, kind, depth + 1);
    }

    void layer(const RecordedRay& hit, std::size_t row, std::size_t number, std::size_t layers, int depth)
    {
        const RecordedRow& of = hit.rows[row];
        const scene::Color& c = of.pigment;
        line(depth,
             fmt::format("{}pigment rgbft <{:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}>{}",
                         layers > 1 ? fmt::format("layer {} from the top: ", number) : "", c.red, c.green, c.blue,
                         c.filter, c.transmit, of.own < 1.0f ? fmt::format(", {:.4g} of it its own", of.own) : ""));
        if (of.normal != hit.normal) line(depth + 1, "normal bent to " + told(of.normal));
        if (of.filter != glm::vec3(1)) line(depth + 1, "layers above let through " + told(of.filter));
        if (of.glow != glm::vec3(0)) line(depth + 1, "ambient and emission " + told(of.glow));
        for (std::size_t i = 0; i < scene_.lights.lights.size(); ++i) lamp(hit, of, i, depth + 1);
        for (const trace::RecordedGain& gain : of.gains) {
            if (gain.source >= 0) continue;
            const char* const from = gain.source == trace::RecordedGain::Photons        ? "photons "
                                     : gain.source == trace::RecordedGain::Surroundings ? "light of the surroundings "
                                                                                        : "light below the surface ";
            line(depth + 1, from + sum_of(gain.sum));
        }
        if (!of.gains.empty() && (of.gains.size() > 1 || of.glow != glm::vec3(0)))
            line(depth + 1, "its light " + told(light_of(of)));
    }

    void lamp(const RecordedRay& hit, const RecordedRow& row, std::size_t number, int depth)
    {
        std::string text = fmt::format("light {} at {}: ", number + 1, told(scene_.lights.lights[number].location));
        const auto gain = std::find_if(row.gains.begin(), row.gains.end(), [&](const trace::RecordedGain& of) {
            return of.source == static_cast<std::int32_t>(number);
        });
        const bool gives = gain != row.gains.end();
        if (gives) {
            text += "diffuse " + sum_of(gain->diffuse);
            const glm::dvec3 rest = gain->sum - gain->diffuse, rounding = kRounding * glm::abs(gain->sum);
            if (glm::any(glm::greaterThan(glm::abs(rest), rounding))) text += ", highlight " + sum_of(rest);
        } else {
            text += "nothing";
        }
        const std::string why = why_dim(scene_, names_, hit, row, number, gives);
        line(depth, text + (why.empty() ? "" : ", " + why));
    }

    const Pixel& pixel_;
    const trace::Record& record_;
    const plan::CompiledScene& scene_;
    PlaceNames names_;
    RaySpans spans_;
    std::size_t rays_ = 0;
    std::string out_;
};

}  // namespace

std::string pixel_text(const Pixel& pixel, const scene::Description& description, const plan::CompiledScene& scene,
                       const glm::ivec3& shown)
{
    return PixelText(pixel, description, scene).all(shown);
}

}  // namespace explain
