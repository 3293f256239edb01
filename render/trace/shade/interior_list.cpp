#include "render/trace/queue/ray_state.h"

namespace trace {

void InteriorList::remove_first(std::uint32_t interior)
{
    for (std::size_t i = 0; i < head_.count; ++i) {
        if (items_[i] != interior) continue;
        for (std::size_t k = i + 1; k < head_.count; ++k) items_[k - 1] = items_[k];
        --head_.count;
        return;
    }
}

bool InteriorList::holds(std::uint32_t interior) const
{
    for (std::size_t i = 0; i < head_.count; ++i)
        if (items_[i] == interior) return true;
    return false;
}

bool InteriorList::all_hollow(const std::vector<plan::Interior>& interiors) const
{
    if (head_.clouded != 0) return false;
    for (std::size_t i = 0; i < head_.count; ++i)
        if (!interiors[items_[i]].hollow) return false;
    return true;
}

}  // namespace trace
