#include "csg/solids/solid.h"

#include <stdexcept>

namespace csg {

PartId SolidStore::add(const Solid& solid, SurfaceId surface)
{
    return std::visit(
        [&]<class T>(const T& own) {
            auto& all_of_kind = std::get<std::vector<T>>(solids_);
            if (all_of_kind.size() + 1 >= kMaxPartsOfKind) throw std::length_error("too many solids of one kind");
            all_of_kind.push_back(own);
            surfaces_[solid.index()].push_back(surface);
            return make_part(static_cast<SolidKind>(solid.index()), static_cast<std::uint32_t>(all_of_kind.size() - 1));
        },
        solid);
}

Solid SolidStore::get(PartId part) const
{
    return with_solid(*this, part, [](const auto& solid) -> Solid { return solid; });
}

}  // namespace csg
