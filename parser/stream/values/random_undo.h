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
        for (; old_.size() > first_; old_.pop_back())
            streams_[static_cast<std::size_t>(old_.back().index)] = old_.back().state;
        return false;
    }
    /// What was drawn stays drawn, unless there is a Hold.
    void keep()
    {
        if (held_) first_ = old_.size();
        else old_.clear();
    }
    /// Something is read in the midst of what may be given up: whatever becomes of it, what was drawn before and since
    /// can be set back when this is gone.
    class Hold {
    public:
        explicit Hold(RandomUndo& undo) : undo_(undo), first_(undo.first_), held_(undo.held_)
        {
            undo.first_ = undo.old_.size();
            undo.held_ = true;
        }
        Hold(const Hold&) = delete;
        Hold& operator=(const Hold&) = delete;
        ~Hold()
        {
            undo_.first_ = first_;
            undo_.held_ = held_;
        }

    private:
        RandomUndo& undo_;
        std::size_t first_;
        bool held_;
    };

private:
    struct Old {
        std::int32_t index;
        std::uint32_t state;
    };
    std::vector<std::uint32_t>& streams_;
    std::vector<Old> old_;
    std::size_t first_ = 0;  ///< of those that are set back
    bool held_ = false;
};

}  // namespace parser
