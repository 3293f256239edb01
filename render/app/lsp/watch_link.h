#pragma once

#include "render/app/link/mailbox.h"
#include "render/app/lsp/answers.h"

#include <functional>
#include <mutex>

namespace app::lsp {

/// The way from an editor to the pages of `whittle watch` and back: where the cursor is, a line to show, a number to
/// write.
class WatchLink {
public:
    /// \param world  what is open; the mutex guards it
    /// \param send  to the client
    WatchLink(World& world, std::mutex& mutex, std::function<void(const json&)> send);

    /// What the client can do, of `initialize`.
    void set_client(const json& parameters);
    /// Tells pages of that text where its cursor is. The mutex is held.
    void cursor(const std::string& path, std::uint32_t offset) const;

private:
    void take(const std::string& text, const std::string& from);
    bool show(const json& wanted);
    bool edit(const json& wanted);
    bool concerns(const std::string& path) const;
    void ask(const char* method, json parameters);

    World& world_;
    std::mutex& mutex_;
    std::function<void(const json&)> send_;
    bool shows_ = false, edits_ = false;
    std::uint64_t asked_ = 0;
    Mailbox mailbox_;  ///< last: it calls
};

}  // namespace app::lsp
