#include "render/model/base/xml_scanner.h"

#include "render/model/base/model.h"

#include <algorithm>

namespace model {
namespace {

bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view without_prefix(std::string_view name) { return name.substr(name.find(':') + 1); }

}  // namespace

void XmlScanner::fail(const std::string& what) const
{
    const std::string_view before = text_.substr(0, std::min(tag_, text_.size()));
    throw ModelError(what, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')));
}

/// What stands before the mark, behind which it goes on.
std::string_view XmlScanner::until(std::string_view mark)
{
    const std::size_t end = text_.find(mark, at_);
    if (end == std::string_view::npos) fail("it ends within a tag");
    const std::string_view out = text_.substr(at_, end - at_);
    at_ = end + mark.size();
    return out;
}

void XmlScanner::skip_blank()
{
    while (at_ < text_.size() && blank(text_[at_])) ++at_;
    if (at_ >= text_.size()) fail("it ends within a tag");
}

std::string_view XmlScanner::word()
{
    const std::size_t begin = at_;
    while (at_ < text_.size() && !blank(text_[at_]) && text_[at_] != '>' && text_[at_] != '/' && text_[at_] != '=')
        ++at_;
    return text_.substr(begin, at_ - begin);
}

bool XmlScanner::next()
{
    for (;;) {
        tag_ = std::min(text_.find('<', at_), text_.size());
        if (tag_ == text_.size()) return false;
        at_ = tag_ + 1;
        const std::string_view rest = text_.substr(at_, 8);
        if (rest.starts_with("!--")) until("-->");
        else if (rest == "![CDATA[") until("]]>");
        else if (rest.starts_with("?")) until("?>");
        else if (rest.starts_with("!")) fail("a document type is not read");
        else break;
    }
    attributes_.clear();
    closes_ = at_ < text_.size() && text_[at_] == '/';
    opens_ = !closes_;
    if (closes_) ++at_;
    name_ = without_prefix(word());
    if (name_.empty()) fail("a tag without a name");
    for (;;) {
        skip_blank();
        if (text_[at_] == '>') return ++at_, true;
        if (text_[at_] == '/') {
            closes_ = true;
            ++at_;
            continue;
        }
        const std::string_view key = word();
        skip_blank();
        if (key.empty() || text_[at_] != '=') fail("an attribute of '" + std::string(name_) + "' has no value");
        ++at_;
        skip_blank();
        const char quote = text_[at_++];
        if (quote != '"' && quote != '\'') fail("a value of '" + std::string(name_) + "' is not in quotes");
        attributes_.emplace_back(without_prefix(key), until(std::string_view(&quote, 1)));
    }
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view name) const
{
    for (const auto& [key, value] : attributes_)
        if (key == name) return value;
    return std::nullopt;
}

std::string XmlScanner::text(std::string_view name) const
{
    constexpr std::pair<std::string_view, char> kKnown[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
    const std::string_view written = attribute(name).value_or("");
    std::string out;
    for (std::size_t i = 0; i < written.size();) {
        const auto* known = std::find_if(std::begin(kKnown), std::end(kKnown),
                                         [&](const auto& one) { return written.substr(i).starts_with(one.first); });
        out += known == std::end(kKnown) ? written[i] : known->second;
        i += known == std::end(kKnown) ? 1 : known->first.size();
    }
    return out;
}

}  // namespace model
