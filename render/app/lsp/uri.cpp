#include "render/app/lsp/uri.h"

#include "language/names/files.h"

#include <fmt/format.h>

#include <string_view>

namespace app::lsp {
namespace {

int digit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string decoded(std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool escape = text[at] == '%' && at + 2 < text.size() && digit(text[at + 1]) >= 0 &&
                            digit(text[at + 2]) >= 0;
        out += escape ? static_cast<char>(digit(text[at + 1]) * 16 + digit(text[at + 2])) : text[at];
        if (escape) at += 2;
    }
    return out;
}

bool plain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
           c == '_' || c == '~' || c == '/';
}

}  // namespace

std::string path_of_uri(const std::string& uri)
{
    constexpr std::string_view kFile = "file://";
    if (!uri.starts_with(kFile)) {
        std::string path = "/unsaved/";  // below no folder that a scene would have
        for (const char c : uri) path += plain(c) && c != '/' ? c : '_';
        return path;
    }
    std::string_view rest = std::string_view(uri).substr(kFile.size());
    rest.remove_prefix(std::min(rest.find('/'), rest.size()));  // the host
    std::string path = decoded(rest);
    if (const std::size_t zero = path.find('\0'); zero != std::string::npos) path.resize(zero);
    return language::normal_path(path.empty() ? "/" : path);
}

std::string uri_of_path(const std::string& path)
{
    std::string uri = "file://";
    for (const char c : path) {
        if (plain(c)) uri += c;
        else uri += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return uri;
}

}  // namespace app::lsp
