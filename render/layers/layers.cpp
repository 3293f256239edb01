#include "render/layers/layers.h"

#include "render/layers/cryptomatte.h"
#include "render/study/cost/heat.h"
#include "render/picture/kernel_module.h"
#include "render/picture/sampling/find_sources.h"
#include "render/picture/workers.h"
#include "numbers/random.h"
#include "render/kernel/tile/sobol.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace layers {
namespace {

struct KindName {
    Kind kind;
    std::string_view name;
    std::array<std::string_view, 3> channels;  ///< empty ones are none; objects have Cryptomatte's beside
};

constexpr std::array<KindName, 8> kKinds{{{Kind::Depth, "depth", {"Z"}},
                                          {Kind::Normal, "normal", {"X", "Y", "Z"}},
                                          {Kind::Position, "position", {"X", "Y", "Z"}},
                                          {Kind::Albedo, "albedo", {"R", "G", "B"}},
                                          {Kind::Object, "object", {"id"}},
                                          {Kind::Material, "material", {"id"}},
                                          {Kind::Uv, "uv", {"U", "V"}},
                                          {Kind::Time, "time", {"ns"}}}};

constexpr std::uint32_t kSamples = 16;  // of a pixel whose picture is antialiased
constexpr int kSide = 8;

const KindName& of(Kind kind)
{
    return *std::find_if(kKinds.begin(), kKinds.end(), [kind](const KindName& k) { return k.kind == kind; });
}

/// Makes the values of a square of pixels.
class Square {
public:
    Square(const plan::CompiledScene& scene, const std::vector<Kind>& kinds, const std::vector<float>& ids,
           std::uint32_t samples, image::Channels& out)
        : scene_(scene), kinds_(kinds), ids_(ids), samples_(samples), out_(out)
    {}

    /// False: cancelled.
    bool make(const trace::KernelTable& kernel, trace::PathTracer& tracer, const trace::Block& square)
    {
        asked_.clear();
        for (int y = square.top; y < square.top + square.height; ++y)
            for (int x = square.left; x < square.left + square.width; ++x) ask(x, y);
        seen_.resize(asked_.size());
        if (!kernel.first_hits(tracer, asked_, seen_.data())) return false;
        const trace::FirstHit* of_pixel = seen_.data();
        for (int y = square.top; y < square.top + square.height; ++y)
            for (int x = square.left; x < square.left + square.width; ++x, of_pixel += samples_)
                put({of_pixel, samples_}, x, y);
        return true;
    }

private:
    /// The first sample is the middle of the pixel.
    void ask(int x, int y)
    {
        const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32 |
                                    static_cast<std::uint32_t>(x);
        const auto seed = static_cast<std::uint32_t>(numbers::stirred(place + 0x9e3779b97f4a7c15u));
        asked_.push_back({static_cast<double>(x), static_cast<double>(y), seed, 0});
        for (std::uint32_t i = 1; i < samples_; ++i) {
            const std::array<double, 2> at = trace::sobol_point(seed, i);
            asked_.push_back({x - 0.5 + at[0], y - 0.5 + at[1], seed, i});
        }
    }

    std::uint32_t statement(const trace::FirstHit& seen) const
    {
        return scene_.objects[scene_.surfaces[seen.surface].object].statement;
    }

    template <class Get>
    static glm::vec3 mean(std::span<const trace::FirstHit> samples, Get get)
    {
        glm::vec3 sum(0);
        for (const trace::FirstHit& s : samples) sum += get(s);
        return sum / static_cast<float>(samples.size());
    }

    void put(std::span<const trace::FirstHit> samples, int x, int y)
    {
        float* to = &out_.values[out_.names.size() *
                                 (static_cast<std::size_t>(y - out_.top) * static_cast<std::size_t>(out_.width) +
                                  static_cast<std::size_t>(x))];
        const trace::FirstHit& middle = samples[0];
        const auto three = [&](const glm::vec3& v) { to = std::copy_n(&v.x, 3, to); };
        for (const Kind kind : kinds_) {
            switch (kind) {
            case Kind::Depth: *to++ = middle.found ? static_cast<float>(middle.depth) : kNothing; break;
            case Kind::Normal: three(mean(samples, [](const auto& s) { return s.normal; })); break;
            case Kind::Position: three(glm::vec3(middle.point)); break;
            case Kind::Albedo: three(mean(samples, [](const auto& s) { return s.albedo; })); break;
            case Kind::Object: {
                *to++ = middle.found ? static_cast<float>(statement(middle) + 1) : 0.0f;
                std::array<float, kSamples> ids{};
                for (std::size_t i = 0; i < samples.size(); ++i)
                    ids[i] = samples[i].found ? ids_[statement(samples[i])] : 0.0f;
                rank({ids.data(), samples.size()}, to);
                to += kCryptomatteChannels;
                break;
            }
            case Kind::Material:
                *to++ = middle.found && middle.texture != plan::kNone ? static_cast<float>(middle.texture + 1) : 0.0f;
                break;
            case Kind::Uv:
                *to++ = middle.uv.x;
                *to++ = middle.uv.y;
                break;
            case Kind::Time: ++to; break;  // measured apart
            }
        }
    }

