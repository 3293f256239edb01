#pragma once

#include <cstdint>

namespace csg {

/// A cut along one ray: where it begins and ends, and which ends of which leaf these are (LeafEnd::code).
struct CutPiece {
    double in, out, in_code, out_code;
};

/// The cuts from last - 1 on that hang together: up to `last`; the one that ends last is `longest`. False where ends
/// coincide that decide what is drawn.
/// \param cuts  by entry
/// \param close  whether two places are the same
template <class Close>
inline bool run_of_cuts(const CutPiece* cuts, std::uint32_t count, std::uint32_t& last, std::uint32_t& longest,
                        const Close& close)
{
    if (last < count && close(cuts[last].in, cuts[last - 1].in)) return false;
    bool tied = false;
    for (; last < count; ++last) {
        const double until = cuts[longest].out;
        if (close(cuts[last].in, until)) return false;
        if (cuts[last].in > until) break;
        const bool same = close(cuts[last].out, until);
        if (cuts[last].out > until) {
            longest = last;
            tied = same;
        } else {
            tied = tied || same;
        }
    }
    return !tied;
}

}  // namespace csg
