#include "language/format/format.h"

#include "language/format/lines.h"
#include "language/format/pieces.h"
#include "language/format/spacing.h"

#include <algorithm>

namespace language::format {
namespace {

std::string_view shown(const Piece& piece, std::string_view text)
{
    return text.substr(piece.begin, piece.end - piece.begin);
}

/// A line as it is printed, without indentation.
struct Printed {
    std::string code;
    std::string_view comment;    ///< `// ...` at its end
    std::size_t written_at = 0;  ///< column of the comment in the text
    std::size_t width = 0;       ///< columns of indentation and code
};

std::size_t column_in_text(std::uint32_t at, std::string_view text, const Options& options)
{
    const std::size_t tab = options.tabs ? static_cast<std::size_t>(options.indent) : 8;
    std::uint32_t start = at;
    while (start > 0 && text[start - 1] != '\n' && text[start - 1] != '\r') --start;
    std::size_t column = 0;
    for (std::uint32_t i = start; i < at; ++i) {
        if (text[i] == '\t') column += tab - column % tab;
        else column += (static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u;
    }
    return column;
}

Printed print(const Line& line, const std::vector<Piece>& pieces, std::string_view text, const Options& options)
{
    Printed out;
    for (std::size_t at = line.begin; at < line.end; ++at) {
        if (pieces[at].what == PieceKind::LineComment) {
            out.comment = shown(pieces[at], text);
            out.written_at = column_in_text(pieces[at].begin, text, options);
            continue;
        }
        if (at > line.begin && blank_before(pieces, at, text)) out.code += ' ';
        out.code += shown(pieces[at], text);
    }
    out.width = width_of(line, pieces, text, options);
    return out;
}

/// Comments at the ends of lines that stood below each other still do. Gives each the columns of what stands before it.
void align_comments(std::vector<Printed>& printed, const std::vector<Line>& lines, std::vector<std::size_t>& columns)
{
    constexpr std::size_t kApart = 2;
    columns.assign(printed.size(), 0);
    for (std::size_t first = 0; first < printed.size();) {
        std::size_t last = first + 1;
        if (printed[first].comment.empty() || printed[first].code.empty() || lines[first].as_written) {
            first = last;
            continue;
        }
        std::size_t widest = printed[first].width;
        while (last < printed.size() && !printed[last].comment.empty() && !lines[last].as_written &&
               lines[last].blank_lines == 0 && printed[last].written_at == printed[first].written_at) {
            if (!printed[last].code.empty()) widest = std::max(widest, printed[last].width);
            ++last;
        }
        for (std::size_t i = first; i < last; ++i) columns[i] = widest + kApart;
        first = last;
    }
}

std::string line_end_of(std::string_view text)
{
    const std::size_t at = text.find_first_of("\r\n");
    if (at == std::string_view::npos || text[at] == '\n') return "\n";
    return at + 1 < text.size() && text[at + 1] == '\n' ? "\r\n" : "\r";
}

std::string written(std::vector<Line>& lines, const std::vector<Piece>& pieces, std::string_view text,
                    const Options& options)
{
    const std::string line_end = line_end_of(text);
    std::vector<Printed> printed;
    printed.reserve(lines.size());
    for (const Line& line : lines) printed.push_back(print(line, pieces, text, options));
    std::vector<std::size_t> comment_columns;
    align_comments(printed, lines, comment_columns);

    std::string out(text.substr(0, skipped_start(text)));
    out.reserve(text.size() + text.size() / 8);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& line = lines[i];
        for (std::uint32_t blank = 0; blank < line.blank_lines; ++blank) out += line_end;
        if (line.as_written) {
            std::uint32_t start = pieces[line.begin].begin;
            while (start > 0 && (text[start - 1] == ' ' || text[start - 1] == '\t')) --start;
            out += text.substr(start, pieces[line.end - 1].end - start);
            out += line_end;
            continue;
        }
        const std::size_t margin = static_cast<std::size_t>(line.level * options.indent);
        const bool aligned = comment_columns[i] > 0;
        if (!printed[i].code.empty() || !aligned)
            out.append(options.tabs ? static_cast<std::size_t>(line.level) : margin, options.tabs ? '\t' : ' ');
        out += printed[i].code;
        if (!printed[i].comment.empty()) {
            const std::size_t before = printed[i].code.empty() ? 0 : printed[i].width;
            if (aligned) out.append(comment_columns[i] - before, ' ');
            out += printed[i].comment;
        }
        out += line_end;
    }
    return out;
}

/// The same tokens and the same comments in the same order.
bool says_the_same(const std::vector<Piece>& a, std::string_view text_a, std::string_view text_b)
{
    const std::vector<Piece> b = pieces_of(text_b);
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Piece& x, const Piece& y) {
        return x.what == y.what && x.kind == y.kind && shown(x, text_a) == shown(y, text_b);
    });
}

}  // namespace

std::string formatted(std::string_view text, const Options& options)
{
    std::vector<Piece> pieces = pieces_of(text);
    find_roles(pieces);
    std::vector<Line> lines = lines_of(pieces, text);
    constexpr int kMostRounds = 40;  // a line is broken level by level
    indent(lines, pieces);
    for (int round = 0; round < kMostRounds && break_long(lines, pieces, text, options); ++round) indent(lines, pieces);
    std::string out = written(lines, pieces, text, options);
    if (!says_the_same(pieces, text, out))
        throw Refused(0, "this text cannot be laid out without a change of its tokens");
    return out;
}

}  // namespace language::format
