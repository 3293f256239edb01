#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// What floors.txt says: its head describes the form.
struct Floors {
    struct Row {
        int height;  ///< by its place in the file, the lowest first
        std::set<std::string> uses;
    };
    using Arrow = std::pair<std::string, std::string>;

    std::map<std::string, Row> rows;
    std::set<Arrow> exceptions;

    static Floors read(std::istream& in)
    {
        Floors floors;
        Row* row = nullptr;
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line.substr(0, line.find('#')));
            std::string word;
            bool first = line.find_first_not_of(' ') == 0;
            if (line.starts_with('!')) {
                std::string from, arrow, to;
                words >> word >> from >> arrow >> to;
                floors.exceptions.emplace(from, to);
                continue;
            }
            for (; words >> word; first = false) {
                if (first) {
                    if (word.back() == ':') word.pop_back();
                    row = &floors.rows[word];
                    row->height = static_cast<int>(floors.rows.size());
                } else if (row != nullptr) {
                    row->uses.insert(word);
                }
            }
        }
        return floors;
    }
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

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

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

/// The name by which a row allows the folder: its own, or that of a folder around it with a slash at its end.
std::optional<std::string> allowed_as(const std::string& folder, const std::set<std::string>& uses)
{
    if (uses.contains(folder)) return folder;
    for (fs::path around = folder; !around.empty(); around = around.parent_path())
        if (uses.contains(around.string() + "/")) return around.string() + "/";
    return {};
}

/// Looks at includes one by one and keeps what of the table they have needed.
class Inspector {
public:
    explicit Inspector(Floors floors) : floors_(std::move(floors)) {}

    /// Why an include may not stand where it does; nothing if it may.
    std::optional<std::string> objection(const Include& include)
    {
        const std::string from = folder_of(include.file);
        if (!floors_.rows.contains(from)) return from + " has no row";
        if (!include.quoted) {
            for (const auto& [library, home] : kHomeOfLibrary)
                if (include.target.starts_with(library) && !from.starts_with(home))
                    return library + " belongs to " + home;
            return {};
        }
        const std::string to = folder_of(include.target);
        if (!floors_.rows.contains(to)) return "our headers are named by their path from the root";
        if (to == from) return {};
        const Floors::Row& row = floors_.rows.at(from);
        const bool upward = floors_.rows.at(to).height > row.height;
        const auto allowed = allowed_as(to, row.uses);
        if (!upward && allowed) {
            needed_[from].insert(*allowed);
            return {};
        }
        if (floors_.exceptions.contains({from, to})) {
            excepted_.emplace(from, to);
            return {};
        }
        return upward ? to + " stands above " + from : from + " does not name " + to;
    }

    /// What the table says and no include needs.
    std::vector<std::string> idle() const
    {
        std::vector<std::string> found;
        for (const auto& [folder, row] : floors_.rows)
            for (const std::string& name : row.uses) {
                const auto of = needed_.find(folder);
                if (of == needed_.end() || !of->second.contains(name)) found.push_back(folder + ": " + name);
            }
        for (const auto& [from, to] : floors_.exceptions)
            if (!excepted_.contains({from, to})) found.push_back("! " + from + " -> " + to);
        return found;
    }

private:
    Floors floors_;
    std::map<std::string, std::set<std::string>> needed_;
    std::set<Floors::Arrow> excepted_;
};

struct Sources {
    std::set<std::string> folders;
    std::vector<Include> includes;
};

Sources all_sources()
{
    Sources all;
    for (const char* top : {"numbers", "csg", "function", "language", "parser", "render", "python"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_ROOT) / top)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
            const std::string file = fs::relative(entry.path(), SOURCE_ROOT).string();
            all.folders.insert(folder_of(file));
            std::ifstream in(entry.path());
            int number = 0;
            for (std::string line; std::getline(in, line);) {
                ++number;
                std::optional<Include> include = include_in(line);
                if (!include) continue;
                include->file = file;
                include->line = number;
                all.includes.push_back(*include);
            }
        }
    return all;
}

Floors floors_of_the_house()
{
    std::ifstream in(SOURCE_ROOT "/tests/structure/floors.txt");
    REQUIRE(in);
    return Floors::read(in);
}

}  // namespace

TEST_CASE("every include points to a folder below that the row of its own names", "[structure]")
{
    const Sources sources = all_sources();
    REQUIRE(sources.includes.size() > 1000);
    Inspector inspector(floors_of_the_house());
    for (const Include& include : sources.includes) {
        const std::optional<std::string> why = inspector.objection(include);
        if (why) FAIL_CHECK(include.file << ":" << include.line << ": #include of " << include.target << ": " << *why);
    }
    for (const std::string& line : inspector.idle()) FAIL_CHECK("floors.txt says and nothing needs: " << line);
}

TEST_CASE("rows and folders of sources are the same", "[structure]")
{
    const Sources sources = all_sources();
    const Floors floors = floors_of_the_house();
    for (const auto& [folder, row] : floors.rows)
        if (!sources.folders.contains(folder)) FAIL_CHECK("floors.txt: " << folder << " has no sources");
    for (const std::string& folder : sources.folders)
        if (!floors.rows.contains(folder)) FAIL_CHECK("floors.txt has no row for " << folder);
}

TEST_CASE("an include that points upward or is not named is found, and what is idle", "[structure]")
{
    std::istringstream table("# words\n"
                             "csg/base:\n"
                             "csg/tree: csg/base\n"
                             "render/image:\n"
                             "render/plan: csg/\n"
                             "    render/image  # in a second line\n"
                             "! csg/base -> csg/tree\n"
                             "! csg/base -> render/plan\n");
    Inspector inspector(Floors::read(table));
    const auto said = [&](const char* file, const char* target, bool quoted = true) {
        return inspector.objection({file, 1, target, quoted}).value_or("");
    };
    CHECK(said("csg/tree/a.cpp", "render/plan/surface.h") == "render/plan stands above csg/tree");
    CHECK(said("render/image/a.h", "csg/base/types.h") == "render/image does not name csg/base");
    CHECK(said("render/plan/a.h", "OpenImageIO/imageio.h", false) == "OpenImageIO/ belongs to render/image");
    CHECK(said("render/plan/a.cpp", "help.h") == "our headers are named by their path from the root");
    CHECK(said("render/new/a.cpp", "csg/base/types.h") == "render/new has no row");
    CHECK(said("render/plan/a.cpp", "csg/tree/b.h") == "");
    CHECK(said("render/plan/a.cpp", "render/plan/b.h") == "");
    CHECK(said("render/image/a.cpp", "OpenImageIO/imageio.h", false) == "");
    CHECK(said("csg/base/a.h", "csg/tree/b.h") == "");
    CHECK(inspector.idle() ==
          std::vector<std::string>{"csg/tree: csg/base", "render/plan: render/image", "! csg/base -> render/plan"});
}
