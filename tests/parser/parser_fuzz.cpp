// libFuzzer's entry: any bytes as a scene, to a description or an Error. See README.md.
#include "parser/parse.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    parser::Options options;
    options.most_tokens = 20'000;  // a loop need not end
    try {
        parser::parse_text(std::string(reinterpret_cast<const char*>(data), size), "fuzz.pov", options);
    } catch (const parser::Error&) {}
    return 0;
}
