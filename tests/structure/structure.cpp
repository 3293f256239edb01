#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// For each folder of sources the folders whose headers it may include, itself excepted. A folder that is not listed
/// here belongs to the nearest one above it that is.
const std::map<std::string, std::set<std::string>> kMayUse = {
    {"csg", {}},
    {"function", {"csg"}},
    // parse.h holds the options and messages that the sub-folders use as well, parse.cpp puts the sub-folders together.
    {"parser", {"csg", "function", "parser/grammar", "parser/lexer", "parser/stream", "render/scene"}},
    {"parser/lexer", {"render/scene"}},
    {"parser/stream", {"csg", "function", "parser/lexer", "parser", "render/scene"}},
    {"parser/grammar",
     {"csg", "function", "parser/lexer", "parser/stream", "parser", "render/scene", "render/font", "render/image"}},
    {"language/format", {"parser/lexer"}},
    {"language/names", {"parser/lexer", "render/scene"}},
    {"language/places", {"language/names", "parser/lexer"}},
    // Pictures that a scene reads: image knows nothing of scenes, and is what comes last as well as what comes in.
    {"render/scene", {"csg", "function", "render/image"}},
    {"render/font", {"csg"}},
    {"render/image", {}},
    {"render/texture", {"csg", "function", "render/scene"}},
    {"render/light", {"csg", "function", "render/scene", "render/texture"}},
    {"render/plan", {"csg", "function", "render/scene", "render/texture", "render/light", "render/image"}},
    {"render/lint", {"csg", "parser", "parser/lexer", "parser/stream", "render/scene", "render/plan"}},
    {"render/kernel", {"csg", "function", "render/scene", "render/texture", "render/light", "render/plan"}},
    {"render/picture",
     {"csg", "function", "render/scene", "render/texture", "render/light", "render/plan", "render/image",
      "render/kernel"}},
    {"render/study",
     {"csg", "function", "render/scene", "render/texture", "render/light", "render/plan", "render/image",
      "render/kernel", "render/picture"}},
    {"render/layers",
     {"csg", "render/scene", "render/plan", "render/image", "render/kernel", "render/picture", "render/study"}},
    {"render/solid", {"csg", "function", "render/scene", "render/plan"}},
    {"render/explain",
     {"csg", "function", "render/scene", "render/texture", "render/light", "render/plan", "render/image",
      "render/kernel", "render/picture"}},
    {"render/web", {}},  // a module: it knows of no scene
    // What people call by name: it puts the stages together, and finds a scene's constants among its tokens.
    // clang-format off: one a line
    {"render/app",
     {"csg", "function", "language/format", "language/names", "language/places", "parser", "parser/lexer",
      "render/scene", "render/image", "render/plan", "render/kernel", "render/picture", "render/explain",
      "render/layers", "render/lint", "render/solid", "render/study", "render/web"}},
    // clang-format on
};

/// Libraries with one home.
const std::map<std::string, std::string> kHomeOfLibrary = {
    {"OpenImageIO/", "render/image"}, {"png.h", "render/image"},   {"ft2build.h", "render/font"},
    {"tao/pegtl", "parser"},          {"httplib.h", "render/web"}, {"Model/COM/", "render/solid"},
};

struct Include {
    std::string file;  ///< from the root
    int line;
    std::string target;
    bool quoted;  ///< "ours", or <a library's>
};

std::optional<std::string> folder_in_table(std::string path)
{
    for (fs::path folder = fs::path(path).parent_path(); !folder.empty(); folder = folder.parent_path())
        if (kMayUse.contains(folder.string())) return folder.string();
    return {};
}

std::optional<Include> include_in(const std::string& line)
{
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) return {};
    const std::size_t open = line.find_first_of("\"<", hash);
    if (open == std::string::npos) return {};
    const bool quoted = line[open] == '"';
    const std::size_t close = line.find(quoted ? '"' : '>', open + 1);
    return Include{"", 0, line.substr(open + 1, close - open - 1), quoted};
}

std::vector<Include> includes_below(const std::string& top)
{
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_ROOT) / top)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
        std::ifstream in(entry.path());
        int number = 0;
        for (std::string line; std::getline(in, line);) {
            ++number;
            std::optional<Include> include = include_in(line);
            if (!include) continue;
            include->file = fs::relative(entry.path(), SOURCE_ROOT).string();
            include->line = number;
            found.push_back(*include);
        }
    }
    return found;
}

std::vector<Include> all_includes()
{
    std::vector<Include> all;
    for (const char* top : {"csg", "function", "language", "parser", "render"}) {
        std::vector<Include> part = includes_below(top);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

/// Why an include may not stand where it does; nothing if it may.
std::optional<std::string> objection(const Include& include)
{
    const std::optional<std::string> from = folder_in_table(include.file);
    if (!from) return "the folder is not in the table of this test";
    if (!include.quoted) {
        for (const auto& [library, home] : kHomeOfLibrary)
            if (include.target.starts_with(library) && !from->starts_with(home)) return library + " belongs to " + home;
        return {};
    }
    const std::optional<std::string> to = folder_in_table(include.target);
    if (!to) return "our headers are named by their path from the root";
    if (*to == *from || kMayUse.at(*from).contains(*to)) return {};
    return *from + " may not depend on " + *to;
}

}  // namespace

TEST_CASE("no source file includes what its folder may not depend on", "[structure]")
{
    const std::vector<Include> includes = all_includes();
    REQUIRE(includes.size() > 50);
    for (const Include& include : includes) {
        const std::optional<std::string> why = objection(include);
        if (why) FAIL_CHECK(include.file << ":" << include.line << ": #include of " << include.target << ": " << *why);
    }
}

TEST_CASE("an include that points upward is found", "[structure]")
{
    CHECK(objection({"csg/solids/solid.cpp", 1, "render/plan/surface.h", true}) == "csg may not depend on render/plan");
    CHECK(objection({"parser/lexer/lexer.cpp", 1, "parser/grammar/grammar.h", true}) ==
          "parser/lexer may not depend on parser/grammar");
    CHECK(objection({"render/picture/render.cpp", 1, "OpenImageIO/imageio.h", false}) ==
          "OpenImageIO/ belongs to render/image");
    CHECK(objection({"render/app/main.cpp", 1, "help.h", true}) == "our headers are named by their path from the root");
    CHECK_FALSE(objection({"parser/grammar/grammar.cpp", 1, "render/scene/object.h", true}));
    CHECK_FALSE(objection({"parser/grammar/grammar.cpp", 1, "tao/pegtl.hpp", false}));
}

TEST_CASE("the table of folders has no cycle", "[structure]")
{
    // Repeatedly take away folders that use nothing that is left. parser/ and its own sub-folders count as one.
    std::map<std::string, std::set<std::string>> left = kMayUse;
    left.erase("parser");
    for (auto& [folder, uses] : left) uses.erase("parser");
    left["render/app"].insert({"parser/grammar", "parser/stream", "parser/lexer"});
    while (!left.empty()) {
        const auto free =
            std::find_if(left.begin(), left.end(), [](const auto& entry) { return entry.second.empty(); });
        REQUIRE(free != left.end());
        const std::string name = free->first;
        left.erase(free);
        for (auto& [folder, uses] : left) uses.erase(name);
    }
}
