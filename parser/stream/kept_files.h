#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace parser {

/// Files in memory, by their path as written without "." and "..": with Options::write_nothing what the scene would
/// have written, so that it can read it again, and texts that an editor has not saved yet.
class KeptFiles {
public:
    using Texts = std::map<std::string, std::string>;
    /// \param texts  Options::texts
    explicit KeptFiles(const Texts* texts = nullptr) : texts_(texts) {}
    /// The text of a file opened for writing.
    /// \param append  begins with what the file on disk holds
    std::shared_ptr<std::string> open(const std::string& path, bool append);
    bool has(const std::string& path) const { return find(path) != nullptr; }
    /// From here, or else from disk; nothing where neither has it.
    std::optional<std::string> read(const std::string& path) const;

private:
    const std::string* find(const std::string& path) const;
    std::map<std::string, std::shared_ptr<std::string>> files_;
    const Texts* texts_;
};

}  // namespace parser
