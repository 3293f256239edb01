#include "render/app/watch/event_log.h"

#include <catch2/catch.hpp>

#include <utility>

using app::EventLog;
using Kind = app::EventLog::Kind;

namespace {

/// What a page that opens now is told, the events' data without the rest.
std::string told(EventLog& log)
{
    std::string events, out;
    std::uint64_t position = 0;
    log.read(position, events);
    for (std::size_t at = 0; (at = events.find("data: ", at)) != std::string::npos;) {
        at += 6;
        out += (out.empty() ? "" : " ") + events.substr(at, events.find('\n', at) - at);
    }
    return out;
}

}  // namespace

TEST_CASE("a page that opens now is told a picture's blocks with the scene that they are of", "[watch]")
{
    EventLog log;
    log.push(Kind::Text, "text1", 1);
    log.push(Kind::Scene, "scene1", 1);
    log.push(Kind::Block, "coarse1", 1, 0);
    log.push(Kind::Block, "fine1", 1, 1);
    CHECK(told(log) == "text1 scene1 coarse1 fine1");
    log.passed(1, 1);
    CHECK(told(log) == "text1 scene1 fine1");

    // A newer text and its scene, of which there is no block yet: the picture before stays, and so does its scene.
    log.push(Kind::Text, "text2", 2);
    log.push(Kind::Scene, "scene2", 2);
    CHECK(told(log) == "scene1 fine1 text2 scene2");
    log.push(Kind::Scene, "scene3", 3);
    CHECK(told(log) == "scene1 fine1 text2 scene3");
    log.push(Kind::Block, "coarse3", 3, 0);
    CHECK(told(log) == "text2 scene3 coarse3");
    log.push(Kind::Block, "late1", 1, 1);  // of a picture that was cancelled
    CHECK(told(log) == "text2 scene3 coarse3");
}
