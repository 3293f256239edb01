#pragma once

#include <cstdint>
#include <vector>

namespace parser {

std::int32_t to_int32(double value);  // operand.h

/// Streams of random numbers are set back where a list stops halfway.
class RandomUndo {
public:
    explicit RandomUndo(std::vector<std::uint32_t>& streams) : streams_(streams) {}
    bool draw(double index, double& out)
    {
        const std::int32_t i = to_int32(index);
        if (i < 0 || static_cast<std::size_t>(i) >= streams_.size()) return false;
        std::uint32_t& s = streams_[static_cast<std::size_t>(i)];
        old_.push_back({i, s});
        s = 1812433253u * s + 12345u;
        out = s / 4294967295.0;
        return true;
    }
    /// Sets all back; false.
    bool give_up()
    {
        for (; !old_.empty(); old_.pop_back())
            streams_[static_cast<std::size_t>(old_.back().index)] = old_.back().state;
        return false;
    }
    void keep() { old_.clear(); }  ///< what was drawn stays drawn

private:
    struct Old {
        std::int32_t index;
        std::uint32_t state;
    };
    std::vector<std::uint32_t>& streams_;
    std::vector<Old> old_;
};

}  // namespace parser
