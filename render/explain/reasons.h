#pragma once

#include "render/explain/place_names.h"
#include "render/kernel/record/record.h"

/// Why something gives nothing, or less than it has: words of an explanation.
namespace explain {

/// Of a lamp for a layer, to which it gives something or not; empty: all of it arrives.
std::string why_dim(const plan::CompiledScene& scene, const PlaceNames& names, const trace::RecordedRay& hit,
                    const trace::RecordedRow& row, std::size_t lamp, bool gives);

/// Of a ray of this weight, below 0: not known, that was not sent on from a hit.
std::string why_cut(const plan::CompiledScene& scene, const trace::RecordedRay& hit, float weight);

/// The weight of the ray off the n-th mirror of a node, where its layers tell which it is.
float mirror_weight(const trace::Record& record, const trace::ShadeNode& node, std::uint32_t n);

}  // namespace explain
