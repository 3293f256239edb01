#pragma once

#include "render/app/rpc/rpc.h"
#include "render/app/mcp/child.h"
#include "render/app/options/settings.h"
#include "render/app/output/scratch_folder.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace app::mcp {

using rpc::ErrorCode;
using rpc::json;
using rpc::Refusal;

/// What the server was started with.
struct Walls {
    std::string folder;                ///< absolute: files of tools lie below it, and scenes read there
    std::vector<std::string> library;  ///< folders of the library path
    ChildLimits limits;
    double pixels = 1e6;  ///< of a picture
};

/// What tools share.
class Workshop {
public:
    Workshop(Walls walls, std::function<int()> listen, std::function<bool()> wanted)
        : walls_(std::move(walls)), listen_(std::move(listen)), wanted_(std::move(wanted))
    {}
    const Walls& walls() const { return walls_; }
    const ScratchFolder& scratch() const { return scratch_; }

    /// Work in a process of its own. Throws ToolFailure where it was ended.
    ChildResult run(const json& arguments, const std::function<int()>& work);

    /// The file of the scene that the arguments give as text, or name below the folder; and its options as a file.
    std::string scene_file(const json& arguments);
    std::string options_file(const json& arguments);
    /// A picture of before, or a file below the folder.
    std::string picture_file(const json& arguments, const char* name);
    /// What a tool printed, without the scratch folder's name.
    std::string cleaned(std::string text) const;

    std::string next_picture();  ///< a name in the scratch folder; the oldest ones go

private:
    std::string inner_file(const std::string& name) const;

    const Walls walls_;
    const ScratchFolder scratch_;
    const std::function<int()> listen_;
    const std::function<bool()> wanted_;
    int pictures_ = 0;
};

/// A tool that could not do what it was asked for: the caller is told, in a result.
struct ToolFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Tool {
    std::string_view name, title, meaning;
    std::string properties;                          ///< JSON: those of the schema of its arguments
    std::string_view required;                       ///< JSON: their names
    json (*call)(Workshop&, const json& arguments);  ///< the result as the protocol has it
};

/// All tools.
const std::vector<Tool>& tools();

json check_tool(Workshop& shop, const json& arguments);
json render_tool(Workshop& shop, const json& arguments);
json pixel_tool(Workshop& shop, const json& arguments);
json info_tool(Workshop& shop, const json& arguments);
json section_tool(Workshop& shop, const json& arguments);
json mesh_tool(Workshop& shop, const json& arguments);
json compare_tool(Workshop& shop, const json& arguments);
json explain_keyword_tool(Workshop& shop, const json& arguments);

/// Content of a result.
json text_content(const std::string& text);
json text_result(const std::string& text, bool failed = false);

/// A number of the arguments within bounds, or `usual`. Throws Refusal.
double number_in(const json& arguments, const char* name, double least, double most, double usual);

}  // namespace app::mcp
