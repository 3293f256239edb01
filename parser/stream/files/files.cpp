#include "parser/base/nearest.h"
#include "parser/stream/expression.h"
#include "parser/stream/files/file_bytes.h"
#include "parser/stream/files/file_policy.h"
#include "parser/stream/files/mapped_text.h"
#include "parser/stream/limits.h"
#include "parser/stream/texts/quoted_text.h"
#include "parser/stream/text.h"
#include "parser/stream/token_stream.h"
#include "render/files/whole_file.h"
#include "render/scene/base/passing_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

namespace parser {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestIncludes = 100;  // POV-Ray stops at 32

constexpr std::size_t kKeptText = 4u << 20;  // bytes: a longer file is read again if a message quotes it

/// Reads the file of `length` bytes again if nobody wrote to it since.
std::function<std::string()> reader_of(const std::string& path, std::size_t length)
{
    std::error_code error;
    const auto written = fs::last_write_time(path, error);
    const auto size = error ? 0 : fs::file_size(path, error);
    if (error || size != length) return nullptr;
    return [path = fs::absolute(path), written, size]() -> std::string {
        std::error_code gone;
        if (fs::last_write_time(path, gone) != written || gone || fs::file_size(path, gone) != size || gone) return {};
        return KeptFiles().read(path.string()).value_or(std::string());
    };
}

/// A main scene that was found: no place of it is known yet.
std::string whole_scene(const std::string& path)
{
    try {
        return files::whole_file(path);
    } catch (const std::system_error& failed) {
        const Error told({path, {}}, "cannot read this file: " + failed.code().message());
        if (!files::failure_may_pass(failed.code().value())) throw told;
        throw scene::PassingError(told);
    }
}

bool is_file(const fs::path& path)
{
    std::error_code error;
    return fs::is_regular_file(path, error);
}

}  // namespace

/// `elsewhere`: the text is not ours, and is gone when this returns.
std::uint16_t TokenStream::load(const std::string& path, std::string text, bool main_text, std::string_view elsewhere)
{
    constexpr std::size_t kMostFiles = 60'000, kMostBytes = 0xffffffffu;
    auto source = std::make_unique<SourceFile>();
    source->path = path;
    source->text = std::move(text);
    const std::string_view whole = elsewhere.empty() ? std::string_view(source->text) : elsewhere;
    if (files_.size() >= kMostFiles) throw Error({path, {}}, "too many files");
    if (whole.size() >= kMostBytes) throw Error({path, {}}, "this file is too long");
    const auto index = static_cast<std::uint16_t>(files_.size());
    read_files_.text(whole);
    if (tokenize(whole, *source, index, names_, main_text)) language_.charset = Charset::Utf8;
    ++statistics_.files;
    statistics_.bytes += whole.size();
    statistics_.tokens += source->tokens.size();
    if (whole.size() >= kKeptText && !kept_files_.has(path)) {
        auto reread = reader_of(path, whole.size());
        if (reread && elsewhere.empty()) source->give_text_back(std::move(reread));
        else if (reread) source->do_without(elsewhere, std::move(reread));
    }
    if (!elsewhere.empty() && !source->can_read_again()) source->text = elsewhere;
    files_.push_back(std::move(source));
    return index;
}

void TokenStream::open_main(std::uint16_t index, const std::string& path)
{
    scene_folder_ = fs::path(path).parent_path().string();
    Cursor cursor;
    cursor.file = index;
    cursor.tokens = files_[index]->tokens.data();
    cursor.end = static_cast<std::uint32_t>(files_[index]->tokens.size() - 1);
    cursors_.push_back(cursor);
    *symbols_.global(names_.intern("input_file_name")) = fs::path(path).filename().string();
    if (options_.include_header.empty()) return;
    const Token& start = files_[index]->tokens.front();
    include_named(options_.include_header, start, place(start));
}

void TokenStream::open_file(const std::string& path)
{
    std::error_code error;
    if (!kept_files_.has(path) && !fs::exists(path, error))
        throw Error({path, {}}, "there is no such file" + nearest_file(path, {""}, ".pov"));
    auto text = kept_files_.has(path) || !is_file(path) ? kept_files_.read(path) : whole_scene(path);
    if (!text) throw Error({path, {}}, "cannot read this file");
    open_main(load(path, std::move(*text), true), path);
}

void TokenStream::open_text(const std::string& text, const std::string& name)
{
    open_main(load(name, text, true), name);
}

void TokenStream::predefine()
{
    const auto set = [&](const char* name, double value) { *symbols_.global(names_.intern(name)) = Tuple::of(value); };
    set("image_width", options_.image_width);
    set("image_height", options_.image_height);
    set("frame_number", options_.frame_number);
    set("initial_frame", options_.initial_frame);
    set("final_frame", options_.final_frame);
    set("initial_clock", options_.initial_clock);
    set("final_clock", options_.final_clock);
    set("clock_delta", options_.clock_delta);
    for (const auto& [name, value] : options_.declared_numbers) set(name.c_str(), value);
    for (const auto& [name, text] : options_.declared_strings) *symbols_.global(names_.intern(name)) = text;
}

