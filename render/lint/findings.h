#pragma once

#include "parser/lexer/lexer.h"
#include "render/lint/lint.h"

#include <map>
#include <memory>

namespace lint {

/// Texts by path, read once, for the lines that messages quote.
class Texts {
public:
    explicit Texts(const Reader& read) : read_(read) {}
    /// With its tokens; null: it cannot be read.
    const parser::SourceFile* file(const std::string& path);
    const parser::Names& names() const { return names_; }

private:
    const Reader& read_;
    parser::Names names_;
    std::map<std::string, std::unique_ptr<parser::SourceFile>> files_;
};

/// What was found, once for each place and check.
class Findings {
public:
    Findings(const scene::Description* description, const Reader& read, const Wanted& wanted)
        : description_(description), texts_(read), wanted_(wanted)
    {}
    bool wants(std::string_view check) const { return wanted_.wants(check); }
    void add(std::string_view check, const scene::SourceRef& at, std::string text,
             std::vector<std::pair<scene::SourceRef, std::string>> related = {});
    void add(std::string_view check, const std::string& path, std::uint32_t offset, std::string text);
    void add_message(std::string_view check, scene::Message message);
    Texts& texts() { return texts_; }
    std::vector<Finding> take();

private:
    const scene::Description* description_;
    Texts texts_;
    const Wanted& wanted_;
    std::set<std::string> told_;  ///< check and place
    std::vector<Finding> found_;
};

// The groups of checks, each in a file of that name.
void check_names(Findings& out, const std::string& path, const std::vector<std::string>& others);
void check_loops(Findings& out, const std::string& path, const std::vector<std::string>& others);
void check_sizes(Findings& out, const scene::Description& description);
void check_textures(Findings& out, const scene::Description& description);
void check_coincident(Findings& out, const scene::Description& description);
void check_space(Findings& out, const scene::Description& description);

}  // namespace lint
