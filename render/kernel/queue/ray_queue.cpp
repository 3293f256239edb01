#include "render/kernel/queue/ray_queue.h"

#include "numbers/functions/functions.h"
#include "render/texture/evaluate.h"
#include "render/kernel/tile/air.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// texture::mix, but where both are infinite (highlights on long normals) that is infinite too, as with POV-Ray: white.
scene::Color mixed(const scene::Color& lower, const scene::Color& upper, double share)
{
    scene::Color out = texture::mix(lower, upper, share);
    for (float scene::Color::*of : {&scene::Color::red, &scene::Color::green, &scene::Color::blue})
        if (std::isinf(lower.*of) && lower.*of == upper.*of) out.*of = lower.*of;
    return out;
}

/// Colours and nodes at hand while a tile's are folded.
struct Folding {
    const RayQueue& queue;

    scene::Color at(ColorSlot slot) const { return slot == kNoSlot ? scene::Color() : queue.colors[slot]; }
    const ShadeTerm* begin(const ShadeNode& node) const { return queue.terms.data() + node.first; }
    const ShadeTerm* end(const ShadeNode& node) const { return begin(node) + node.count; }

    scene::Color surface(const ShadeNode& node) const
    {
        glm::vec3 sum = node.own;
        float transmit = 0.0f;
        if (node.through != kNoSlot) {
            const scene::Color seen = at(node.through);
            const glm::vec3 behind = seen.rgb() * node.film * node.fade;
            sum += node.total ? behind : behind * node.filter;
            if (!node.total) transmit = seen.transmit * scene::grey(node.fade) * node.residual;
        }
        for (const ShadeTerm* term = begin(node); term != end(node); ++term) {
            const scene::Color seen = at(term->slot);
            sum += term->factor * raised(scene::Color::of(seen.rgb() * term->film), term->power);
        }
        scene::Color out = scene::Color::of(sum);
        out.transmit = transmit;
        return out;
    }

    scene::Color sum(const ShadeNode& node) const
    {
        scene::Color sum;
        for (const ShadeTerm* term = begin(node); term != end(node); ++term) {
            const scene::Color c = at(term->slot);
            const float w = term->factor.x;
            sum = {sum.red + w * c.red, sum.green + w * c.green, sum.blue + w * c.blue, sum.filter + w * c.filter,
                   sum.transmit + w * c.transmit};
        }
        return sum;
    }

    scene::Color mean(const ShadeNode& node) const
    {
        const scene::Color c = sum(node);
        return {c.red / node.weights, c.green / node.weights, c.blue / node.weights, c.filter / node.weights,
                c.transmit / node.weights};
    }

    scene::Color spectrum(const ShadeNode& node) const
    {
        glm::vec3 sum(0);
        for (const ShadeTerm* term = begin(node); term != end(node); ++term)
            sum += at(term->slot).rgb() * term->film * term->factor;
        return scene::Color::of(sum / static_cast<float>(node.count));
    }

    scene::Color color(const ShadeNode& node) const
    {
        switch (node.kind) {
        case ShadeNode::Kind::Surface: return surface(node);
        case ShadeNode::Kind::Mix: return mixed(at(node.through), at(begin(node)->slot), node.share);
        case ShadeNode::Kind::Sum: return sum(node);
        case ShadeNode::Kind::Mean: return mean(node);
        case ShadeNode::Kind::Spectrum: return spectrum(node);
        case ShadeNode::Kind::Air: break;
        }
        return Air{node.filter, node.own, node.residual}(at(node.through));
    }
};

}  // namespace

void RayQueue::start(std::size_t camera_rays)
{
    rays.clear();
    mirrors.clear();
    batches_.clear();
    nodes.clear();
    terms.clear();
    frames_.clear();
    colors.resize(camera_rays);
}

ShadeNode& RayQueue::new_node(ShadeNode::Kind kind, ColorSlot out)
{
    ShadeNode& node = nodes.emplace_back();
    node.kind = kind;
    node.out = out;
    return node;
}

std::uint32_t RayQueue::new_terms(std::size_t count)
{
    const auto first = static_cast<std::uint32_t>(terms.size());
    terms.resize(terms.size() + count, ShadeTerm{kNoSlot, glm::vec3(0)});
    return first;
}

void RayQueue::begin_tile()
{
    frames_.push_back({rays.size(), mirrors.size(), nodes.size(), terms.size(), colors.size()});
}

void RayQueue::end_tile()
{
    const Frame& frame = frames_.back();
    if (rays.size() > frame.rays) batches_.push_back({&rays, frame.rays, rays.size() - frame.rays});
    if (mirrors.size() > frame.mirrors) batches_.push_back({&mirrors, frame.mirrors, mirrors.size() - frame.mirrors});
}

void RayQueue::fold()
{
    const Folding folding{*this};
    for (; !frames_.empty(); frames_.pop_back()) {
        const Frame& frame = frames_.back();
        if (rays.size() > frame.rays || mirrors.size() > frame.mirrors) return;
        for (std::size_t i = nodes.size(); i-- > frame.nodes;) colors[nodes[i].out] = folding.color(nodes[i]);
        nodes.resize(frame.nodes);
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(frame.terms), terms.end());
        colors.resize(frame.colors);
    }
}

glm::vec3 raised(const scene::Color& c, float exponent)
{
    if (exponent == 1.0f) return c.rgb();
    const auto one = [e = static_cast<double>(exponent)](float v) {
        const double r = numbers::pow(static_cast<double>(v), e);
        return r == r ? static_cast<float>(r) : 0.0f;  // fractional powers of negative colours count as 0
    };
    return {one(c.red), one(c.green), one(c.blue)};
}

}  // namespace trace
