#include "language/format/lines.h"

#include "language/format/spacing.h"

#include <algorithm>

namespace language::format {
namespace {

using parser::Kind;

bool says(const Piece& piece, std::string_view text, std::string_view words)
{
    if (piece.what != PieceKind::LineComment) return false;
    std::string_view said = text.substr(piece.begin + 2, piece.end - piece.begin - 2);
    said.remove_prefix(std::min(said.find_first_not_of(" \t"), said.size()));
    return said == words;
}

/// Words that begin a statement of a block: a line may be broken before them.
bool begins_item(const std::vector<Piece>& pieces, std::size_t at)
{
    const Piece& piece = pieces[at];
    if (piece.what != PieceKind::Token || pieces[at - 1].what != PieceKind::Token) return false;
    const Kind before = pieces[at - 1].kind;
    if (pieces[at - 1].role == Role::Sign || pieces[at - 1].role >= Role::Tight) return false;
    if (before == Kind::Hash || before == Kind::Equal || before == Kind::Period || before == Kind::Comma) return false;
    switch (piece.kind) {
    case Kind::Hash:
    case Kind::Texture:
    case Kind::Pigment:
    case Kind::Normal:
    case Kind::Finish:
    case Kind::Interior:
    case Kind::InteriorTexture:
    case Kind::Material:
    case Kind::Photons:
    case Kind::Media:
    case Kind::Rotate:
    case Kind::Scale:
    case Kind::Translate:
    case Kind::Matrix:
    case Kind::Transform:
    case Kind::ColorMap:
    case Kind::PigmentMap:
    case Kind::TextureMap:
    case Kind::NormalMap:
    case Kind::ClippedBy:
    case Kind::BoundedBy:
    case Kind::Object:
    case Kind::Sphere:
    case Kind::Box:
    case Kind::Cylinder:
    case Kind::Cone:
    case Kind::Torus:
    case Kind::Union:
    case Kind::Merge:
    case Kind::Difference:
    case Kind::Intersection:
    case Kind::LookAt:
    case Kind::Location: return true;
    default: return false;
    }
}

struct Depth {
    int braces = 0, marks = 0;
    void take(const Piece& p)
    {
        if (p.what != PieceKind::Token) return;
        braces += (p.kind == Kind::LeftBrace) - (p.kind == Kind::RightBrace);
        marks += (p.kind == Kind::LeftParen || p.kind == Kind::LeftSquare || p.role == Role::OpensVector) -
                 (p.kind == Kind::RightParen || p.kind == Kind::RightSquare || p.role == Role::ClosesVector);
    }
};

/// The first block that opens and closes on the line: where its braces are.
bool find_block(const Line& line, const std::vector<Piece>& pieces, std::size_t& open, std::size_t& close)
{
    std::vector<std::size_t> openers;
    open = line.end;
    for (std::size_t at = line.begin; at < line.end; ++at) {
        if (pieces[at].kind == Kind::LeftBrace) openers.push_back(at);
        if (pieces[at].kind != Kind::RightBrace || openers.empty()) continue;
        const bool holds_something = at > openers.back() + 1;
        if (holds_something && openers.back() < open) open = openers.back(), close = at;
        openers.pop_back();
    }
    return open != line.end;
}

/// Pieces before which the line is broken, ascending; empty: it cannot be.
std::vector<std::size_t> breaks_of_block(const Line& line, const std::vector<Piece>& pieces)
{
    std::size_t open = 0, close = 0;
    if (!find_block(line, pieces, open, close)) return {};
    std::vector<std::size_t> breaks{open + 1};
    Depth depth;
    for (std::size_t at = open + 1; at < close; ++at) {
        const bool top = depth.braces == 0 && depth.marks == 0;
        if (top && at > open + 1 && begins_item(pieces, at)) breaks.push_back(at);
        depth.take(pieces[at]);
    }
    breaks.push_back(close);
    return breaks;
}

std::vector<std::size_t> breaks_of_list(const Line& line, const std::vector<Piece>& pieces, std::string_view text,
                                        const Options& options)
{
    const std::size_t limit = static_cast<std::size_t>(options.width);
    for (int wanted = 0; wanted < 3; ++wanted) {  // marks that may be open where it is broken
        std::vector<std::size_t> breaks;
        Line part = line;
        std::size_t candidate = line.end;
        Depth depth;
        for (std::size_t at = line.begin; at < line.end; ++at) {
            depth.take(pieces[at]);
            const bool here = pieces[at].kind == Kind::Comma && depth.marks == wanted && at + 1 < line.end &&
                              pieces[at + 1].what != PieceKind::LineComment;
            if (!here && at + 1 != line.end) continue;
            part.end = at + 1;
            const std::size_t width = width_of(part, pieces, text, options);
            if (width > limit && candidate != line.end) {
                breaks.push_back(candidate);
                part.begin = candidate;
                part.level = line.level + (wanted > 0);
            }
            candidate = at + 1;
        }
        if (!breaks.empty()) return breaks;
    }
    return {};
}

}  // namespace

std::size_t columns(std::string_view text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::vector<Line> lines_of(const std::vector<Piece>& pieces, std::string_view text)
{
    std::vector<Line> lines;
    bool as_written = false;
    for (std::size_t at = 0; at < pieces.size(); ++at) {
        const bool first = at == 0 || pieces[at].lines_before > 0 || pieces[at - 1].what == PieceKind::LineComment;
        if (first) {
            const bool resumes = says(pieces[at], text, "format on");
            Line& line = lines.emplace_back();
            line.begin = at;
            line.blank_lines = at == 0 ? 0 : std::max(pieces[at].lines_before, 1u) - 1;
            line.as_written = as_written && !resumes;
            if (!as_written) line.blank_lines = std::min(line.blank_lines, 1u);
            if (resumes) as_written = false;
        }
        lines.back().end = at + 1;
        if (says(pieces[at], text, "format off")) as_written = true;
    }
    return lines;
}

std::size_t width_of(const Line& line, const std::vector<Piece>& pieces, std::string_view text, const Options& options)
{
    std::size_t width = static_cast<std::size_t>(line.level * options.indent);
    for (std::size_t at = line.begin; at < line.end; ++at) {
        if (pieces[at].what == PieceKind::LineComment) break;
        if (at > line.begin) width += blank_before(pieces, at, text);
        const std::string_view shown = text.substr(pieces[at].begin, pieces[at].end - pieces[at].begin);
        const std::size_t last_line = shown.find_last_of("\r\n");
        width = last_line == std::string_view::npos ? width + columns(shown) : columns(shown.substr(last_line + 1));
    }
    return width;
}

bool break_long(std::vector<Line>& lines, const std::vector<Piece>& pieces, std::string_view text,
                const Options& options)
{
    std::vector<Line> out;
    out.reserve(lines.size());
    bool any = false;
    for (const Line& line : lines) {
        std::vector<std::size_t> breaks;
        if (!line.as_written && width_of(line, pieces, text, options) > static_cast<std::size_t>(options.width)) {
            breaks = breaks_of_block(line, pieces);
            if (breaks.empty()) breaks = breaks_of_list(line, pieces, text, options);
        }
        Line part = line;
        for (const std::size_t at : breaks) {
            part.end = at;
            out.push_back(part);
            part.begin = at;
            part.blank_lines = 0;
        }
        part.end = line.end;
        out.push_back(part);
        any = any || !breaks.empty();
    }
    lines = std::move(out);
    return any;
}

}  // namespace language::format
