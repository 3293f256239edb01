#pragma once

#include "language/names/files.h"
#include "render/app/lsp/answers.h"
#include "render/app/lsp/diagnostics.h"
#include "render/app/rpc/framing.h"
#include "render/app/lsp/reading.h"
#include "render/app/lsp/watch_link.h"

#include <map>
#include <mutex>
#include <optional>
#include <set>

namespace app::lsp {

/// One client: what it has open, what it was told.
///
/// A scene is read whenever a text changes that it reaches. An include file that no open scene reaches is looked at by
/// its tokens alone, for what it needs may be declared by those that include it.
class Server {
public:
    Server(const Settings& settings, const Limits& limits, std::vector<std::string> library_path, Output& output);

    /// Takes a message as it came. False: the client said `exit`.
    bool take(std::string_view message);
    /// Answers what could not be taken.
    void complain(ErrorCode code, const std::string& text);
    /// Of the process: 0 where the client said `shutdown` before.
    bool ended_well() const { return state_ == State::ShutDown; }
    /// The client's process; 0: it did not say.
    int client() const { return client_; }
    void stop() { reader_.stop(); }

private:
    enum class State { New, Running, ShutDown };
    struct OpenText {
        std::string uri;
        json version;
        std::uint64_t asked = 0;  ///< number of its last reading
    };

    void answer(const json& id, const std::string& method, const json& parameters);
    json result_of(const std::string& method, const json& parameters);
    void notice(const std::string& method, const json& parameters);
    json initialize(const json& parameters);
    void did_open(const json& parameters);
    void did_change(const json& parameters);
    void did_close(const json& parameters);
    void tell_cursor(const json& parameters);
    void changed(const std::string& path);
    void read_all();
    void take_reading(Reading&& reading);
    void replace_diagnostics(const std::string& scene, Diagnostics diagnostics);
    void publish(const std::string& path);
    std::string uri_of(const std::string& path) const;
    std::string value_of(const std::string& path, const std::string& name);
    void send(const json& message) { output_.send(text_of(message)); }

    Output& output_;
    std::mutex mutex_;  ///< of all below: the reader's thread brings diagnostics
    State state_ = State::New;
    int client_ = 0;
    language::Files files_;
    World world_;
    std::map<std::string, OpenText> open_;                              ///< by path
    std::map<std::string, Diagnostics> told_;                           ///< by scene
    std::map<std::string, std::map<std::string, std::string>> values_;  ///< by scene, of its last whole reading
    Reader reader_;                                                     ///< ends early
    WatchLink watch_;                                                   ///< ends first
};

}  // namespace app::lsp
