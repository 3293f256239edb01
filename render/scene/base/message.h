#pragma once

#include "render/scene/base/line_table.h"
#include "render/scene/base/source_ref.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scene {

enum class Severity { Debug, Note, Warning, Error };

/// "debug", "note", "warning" or "error".
const char* name_of(Severity severity);

/// A place as it is told. Line 0: the file as a whole; without a path: nowhere.
struct Place {
    std::string path;
    LineAndColumn at;
};

/// What led there: the call of a macro, the line that included a file.
struct RelatedPlace {
    Place place;
    std::string text;
    std::size_t times = 1;  ///< in a row, as recursion has it
};

/// A source line as it is shown, cut around the place where it is long.
struct QuotedLine {
    std::string text;
    std::string indent;  ///< blanks and tabs that bring a caret below the place
};

/// Whether two say the same, but for how often.
bool same_place(const RelatedPlace& a, const RelatedPlace& b);

/// What a user is told, in parts; message_text() puts them together. Debug text is as the scene wrote it.
struct Message {
    Severity severity = Severity::Error;
    std::string text;                 ///< the words alone
    Place place;                      ///< of the mistake
    std::optional<QuotedLine> quote;  ///< empty: not shown
    std::vector<RelatedPlace> related;
    SourceRef source;
    std::optional<Place> opened = {};  ///< the brace that the words tell of
    std::string_view check = {};       ///< of `whittle lint` that tells it too
};

/// "path:line:column", as much of it as there is.
std::string place_text(const Place& place);
/// The source line with its number, and below it a caret. The message quotes one.
std::string quoted_text(const Message& message);
/// `path:line:column: error: words`, the source line, a caret, a line for each related place (STYLE of the console).
std::string message_text(const Message& message);

/// Ends the reading or the rendering of a scene; what() has all messages as message_text().
class Error : public std::runtime_error {
public:
    explicit Error(std::vector<Message> messages);
    explicit Error(Message message) : Error(std::vector<Message>{std::move(message)}) {}
    /// About a place, or a file as a whole, of which no line is shown.
    Error(Place place, std::string text)
        : Error(Message{Severity::Error, std::move(text), std::move(place), {}, {}, {}})
    {}
    const std::vector<Message>& messages() const { return messages_; }

private:
    std::vector<Message> messages_;
};

}  // namespace scene
