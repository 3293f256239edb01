#pragma once

#include "parser/parse.h"
#include "render/app/frames/frames.h"
#include "render/app/report/report.h"
#include "render/app/report/streams.h"
#include "render/app/frames/window.h"

#include <memory>
#include <string>

namespace app {

/// What is about to be done.
struct FrameFacts {
    const Settings& settings;
    const FrameList& list;
    const Frame& frame;
    std::string scene;    ///< file
    std::string picture;  ///< file; empty: standard output or none
    Window window;
};

/// What a run that ended early leaves: files, or empty.
struct Kept {
    std::string state;    ///< the finished part, for +C
    std::string picture;  ///< the same to look at
};

/// Tells of a run as it goes, in the words of the program's name: Whittle's own, or for a program that calls `povray`
/// the lines that such programs look for.
class ConsoleReporter {
public:
    explicit ConsoleReporter(Streams& streams) : streams_(streams) {}
    ConsoleReporter(const ConsoleReporter&) = delete;
    ConsoleReporter& operator=(const ConsoleReporter&) = delete;
    virtual ~ConsoleReporter() = default;

    virtual void begin(const FrameFacts& facts) = 0;
    virtual void message(const scene::Message& message) = 0;
    /// From the fifth second of reading on, some times a second.
    virtual void still_reading(const parser::ReadingPlace& where, double seconds) = 0;
    virtual void parsed(const parser::Result& result, const StageTimes& times) = 0;
    virtual void made_from(const std::string&) {}  ///< the picture's fingerprint
    virtual void rendering() = 0;
    virtual void pass(const std::string& name) = 0;  ///< one of several passes of a picture begins, at 0
    virtual void progress(double share) = 0;         ///< of the pass, in [0, 1]; from any thread
    virtual void rendered(const StageTimes& times, const trace::RenderStatistics& statistics) = 0;
    virtual void written(const std::string& path) = 0;
    virtual void skipped(const std::string& path) = 0;  ///< +C: it is there already
    virtual void note(const std::string& text) = 0;
    virtual void cancelled(const Kept& kept) = 0;
    virtual void failed(const std::vector<scene::Message>& errors) = 0;  ///< what ends the run; at least one
    virtual void finished() = 0;                                         ///< all frames done

protected:
    void put(Stream stream, std::string_view text) { streams_.put(stream, text); }
    bool terminal() const { return streams_.terminal(); }

private:
    Streams& streams_;
};

/// The reporter in the words that the settings ask for (--console, or the program's name).
std::unique_ptr<ConsoleReporter> make_reporter(const Settings& settings, Streams& streams);

/// Reports an error of the options, which comes before there is a reporter.
/// \param command_line  as it was given
void tell_option_error(ConsoleStyle style, const std::string& command_line, const std::string& text);

}  // namespace app
