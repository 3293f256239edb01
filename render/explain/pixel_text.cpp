#include "render/explain/pixel.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>

namespace explain {
namespace {

std::string told(const glm::dvec3& v) { return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", v.x, v.y, v.z); }
std::string told(const glm::vec3& v) { return fmt::format("<{:.5g}, {:.5g}, {:.5g}>", v.x, v.y, v.z); }
std::string told(double t)
{
    return std::isfinite(t) ? fmt::format("{:.6g}", t) : t > 0 ? "without end" : "without beginning";
}

class PixelText {
public:
    explicit PixelText(const scene::Description& description) : description_(description) {}

    std::string all(const Pixel& pixel, const glm::ivec3& shown)
    {
        out_ = fmt::format("pixel {},{} of {}x{}: {} {} {} of 255, light {}\n", pixel.x, pixel.y, pixel.width,
                           pixel.height, shown.x, shown.y, shown.z, told(pixel.rendered));
        if (!pixel.tree) return out_ + "the camera has no ray there\n";
        ray(*pixel.tree, 0);
        const glm::vec3 off = glm::abs(pixel.tree->color - pixel.rendered);
        line(0, "sum " + told(pixel.tree->color) +
                    fmt::format(", off the picture's by {:.2g}", std::max({off.x, off.y, off.z})));
        for (const std::string& what : pixel.left_out) line(0, "not in the sum: " + what);
        line(0, "antialiasing and jitter are not told: this is the ray through the pixel's middle");
        return out_;
    }

private:
    void line(int depth, const std::string& text)
    {
        out_.append(2 * static_cast<std::size_t>(depth), ' ');
        out_ += text + "\n";
    }

    /// The word that stands at a place: "sphere", "object", a macro's name.
    std::string word_at(const scene::Place& place)
    {
        auto known = lines_.find(place.path);
        if (known == lines_.end()) {
            std::ifstream in(place.path);
            std::vector<std::string> lines;
            for (std::string text; std::getline(in, text);) lines.push_back(text);
            known = lines_.emplace(place.path, std::move(lines)).first;
        }
        if (place.at.line == 0 || place.at.line > known->second.size()) return "solid";
        const std::string& text = known->second[place.at.line - 1];
        std::size_t begin = place.at.column - 1, end = begin;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        return end > begin ? text.substr(begin, end - begin) : "solid";
    }

    std::string named(const scene::SourceRef& source)
    {
        const scene::Place place = description_.place(source);
        return place.path.empty() ? "solid" : word_at(place) + " " + scene::place_text(place);
    }

    std::string end_of(const End& end)
    {
        return end.leaf != nullptr ? told(end.t) + " " + named(end.leaf->source) : told(end.t);
    }

    void spans(const RayNode& node, int depth)
    {
        if (node.spans.empty()) return;
        line(depth, "in and out of solids:");
        for (const ObjectSpans& spans : node.spans) {
            line(depth + 1, named(spans.object->source));
            for (const Piece& piece : spans.pieces)
                line(depth + 2, "in " + end_of(piece.in) + ", out " + end_of(piece.out));
        }
    }

    void ray(const RayNode& node, int depth)
    {
        line(depth, fmt::format("{} ray, level {}, from {} towards {}", node.kind, node.level, told(node.ray.origin),
                                told(node.ray.direction)));
        spans(node, depth + 1);
        if (!node.hit) {
            line(depth + 1, "sees " + node.sees + ": " + told(node.color));
            return;
        }
        std::string met = named(node.solid != nullptr ? node.solid->source : node.object);
        const std::string whole = named(node.object);
        if (whole != met) met += " of " + whole;
        line(depth + 1, fmt::format("meets {} at t {:.6g}, {}{}", met, node.t, told(node.point),
                                    node.from_inside ? ", from inside" : ""));
        line(depth + 1, "normal " + told(node.normal));
        for (const TextureShare& share : node.textures) texture(share, node, depth + 1);
        line(depth + 1, "together " + told(node.color));
    }

    void texture(const TextureShare& share, const RayNode& node, int depth)
    {
        if (!share.of.empty()) line(depth++, fmt::format("{}, weight {:.4g}:", share.of, share.weight));
        for (std::size_t i = 0; i < share.layers.size(); ++i) {
            const LayerShare& layer = share.layers[i];
            const scene::Color& c = layer.pigment;
            line(depth, fmt::format("{}pigment rgbft <{:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}>{}",
                                    share.layers.size() > 1 ? fmt::format("layer {} from the top: ", i + 1) : "", c.red,
                                    c.green, c.blue, c.filter, c.transmit,
                                    layer.own < 1.0f ? fmt::format(", {:.4g} of it its own", layer.own) : ""));
            if (layer.normal != node.normal) line(depth + 1, "normal bent to " + told(layer.normal));
            if (layer.above != glm::vec3(1)) line(depth + 1, "layers above let through " + told(layer.above));
            if (layer.glow != glm::vec3(0)) line(depth + 1, "ambient and emission " + told(layer.glow));
            for (const LightShare& light : layer.lights) of_light(light, depth + 1);
        }
        for (const SecondaryRay& onward : share.onward) {
            line(depth, fmt::format("{} {} of{}", onward.how, told(onward.factor),
                                    onward.ray ? ":" : " nothing, cut off: " + onward.cut));
            if (onward.ray) ray(*onward.ray, depth + 1);
        }
    }

    void of_light(const LightShare& light, int depth)
    {
        std::string text = fmt::format("light {} at {}: ", light.number + 1, told(light.location));
        const bool gives = light.diffuse != glm::vec3(0) || light.highlight != glm::vec3(0);
        if (gives) text += "diffuse " + told(light.diffuse);
        if (light.highlight != glm::vec3(0)) text += ", highlight " + told(light.highlight);
        if (!gives) text += "nothing";
        if (!light.why.empty()) text += ", " + light.why;
        line(depth, text);
    }

    const scene::Description& description_;
    std::map<std::string, std::vector<std::string>> lines_;
    std::string out_;
};

}  // namespace

std::string pixel_text(const Pixel& pixel, const scene::Description& description, const glm::ivec3& shown)
{
    return PixelText(description).all(pixel, shown);
}

}  // namespace explain
