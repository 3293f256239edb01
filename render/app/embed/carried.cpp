#include "render/app/embed/carried.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

namespace app {
namespace {

constexpr std::string_view kForm = "whittle scene 1\n";
constexpr std::size_t kRoomForRecords = std::size_t{16} << 20;  ///< names, options and numbers beside the files' bytes
constexpr std::size_t kLongestOption = 1 << 16, kLongestName = 4096, kMostOptions = 10'000;

[[noreturn]] void damaged(const char* what) { throw std::runtime_error(fmt::format("its scene is damaged: {}", what)); }

/// What zlib makes of the bytes, as long as that stays within the limits.
std::string inflated(std::string_view bytes)
{
    z_stream zip{};
    if (inflateInit(&zip) != Z_OK) throw std::runtime_error("not enough memory for its scene");
    struct End {
        z_stream& zip;
        ~End() { inflateEnd(&zip); }
    } end{zip};
    zip.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    zip.avail_in = static_cast<uInt>(bytes.size());
    std::string out;
    char block[1 << 16];
    for (int state = Z_OK; state != Z_STREAM_END;) {
        zip.next_out = reinterpret_cast<Bytef*>(block);
        zip.avail_out = sizeof block;
        state = inflate(&zip, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) damaged("it cannot be unpacked");
        out.append(block, sizeof block - zip.avail_out);
        if (out.size() > kMostCarriedBytes + kRoomForRecords)
            throw std::runtime_error(
                fmt::format("its scene has more than the {} MB that a picture may carry", kMostCarriedBytes >> 20));
    }
    if (zip.avail_in != 0) damaged("something stands behind its end");
    return out;
}

/// Records one after the other: a letter, a number or two, a line's end, so many bytes.
class Records {
public:
    explicit Records(std::string_view text) : rest_(text) {}
    bool ended() const { return rest_.empty(); }
    char letter()
    {
        if (ended()) damaged("it ends early");
        const char c = rest_.front();
        rest_.remove_prefix(1);
        return c;
    }
    /// With the blank or the line's end behind it.
    std::size_t number(std::size_t most)
    {
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || value > most) damaged("a length is wrong");
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        const char behind = letter();
        if (behind != ' ' && behind != '\n') damaged("a length is wrong");
        return value;
    }
    std::string_view bytes(std::size_t count)
    {
        if (count > rest_.size()) damaged("it ends early");
        const std::string_view out = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return out;
    }

private:
    std::string_view rest_;
};

}  // namespace

bool is_inner_name(std::string_view name)
{
    constexpr std::size_t kLongestPart = 255;
    if (name.empty() || name.size() > kLongestName) return false;
    if (std::any_of(name.begin(), name.end(),
                    [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\' || c == '"'; }))
        return false;
    while (true) {
        const std::size_t slash = name.find('/');
        const std::string_view part = name.substr(0, slash);
        if (part.empty() || part == "." || part == ".." || part.size() > kLongestPart) return false;
        if (slash == std::string_view::npos) return true;
        name.remove_prefix(slash + 1);
    }
}

std::string packed(const Carried& carried)
{
    std::string text(kForm);
    if (!carried.folder.empty()) text += fmt::format("d{}\n{}", carried.folder.size(), carried.folder);
    for (const std::string& line : carried.options) text += fmt::format("o{}\n{}", line.size(), line);
    for (const Carried::File& file : carried.files) {
        text += fmt::format("f{} {}\n{}", file.name.size(), file.bytes.size(), file.name);
        text += file.bytes;
    }
    uLongf size = compressBound(text.size());
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(text.data()), text.size(),
                  Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("not enough memory to pack the scene");
    out.resize(size);
    return out;
}

Carried unpacked(std::string_view bytes)
{
    const std::string text = inflated(bytes);
    if (!text.starts_with(kForm)) {
        if (text.starts_with("whittle scene "))
            throw std::runtime_error("its scene is of a newer form than this program's");
        damaged("it does not begin as one");
    }
    Carried out;
    std::set<std::string> names;
    std::size_t all = 0;
    Records records(std::string_view(text).substr(kForm.size()));
    while (!records.ended()) {
        const char letter = records.letter();
        if (letter == 'o') {
            if (out.options.size() >= kMostOptions) damaged("it has too many options");
            out.options.emplace_back(records.bytes(records.number(kLongestOption)));
        } else if (letter == 'd') {
            out.folder = std::string(records.bytes(records.number(kLongestName)));
            if (!is_inner_name(out.folder)) damaged("its folder is none");
        } else if (letter == 'f') {
            if (out.files.size() >= kMostCarriedFiles) damaged("it has too many files");
            const std::size_t name_size = records.number(kLongestName), size = records.number(kMostCarriedBytes);
            Carried::File file{std::string(records.bytes(name_size)), std::string(records.bytes(size))};
            if (!is_inner_name(file.name))
                throw std::runtime_error(
                    fmt::format("its scene has a file called '{}', which would not lie in the folder", file.name));
            if (!names.insert(file.name).second) damaged("two of its files have one name");
            all += size;
            out.files.push_back(std::move(file));
        } else {
            damaged("a record is of no known kind");
        }
    }
    if (out.files.empty()) damaged("it has no files");
    if (all > kMostCarriedBytes) damaged("it is too long");
    return out;
}

}  // namespace app
