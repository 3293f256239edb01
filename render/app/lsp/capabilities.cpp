#include "render/app/lsp/capabilities.h"

#include <algorithm>

namespace app::lsp {

Encoding encoding_for(const json& initialize)
{
    const json* const offered = find_member(initialize, {"capabilities", "general", "positionEncodings"});
    if (offered == nullptr || !offered->is_array()) return Encoding::Utf16;
    const bool utf8 = std::any_of(offered->begin(), offered->end(), [](const json& one) { return one == "utf-8"; });
    return utf8 ? Encoding::Utf8 : Encoding::Utf16;
}

json capabilities(Encoding encoding)
{
    constexpr int kIncremental = 2;
    return {{"capabilities",
             {{"positionEncoding", encoding == Encoding::Utf8 ? "utf-8" : "utf-16"},
              {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}, {"save", true}}},
              {"completionProvider", {{"triggerCharacters", json::array({"#", "\"", "/"})}}},
              {"hoverProvider", true},
              {"definitionProvider", true},
              {"referencesProvider", true},
              {"documentHighlightProvider", true},
              {"documentSymbolProvider", true},
              {"foldingRangeProvider", true},
              {"colorProvider", true},
              {"documentFormattingProvider", true},
              {"documentRangeFormattingProvider", true},
              {"renameProvider", {{"prepareProvider", true}}}}},
            {"serverInfo", {{"name", "whittle"}, {"version", WHITTLE_VERSION}}}};
}

}  // namespace app::lsp
