#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace model {

/// Tags of an XML text one after the other, with their attributes; what stands between them is passed over. Prefixes of
/// namespaces are left away. Throws ModelError with the line.
class XmlScanner {
public:
    explicit XmlScanner(std::string_view text) : text_(text) {}

    /// False: the text has ended.
    bool next();
    std::string_view name() const { return name_; }
    bool opens() const { return opens_; }    ///< `<a>` and `<a/>`
    bool closes() const { return closes_; }  ///< `</a>` and `<a/>`
    /// As written.
    std::optional<std::string_view> attribute(std::string_view name) const;
    /// With what &lt; and its kin stand for.
    std::string text(std::string_view name) const;
    [[noreturn]] void fail(const std::string& what) const;

private:
    std::string_view until(std::string_view mark);
    void skip_blank();
    std::string_view word();

    std::string_view text_, name_;
    std::size_t at_ = 0, tag_ = 0;
    bool opens_ = false, closes_ = false;
    std::vector<std::pair<std::string_view, std::string_view>> attributes_;
};

}  // namespace model
