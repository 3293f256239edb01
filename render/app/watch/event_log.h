#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace app {

/// What pages are told, as server-sent events, kept as long as a page that opens now needs it. Any thread may use it.
class EventLog {
public:
    /// Of each the last one counts, but for blocks, which add up to a picture, and the scene that these are of.
    enum class Kind { Text, Scene, Controls, Messages, Block, Progress, Done, Compared, Focus };

    /// \param json  of one line
    /// \param pass  of a block, larger ones finer
    void push(Kind kind, const std::string& json, int generation = 0, int pass = 0);
    /// A pass of a picture is complete: blocks of the coarser ones below it say nothing more.
    void passed(int generation, int pass);
    /// Waits up to a second for events behind `position`, moves it, appends them. False: closed.
    bool read(std::uint64_t& position, std::string& out);
    void close();
    std::size_t bytes() const;  ///< that are kept

private:
    struct Entry {
        Kind kind;
        int generation, pass;
        std::shared_ptr<const std::string> text;
    };
    using Entries = std::map<std::uint64_t, Entry>;
    template <class Test>
    void drop(Test&& test);

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Entries entries_;  ///< by number
    std::uint64_t last_ = 0;
    std::size_t bytes_ = 0;
    int shown_ = 0;  ///< generation of the blocks
    bool closed_ = false;
};

}  // namespace app
