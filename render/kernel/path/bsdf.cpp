#include "render/kernel/path/bsdf.h"

#include "numbers/functions/functions.h"
#include "render/kernel/path/directions.h"

#include <algorithm>
#include <numbers>

namespace trace::path {
namespace {

float largest_of(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

}  // namespace

void Bsdf::finish()
{
    glm::vec3 all(0);
    for (std::size_t i = 0; i < count_; ++i) all += lobes_[i].albedo;
    const float most = largest_of(all);
    const float scale = most > 1.0f ? 1.0f / most : 1.0f;
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
        lobes_[i].color *= scale;
        lobes_[i].albedo *= scale;
        sum += chances_[i] = std::max(0.0f, largest_of(lobes_[i].albedo));
    }
    spread_ = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
        chances_[i] = sum > 0.0 ? chances_[i] / sum : 0.0;
        if (!lobes_[i].delta()) spread_ += chances_[i];
    }
}

glm::vec3 Bsdf::albedo() const
{
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < count_; ++i)
        if (!lobes_[i].delta()) sum += lobes_[i].albedo;
    return sum;
}

Response Bsdf::respond(const Lobe& lobe, const glm::dvec3& l) const
{
    const double facing = glm::dot(lobe.normal, l);
    // Light of the other side of the surface itself is no light of this side, however a layer bends its normal.
    if (!(facing > 0.0) || glm::dot(facing_, l) * glm::dot(facing_, lobe.normal) <= 0.0) return {};
    if (lobe.kind == Lobe::Kind::Diffuse) {
        const double power = lobe.exponent == 1.0 ? facing : numbers::pow(facing, lobe.exponent);
        return {static_cast<float>(power / kPi) * lobe.color, (lobe.exponent + 1.0) / (2.0 * kPi) * power};
    }
    glm::vec3 color = lobe.color;
    if (lobe.finish->metallic > 0.0f) {
        const bool by_half = lobe.finish->tint_by_half && lobe.kind != Lobe::Kind::Phong;
        const double cosine = by_half ? texture::halfway_cosine(direction_, l) : facing;
        color *= texture::metallic_tint(lobe.finish->metallic, cosine, lobe.pigment);
    }
    if (lobe.kind == Lobe::Kind::Phong) {
        const double c = texture::phong_cosine(direction_, lobe.normal, l);
        if (!(c > 0.0)) return {};
        const double power = numbers::pow(c, lobe.exponent);
        return {static_cast<float>(power / kPi) * color, (lobe.exponent + 1.0) / (2.0 * kPi) * power};
    }
    const glm::dvec3 half = glm::normalize(l - direction_);
    const double c = glm::dot(half, lobe.normal), along = -glm::dot(half, direction_);
    if (!(c > 0.0) || !(along > 1e-9)) return {};
    const double power = numbers::pow(c, lobe.exponent);
    return {static_cast<float>(power / kPi) * color, (lobe.exponent + 1.0) / (2.0 * kPi) * power / (4.0 * along)};
}

Response Bsdf::respond(const glm::dvec3& l) const
{
    Response sum;
    for (std::size_t i = 0; i < count_; ++i) {
        if (lobes_[i].delta()) continue;
        const Response one = respond(lobes_[i], l);
        sum.value += one.value;
        sum.pdf += chances_[i] * one.pdf;
    }
    return sum;
}

glm::vec3 Bsdf::respond_diffuse(const glm::dvec3& l) const
{
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < count_; ++i)
        if (lobes_[i].kind == Lobe::Kind::Diffuse) sum += respond(lobes_[i], l).value;
    return sum;
}

glm::dvec3 Bsdf::direction_of(const Lobe& lobe, Draws& draws) const
{
    const auto u = draws.pair();
    if (lobe.kind == Lobe::Kind::Diffuse) return power_direction(lobe.normal, lobe.exponent, u);
    if (lobe.kind == Lobe::Kind::Phong)
        return power_direction(direction_ - 2.0 * glm::dot(direction_, lobe.normal) * lobe.normal, lobe.exponent, u);
    const glm::dvec3 half = power_direction(lobe.normal, lobe.exponent, u);
    return glm::normalize(direction_ - 2.0 * glm::dot(direction_, half) * half);
}

Scattered Bsdf::sample(Draws& draws) const
{
    double u = draws.one();
    std::size_t chosen = kMost;
    for (std::size_t i = 0; i < count_; ++i) {
        if (!(chances_[i] > 0.0)) continue;
        chosen = i;
        if (u < chances_[i]) break;
        u -= chances_[i];
    }
    Scattered out;
    if (chosen == kMost) return out;
    const Lobe& lobe = lobes_[chosen];
    if (lobe.delta()) {
        out.lobe = &lobe;
        out.weight = lobe.color / static_cast<float>(chances_[chosen]);
        return out;
    }
    out.direction = direction_of(lobe, draws);
    const Response all = respond(out.direction);
    if (!(all.pdf > 0.0)) return out;
    out.lobe = &lobe;
    out.pdf = all.pdf;
    out.weight = all.value / static_cast<float>(all.pdf);
    return out;
}

}  // namespace trace::path
