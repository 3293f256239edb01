#include "render/app/parts/prepared_file.h"

#include "render/files/hash.h"
#include "render/files/whole_file.h"
#include "render/image/picture_writer.h"
#include "render/image/pixels/passing_failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace app {

namespace {

constexpr const char* kPreparedMagic = "whittle prepared 1\n";

std::string check_of(const std::string& bytes)
{
    const std::uint64_t hash = files::hash_of(bytes.data(), bytes.size());
    return {reinterpret_cast<const char*>(&hash), sizeof hash};
}

}  // namespace

std::optional<trace::Prepared> read_prepared(const std::string& path, const std::string& fingerprint, bool& other)
{
    other = false;
    std::optional<std::string> whole = files::whole_file_if(path);
    if (!whole) return std::nullopt;
    std::string& bytes = *whole;
    const std::string begin = kPreparedMagic + fingerprint;
    other = true;
    if (!bytes.starts_with(begin) || bytes.size() < begin.size() + sizeof(std::uint64_t)) return std::nullopt;
    const std::string check = bytes.substr(bytes.size() - sizeof(std::uint64_t));
    bytes.resize(bytes.size() - check.size());
    if (check_of(bytes) != check) return std::nullopt;
    auto prepared = trace::prepared_of(std::string_view(bytes).substr(begin.size()));
    other = !prepared;
    return prepared;
}

void write_prepared(const std::string& path, const std::string& fingerprint, const trace::Prepared& prepared)
{
    const std::string bytes = kPreparedMagic + fingerprint + trace::bytes_of(prepared);
    image::Replacement file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out << bytes << check_of(bytes);
    out.close();
    if (!out) image::fail_by_system(errno, "cannot write '" + path + "': " + std::strerror(errno));
    file.put_in_place(true);
}

}  // namespace app
