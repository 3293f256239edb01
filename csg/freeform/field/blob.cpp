#include "csg/freeform/field/blob.h"

#include "csg/freeform/shared/similarity.h"
#include "csg/base/hit.h"
#include "csg/solids/shared/common.h"
#include "numbers/functions/functions.h"

namespace csg {
namespace {

constexpr double kLeastThreshold =
    1e-12;                      // at 0 POV-Ray has all of space inside but what negative components take away
constexpr double kSkin = 1e-6;  // POV-Ray's inside reaches so far below the threshold (spec 5a, 2.4)

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The cube around a sphere that POV-Ray takes for the extent (spec 5a, 7.2). `alone`: the component is a sphere, which
/// stays one where it is turned or scaled evenly.
Aabb extent_of(const Transform& frame, const glm::dvec3& center, double radius, bool alone)
{
    const glm::dvec3 c = frame.point(center);
    double reach = std::abs(radius), factor = 1.0;
    if (alone && keeps_spheres(frame.linear, factor)) {
        reach *= factor;
    } else {
        double widest = 0.0;
        for (int row = 0; row < 3; ++row)
            widest = std::max(widest, std::abs(frame.linear[0][row]) + std::abs(frame.linear[1][row]) +
                                          std::abs(frame.linear[2][row]));
        reach = std::sqrt(reach * reach * widest * widest + 1e-10);
    }
    return {c - reach, c + reach};
}

}  // namespace

Blob::Blob(double threshold, const std::vector<Component>& components)
    : threshold_(std::abs(threshold) < kLeastThreshold ? -kLeastThreshold : threshold)
{
    fields_.reserve(components.size());
    boxes_.reserve(components.size());
    for (const Component& component : components) {
        add(component);
        if (!(component.strength > 0.0)) continue;
        const glm::dvec3 half(0.0, 0.0, 0.5 * component.length);
        if (component.length > 0.0) {
            extent_.include(extent_of(component.frame, half, numbers::hypot(component.radius, half.z), false));
            extent_.include(extent_of(component.frame, 2.0 * half, component.radius, false));
        }
        extent_.include(extent_of(component.frame, glm::dvec3(0.0), component.radius, component.length == 0.0));
    }
    bound();
}

void Blob::add(const Component& component)
{
    const double r = std::abs(component.radius);
    if (!(std::abs(component.strength) > 0.0) || !std::isfinite(component.strength) || !(r > 0.0) || !std::isfinite(r))
        return;
    const Transform unit = component.frame * Transform::scale(glm::dvec3(r));
    Field field{unit.inverse_linear,
                unit.inverse_offset,
                component.length / r,
                component.strength,
                component.part,
                {},
                0.0,
                false};
    Aabb box = ellipsoid_box(unit.linear, unit.offset);
    box.include(ellipsoid_box(unit.linear, unit.point({0.0, 0.0, field.length})));
    const bool sound = finite(field.to_unit[0]) && finite(field.to_unit[1]) && finite(field.to_unit[2]) &&
                       finite(field.offset);
    if (!sound || !box.finite()) return;
    double factor = 1.0;
    field.is_sphere = component.length == 0.0 && keeps_spheres(component.frame.linear, factor);
    const glm::dvec3 half = 0.5 * (box.upper - box.lower);
    field.middle = field.is_sphere ? unit.offset : 0.5 * (box.lower + box.upper);
    field.reach2 = field.is_sphere ? r * r * factor * factor : glm::dot(half, half);
    if (const std::size_t i = fields_.size(); i < kMostLoose) {
        loose_.x[i] = field.middle.x;
        loose_.y[i] = field.middle.y;
        loose_.z[i] = field.middle.z;
        loose_.reach2[i] = field.reach2;
    }
    fields_.push_back(field);
    boxes_.push_back(padded(box));
}

void Blob::bound()
{
    for (std::size_t i = 0; i < fields_.size(); ++i)
        if (fields_[i].strength > 0.0) box_.include(boxes_[i]);
    if (!std::isfinite(threshold_)) box_ = {};
    if (box_.empty()) return;
    middle_ = 0.5 * (box_.lower + box_.upper);
    if (fields_.size() <= kMostLoose) return;
    std::vector<BvhInput> inputs;
    inputs.reserve(fields_.size());
    for (std::size_t i = 0; i < fields_.size(); ++i)
        inputs.push_back({.bounds = boxes_[i], .index = static_cast<std::uint32_t>(i)});
    tree_ = build_bvh(std::move(inputs));
}

/// f(field, arm, 1 - q) for every component whose field reaches p.
template <class F>
void Blob::each_near(const glm::dvec3& p, F&& f) const
{
    const auto ask = [&](const Field& field) {
        const glm::dvec3 arm = field.arm(p);
        const double w = 1.0 - glm::dot(arm, arm);
        if (w > 0.0) f(field, arm, w);
    };
    if (tree_.nodes.empty()) {
        for (const Field& field : fields_) ask(field);
        return;
    }
    std::uint32_t stack[kBvhStack];
    int top = 0;
    stack[top++] = 0;
    const glm::vec3 q(p);
    const glm::vec3 slack = glm::abs(q) * 2.4e-7f;  // of the conversion; the boxes are rounded outward themselves
    while (top > 0) {
        const BvhNode& node = tree_.nodes[stack[--top]];
        for (std::size_t k = 0; k < 8; ++k) {
            bool in = true;
            for (int axis = 0; axis < 3; ++axis)
                in = in && q[axis] + slack[axis] >= node.bounds[axis][k] &&
                     q[axis] - slack[axis] <= node.bounds[axis + 3][k];
            if (!in) continue;
            if (node.child[k].is_leaf()) ask(fields_[node.child[k].index()]);
            else stack[top++] = node.child[k].index();
        }
    }
}

double Blob::field(const glm::dvec3& p) const
{
    double sum = 0.0;
    each_near(p, [&](const Field& field, const glm::dvec3&, double w) { sum += field.strength * w * w; });
    return sum;
}

void Blob::fields(const double* x, const double* y, const double* z, std::size_t count, double* out) const
{
    using lanes::Double;
    if (!tree_.nodes.empty()) {
        for (std::size_t i = 0; i < count; ++i) out[i] = field({x[i], y[i], z[i]});
        return;
    }
    const Double zero(0.0), one(1.0);
    for (std::size_t i = 0; i < count; i += lanes::kDoubles) {
        const lanes::Points p{Double::load_aligned(x + i), Double::load_aligned(y + i), Double::load_aligned(z + i)};
        Double sum = zero;
        for (const Field& field : fields_) {
            const auto u = field.unit(p);
            const Double beyond = u.z - lanes::smaller(lanes::larger(u.z, zero), Double(field.length)),
                         w = one - (u.x * u.x + u.y * u.y + beyond * beyond);
            sum = sum + lanes::choose(w > zero, Double(field.strength) * w * w, zero);
        }
        sum.store_aligned(out + i);
    }
}

bool Blob::contains(const glm::dvec3& p) const { return field(p) > threshold_ - kSkin; }

glm::dvec3 Blob::gradient(const glm::dvec3& p, std::uint32_t) const
{
    glm::dvec3 sum(0.0);
    each_near(p, [&](const Field& field, const glm::dvec3& arm, double w) {
        sum += field.strength * w * (glm::transpose(field.to_unit) * arm);
    });
    return sum;
}

void Blob::shares(const glm::dvec3& p, std::vector<Share>& out) const
{
    const std::size_t first = out.size();
    double sum = 0.0;
    each_near(p, [&](const Field& field, const glm::dvec3&, double w) {
        const double weight = std::abs(field.strength) * w * w;
        sum += weight;
        std::size_t k = first;
        while (k < out.size() && out[k].part != field.part) ++k;
        if (k == out.size()) out.push_back({field.part, 0.0f});
        out[k].weight += static_cast<float>(weight);
    });
    for (std::size_t k = first; k < out.size(); ++k) out[k].weight /= static_cast<float>(sum);
}

}  // namespace csg
