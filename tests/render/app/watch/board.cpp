#include "render/app/watch/board.h"

#include <catch2/catch.hpp>

#include <utility>

using app::Board;
using Kind = app::Board::Kind;

namespace {

/// What a page that opens now is told, the events' data without the rest.
std::string told(Board& board)
{
    std::string events, out;
    std::uint64_t position = 0;
    board.read(position, events);
    for (std::size_t at = 0; (at = events.find("data: ", at)) != std::string::npos;) {
        at += 6;
        out += (out.empty() ? "" : " ") + events.substr(at, events.find('\n', at) - at);
    }
    return out;
}

}  // namespace

TEST_CASE("a page that opens now is told a picture's blocks with the scene that they are of", "[watch]")
{
    Board board;
    board.push(Kind::Text, "text1", 1);
    board.push(Kind::Scene, "scene1", 1);
    board.push(Kind::Block, "coarse1", 1, 0);
    board.push(Kind::Block, "fine1", 1, 1);
    CHECK(told(board) == "text1 scene1 coarse1 fine1");
    board.passed(1, 1);
    CHECK(told(board) == "text1 scene1 fine1");

    // A newer text and its scene, of which there is no block yet: the picture before stays, and so does its scene.
    board.push(Kind::Text, "text2", 2);
    board.push(Kind::Scene, "scene2", 2);
    CHECK(told(board) == "scene1 fine1 text2 scene2");
    board.push(Kind::Scene, "scene3", 3);
    CHECK(told(board) == "scene1 fine1 text2 scene3");
    board.push(Kind::Block, "coarse3", 3, 0);
    CHECK(told(board) == "text2 scene3 coarse3");
    board.push(Kind::Block, "late1", 1, 1);  // of a picture that was cancelled
    CHECK(told(board) == "text2 scene3 coarse3");
}