std::string TokenStream::find_file(const std::string& name, const std::vector<std::string>& extensions) const
{
    if (name.empty() || name.find('\0') != std::string::npos) return {};
    std::vector<std::string> names;
    bool has_extension = extensions.empty();
    for (const std::string& extension : extensions) has_extension = has_extension || name.ends_with(extension);
    if (has_extension) names.push_back(name);
    for (const std::string& extension : extensions) names.push_back(name + extension);
    if (!has_extension) names.push_back(name);

    const std::vector<std::string> folders = searched_folders();
    const auto there = [&](const fs::path& path) { return kept_files_.has(path.string()) || is_file(path); };
    for (const std::string& candidate : names) {
        if (fs::path(candidate).is_absolute()) {
            if (there(candidate) && may_read(options_, scene_folder_, candidate)) return candidate;
            continue;
        }
        for (const fs::path folder : folders)
            if (there(folder / candidate) && may_read(options_, scene_folder_, (folder / candidate).string()))
                return (folder / candidate).string();
    }
    return {};
}

/// In order, each once; "" is the current one.
std::vector<std::string> TokenStream::searched_folders() const
{
    std::vector<std::string> folders{""};
    const auto add = [&](const std::string& folder) {
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
    };
    for (const std::string& folder : options_.library_path) add(folder);
    add(scene_folder_);  // POV-Ray looks into neither of these two
    if (!cursors_.empty()) add(fs::path(files_[cursors_.back().file]->path).parent_path().string());
    return folders;
}

/// "; did you mean 'colors.inc'?" with the file of that extension whose name is nearest, or nothing.
std::string TokenStream::nearest_file(const std::string& name, const std::vector<std::string>& folders,
                                      std::string_view extension) const
{
    constexpr std::size_t kMostNames = 20'000;
    const fs::path wanted(name);
    std::vector<std::string> names;
    for (const fs::path folder : folders) {
        const fs::path place = folder / wanted.parent_path();
        std::error_code error;
        for (fs::directory_iterator entry(place.empty() ? "." : place, error), end;
             !error && entry != end && names.size() < kMostNames; entry.increment(error)) {
            const std::string found = entry->path().filename().string();
            if (fs::path(found).extension() == extension && may_read(options_, scene_folder_, entry->path().string()))
                names.push_back(found);
        }
    }
    std::string word = wanted.filename().string();
    if (!wanted.has_extension()) word += extension;
    const std::string nearest = nearest_of(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", (wanted.parent_path() / nearest).string());
}

std::string TokenStream::where_searched() const
{
    std::string text;
    for (const std::string& folder : searched_folders())
        text += (text.empty() ? " in " : ", ") + (folder.empty() ? "the current folder" : "'" + folder + "'");
    return text;
}

const char* TokenStream::why_not_found() const
{
    return options_.restrict_read ? ", or it lies outside of the folders that may be read" : "";
}

void TokenStream::include()
{
    const Token& call = *last_;
    const scene::SourceRef at = here();
    include_named(path_expr(*this), call, at);
}

/// The file of that path, read if it was not yet.
std::uint16_t TokenStream::loaded(const std::string& path, const scene::SourceRef& at)
{
    const auto known = loaded_.find(path);
    if (known != loaded_.end()) return known->second;
    const MappedText mapped(path, kept_files_.has(path) ? std::numeric_limits<std::size_t>::max() : kKeptText);
    std::string text;
    if (kept_files_.has(path)) text = kept_files_.read(path).value_or(std::string());
    else if (!mapped) text = bytes_of_file(*this, at, path);
    spend_time();
    const std::uint16_t file = load(path, std::move(text), false, mapped.text());
    open_places_.push_back({ReadingProfile::What::File, file, 0});
    profile_.spend(open_places_);
    loaded_.emplace(path, file);
    return file;
}

void TokenStream::include_named(const std::string& name, const Token& call, const scene::SourceRef& at)
{
    const std::string key = cursors_.empty() ? name : fmt::format("{}\n{}", cursors_.back().file, name);
    const auto again = included_.find(key);
    const std::string path = again != included_.end() ? std::string() : find_file(name, {".inc", ".INC"});
    if (again == included_.end() && path.empty()) {
        const bool absolute = fs::path(name).is_absolute();
        fail(at, fmt::format("cannot find the include file '{}'{}{}{}", name, absolute ? "" : where_searched(),
                             why_not_found(),
                             nearest_file(name, absolute ? std::vector<std::string>{""} : searched_folders(), ".inc")));
    }
    std::size_t depth = 0;
    for (const Cursor& cursor : cursors_) depth += !cursor.macro;
    if (depth >= kDeepestIncludes || cursors_.size() >= 2 * kDeepestIncludes + kDeepestCalls)
        fail(at, "files include each other too deeply; does one include itself?");

    const std::uint16_t file = again != included_.end() ? again->second : loaded(path, at);
    if (again == included_.end()) included_.emplace(key, file);
    symbols_.open_scope();
    Cursor cursor;
    cursor.file = file;
    cursor.tokens = files_[cursor.file]->tokens.data();
    cursor.end = static_cast<std::uint32_t>(files_[cursor.file]->tokens.size() - 1);
    cursor.blocks = blocks_.size();
    cursor.call = &call;
    cursors_.push_back(cursor);
}

void TokenStream::message_directive(Kind kind)
{
    const scene::SourceRef at = last();
    const std::string text = printed(string_expr(*this), language_.version);
    if (kind == Kind::Error) fail(at, text);
    if (kind == Kind::Warning) return warn_as_written(at, text);
    if (kind != Kind::Debug) warn(at, fmt::format("#{} prints where #debug does", spelling(kind)));
    report({Severity::Debug, text, {}, {}, {}, at});
}

}  // namespace parser
