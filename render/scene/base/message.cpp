#include "render/scene/base/message.h"

#include <fmt/format.h>

namespace scene {
namespace {

std::string joined(const std::vector<Message>& messages)
{
    std::string all;
    for (const Message& message : messages) {
        if (!all.empty()) all += '\n';
        all += message_text(message);
    }
    return all;
}

}  // namespace

bool same_place(const RelatedPlace& a, const RelatedPlace& b)
{
    return a.place.at.line == b.place.at.line && a.place.at.column == b.place.at.column &&
           a.place.path == b.place.path && a.text == b.text;
}

const char* name_of(Severity severity)
{
    switch (severity) {
    case Severity::Debug: return "debug";
    case Severity::Note: return "note";
    case Severity::Warning: return "warning";
    case Severity::Error: break;
    }
    return "error";
}

std::string place_text(const Place& place)
{
    return place.at.line == 0 ? place.path : fmt::format("{}:{}:{}", place.path, place.at.line, place.at.column);
}

std::string quoted_text(const Message& message)
{
    return fmt::format("{:>5} | {}\n{:>5} | {}^", message.place.at.line, message.quote->text, "",
                       message.quote->indent);
}

std::string message_text(const Message& message)
{
    if (message.severity == Severity::Debug) return message.text;
    const std::string place = place_text(message.place);
    std::string all =
        fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", name_of(message.severity), message.text);
    if (message.quote) (all += '\n') += quoted_text(message);
    for (const RelatedPlace& one : message.related)
        all += fmt::format("\n{}: note: {}{}", place_text(one.place), one.text,
                           one.times > 1 ? fmt::format(", {} times", one.times) : "");
    return all;
}

Error::Error(std::vector<Message> messages) : std::runtime_error(joined(messages)), messages_(std::move(messages)) {}

}  // namespace scene
