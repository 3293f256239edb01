#include "render/app/frames/window.h"

#include "render/app/options/command_line.h"

#include <catch2/catch.hpp>

using namespace app;

namespace {

std::vector<int> window(const std::vector<std::string>& arguments)
{
    Settings settings;
    apply_command_line(settings, {"+W8", "+H8"});
    apply_command_line(settings, arguments);
    const Window w = window_of(settings);
    return {w.first_column, w.last_column, w.first_row, w.last_row};
}

using Limits = std::vector<int>;

}  // namespace

TEST_CASE("part of a picture, in columns and rows or in shares", "[app][window]")
{
    CHECK(window({}) == Limits{0, 7, 0, 7});
    CHECK(window({"+SC3", "+EC5", "+SR2", "+ER4"}) == Limits{2, 4, 1, 3});
    CHECK(window({"+SC2.7", "+EC5.9"}) == Limits{1, 4, 0, 7});
    CHECK(window({"+EC1"}) == Limits{0, 7, 0, 7});
    CHECK(window({"Start_Row=0.999"}) == Limits{0, 7, 7, 7});
    CHECK(window({"+ER0.99"}) == Limits{0, 7, 0, 6});
}

TEST_CASE("a window that leaves the picture is an error", "[app][window]")
{
    CHECK_THROWS_WITH(window({"+EC9"}), "invalid end column");
    CHECK_THROWS_WITH(window({"+ER0"}), "invalid end row");
    CHECK_THROWS_WITH(window({"+SC9"}), "invalid start column");
    CHECK_THROWS_WITH(window({"+SC1e39"}), "invalid start column");
    CHECK_THROWS_WITH(window({"+ER3e9"}), "invalid end row");
    CHECK_THROWS_WITH(window({"+SR6", "+ER3"}), "nothing to render: the first row, 6, stands behind the last, 3");
    CHECK_THROWS_WITH(window({"+SC0.5", "+EC0.25"}),
                      "nothing to render: the first column, 5, stands behind the last, 2");
    CHECK(window({"+SR3", "+ER3"}) == Limits{0, 7, 2, 2});
}
