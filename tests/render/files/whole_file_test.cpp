#include "render/files/whole_file.h"

#include <catch2/catch.hpp>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace {

/// The system's number of the failure; 0: it was read.
int failure(const std::string& path)
{
    try {
        files::whole_file(path);
        return 0;
    } catch (const std::system_error& error) {
        return error.code().value();
    }
}

}  // namespace

TEST_CASE("a file is read whole, whatever its length", "[files]")
{
    std::string name = (std::filesystem::temp_directory_path() / "whittle-files-XXXXXX").string();
    const int made = mkstemp(name.data());
    REQUIRE(made >= 0);
    std::FILE* const file = fdopen(made, "wb");
    std::string bytes;
    constexpr std::size_t kPiece = std::size_t{1} << 17;
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{1}, kPiece - 1, kPiece, kPiece + 1, 3 * kPiece, 5 * kPiece + 7}) {
        std::string more;
        for (std::size_t i = bytes.size(); i < length; ++i) more += static_cast<char>(i * i >> 3);
        REQUIRE(std::fwrite(more.data(), 1, more.size(), file) == more.size());
        std::fflush(file);
        bytes += more;
        CHECK(files::whole_file(name) == bytes);
    }
    std::fclose(file);
    CHECK(files::whole_file_if(name) == bytes);
    std::filesystem::remove(name);
    CHECK(failure(name) == ENOENT);
    CHECK_FALSE(files::whole_file_if(name));
}

TEST_CASE("files that do not say their size are read, too", "[files]")
{
    CHECK(files::whole_file("/proc/self/status").find("VmRSS") != std::string::npos);
    CHECK(files::whole_file("/dev/null").empty());
    std::FILE* const told = popen("seq 1 100000", "r");
    const std::string text = files::rest_of(told);
    pclose(told);
    CHECK(text.size() == 588895);
    CHECK(text.ends_with("99999\n100000\n"));
}

TEST_CASE("what cannot be read says why, and whether another try may go well", "[files]")
{
    CHECK(failure("/") == EISDIR);
    CHECK(failure("/proc/self/mem") == EIO);  // opened, and fails while it is read, as on a disk that is away
    CHECK(files::failure_may_pass(EIO));
    CHECK(files::failure_may_pass(ESTALE));
    CHECK_FALSE(files::failure_may_pass(EISDIR));
    CHECK_FALSE(files::failure_may_pass(EACCES));
}
