#pragma once

#include "language/names/document.h"
#include "render/app/rpc/guarded_json.h"

namespace app::lsp {

using namespace rpc;  // the protocol is made of it

/// What a position's `character` counts.
enum class Encoding { Utf8, Utf16 };

/// Bytes of a text as the protocol tells places: line and character from 0. A line ends with LF, CR LF or CR.
class Positions {
public:
    Positions(std::string_view text, Encoding encoding);
    json position(std::uint32_t offset) const;
    json range(language::Range range) const;
    /// The byte of a position; beyond a line its end, beyond the text the end of that. Throws Refusal.
    std::uint32_t offset(const json& position) const;
    language::Range range(const json& range) const;
    language::Range line(std::size_t line) const;  ///< without its line end
    std::size_t lines() const { return starts_.size(); }
    std::size_t line_of(std::uint32_t offset) const;

private:
    std::string_view text_;
    Encoding encoding_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace app::lsp
