#pragma once

#include "render/app/lsp/answers.h"
#include "render/app/lsp/uri.h"

namespace app::lsp {

/// The text that a request is about. Throws Refusal where there is none.
struct Asked {
    Asked(World& world, const json& parameters)
        : path(path_of_uri(string_member(object_member(parameters, "textDocument"), "uri"))),
          known(world.files.find(path))
    {
        if (!known) throw Refusal(ErrorCode::InvalidParams, "there is no such text");
    }
    const language::Document& document() const { return known->document; }
    Positions positions(const World& world) const { return {document().text(), world.encoding}; }
    std::uint32_t offset(const World& world, const json& parameters) const
    {
        return positions(world).offset(object_member(parameters, "position"));
    }

    std::string path;
    language::KnownPtr known;
};

}  // namespace app::lsp
