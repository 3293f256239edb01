#pragma once

#include "render/kernel/antialias/antialias.h"

/// What the methods of antialiasing are made of.
namespace trace {

inline constexpr std::uint32_t kNoPlace = 0xffffffffu;

/// Sums are kept in single precision after each step, as POV-Ray does.
inline void add(scene::Color& sum, const scene::Color& c)
{
    sum.red += c.red;
    sum.green += c.green;
    sum.blue += c.blue;
    sum.filter += c.filter;
    sum.transmit += c.transmit;
}

inline scene::Color divided(const scene::Color& sum, double by)
{
    const auto part = [by](float v) { return static_cast<float>(static_cast<double>(v) / by); };
    return {part(sum.red), part(sum.green), part(sum.blue), part(sum.filter), part(sum.transmit)};
}

/// The methods for a block; `antialias()` chooses.
void antialias_1(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out);
void antialias_2(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out);
void antialias_3(const plan::Antialiasing& settings, const ColorDistance& distance, const Block& block,
                 const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out);

}  // namespace trace