    const plan::CompiledScene& scene_;
    const std::vector<Kind>& kinds_;
    const std::vector<float>& ids_;
    const std::uint32_t samples_;
    image::Channels& out_;
    std::vector<trace::PathSample> asked_;
    std::vector<trace::FirstHit> seen_;
};

/// Every square of the picture, by all threads. False: cancelled.
bool look(const plan::CompiledScene& scene, const std::vector<Kind>& kinds, const std::vector<std::string>& names,
          const trace::RenderOptions& options, bool antialiased, Rows rows, image::Channels& out)
{
    std::vector<float> ids;
    for (const std::string& name : names) ids.push_back(id_of(name));
    const trace::KernelTable& kernel = trace::load_kernel(options.isa);
    const trace::path::Sources none;
    trace::Workers<trace::PathTracer> workers(
        options, [&] { return kernel.make_paths(scene, none, options.cancel); }, kernel.free_paths);
    const int columns = (out.width + kSide - 1) / kSide, first = rows.first / kSide,
              last = (rows.last + kSide - 1) / kSide;
    return workers.each(
        static_cast<std::size_t>(first), static_cast<std::size_t>(last), [&](std::size_t row, auto& worker) {
            Square square(scene, kinds, ids, antialiased ? kSamples : 1, out);
            for (int column = 0; column < columns; ++column) {
                const int left = column * kSide, top = static_cast<int>(row) * kSide;
                if (!square.make(kernel, *worker.tracer,
                                 {left, top, std::min(kSide, out.width - left), std::min(kSide, out.height - top)}))
                    return false;
            }
            return true;
        });
}

}  // namespace

std::vector<Kind> kinds_of(std::string_view list)
{
    std::vector<Kind> out;
    while (!list.empty()) {
        const std::string_view word = list.substr(0, list.find(','));
        list.remove_prefix(std::min(word.size() + 1, list.size()));
        bool known = false;
        for (const KindName& kind : kKinds) {
            if (word != kind.name && word != "all") continue;
            known = true;
            if (std::find(out.begin(), out.end(), kind.kind) == out.end()) out.push_back(kind.kind);
        }
        if (known) continue;
        std::string all;
        for (const KindName& kind : kKinds) (all += kind.name) += ", ";
        throw std::runtime_error("'" + std::string(word) + "' is no layer; there are " + all + "and all");
    }
    return out;
}

image::Channels layers_of(const std::vector<Kind>& kinds, const std::vector<std::string>& names)
{
    image::Channels out;
    for (const Kind kind : kinds) {
        for (const std::string_view channel : of(kind).channels)
            if (!channel.empty()) out.names.push_back(std::string(of(kind).name) + "." + std::string(channel));
        if (kind != Kind::Object) continue;
        for (std::string& channel : cryptomatte_channels()) out.names.push_back(std::move(channel));
        out.attributes = cryptomatte_attributes(names);
    }
    return out;
}

std::optional<image::Channels> make_layers(const plan::CompiledScene& scene, const std::vector<Kind>& kinds,
                                           const std::vector<std::string>& names, const trace::RenderOptions& options,
                                           bool antialiased, Rows rows)
{
    image::Channels out = layers_of(kinds, names);
    out.width = scene.options.width;
    out.height = scene.options.height;
    out.top = rows.first;
    const std::size_t width = static_cast<std::size_t>(out.width),
                      pixels = width * static_cast<std::size_t>(rows.last - rows.first),
                      before = width * static_cast<std::size_t>(rows.first);
    out.values.assign(out.names.size() * pixels, 0.0f);
    if (!look(scene, kinds, names, options, antialiased, rows, out)) return {};
    const auto time = std::find(out.names.begin(), out.names.end(), "time.ns") - out.names.begin();
    if (time == static_cast<std::ptrdiff_t>(out.names.size())) return out;
    const study::Heat heat = study::measure_heat(scene, options);
    if (heat.ns.empty()) return {};
    for (std::size_t i = 0; i < pixels; ++i)
        out.values[out.names.size() * i + static_cast<std::size_t>(time)] = heat.ns[before + i];
    return out;
}

void add_picture(image::Channels& to, const image::Image& picture, const image::TransferCurve& working)
{
    const std::size_t count = to.names.size(), pixels = picture.pixels.size() / 4;
    std::vector<float> values;
    values.reserve((count + 4) * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* color = &picture.pixels[4 * i];
        for (std::size_t c = 0; c < 3; ++c) values.push_back(working.decode(color[c]));
        values.push_back(1.0f - color[3]);
        values.insert(values.end(), to.values.begin() + static_cast<std::ptrdiff_t>(count * i),
                      to.values.begin() + static_cast<std::ptrdiff_t>(count * (i + 1)));
    }
    to.values = std::move(values);
    to.names.insert(to.names.begin(), {"R", "G", "B", "A"});
}

}  // namespace layers
