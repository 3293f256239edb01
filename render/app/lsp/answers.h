#pragma once

#include "language/names/symbol.h"
#include "render/app/lsp/positions.h"

#include <functional>
#include <string>
#include <vector>

/// Answers about texts: the parameters of a request of the protocol in, its result out, both as the protocol has them
/// (a function is named after its method). All come from tokens, at once. Throw Refusal for parameters that are wrong.
namespace app::lsp {

/// What answers look into.
struct World {
    language::Files& files;
    Encoding encoding = Encoding::Utf16;
    std::vector<std::string> folders;  ///< of the workspace
    /// What a global name came to in the scene that was read last and reaches a text.
    std::function<std::string(const std::string& path, const std::string& name)> value_of;
    std::function<std::string(const std::string& path)> uri_of;  ///< as the client writes it
};

json completion(World& world, const json& parameters);
json hover(World& world, const json& parameters);
json definition(World& world, const json& parameters);
json references(World& world, const json& parameters);
json highlights(World& world, const json& parameters);
json prepare_rename(World& world, const json& parameters);
json rename(World& world, const json& parameters);
json symbols(World& world, const json& parameters);
json folding(World& world, const json& parameters);
json colors(World& world, const json& parameters);
json color_presentation(World& world, const json& parameters);
json formatting(World& world, const json& parameters);
json range_formatting(World& world, const json& parameters);

}  // namespace app::lsp
