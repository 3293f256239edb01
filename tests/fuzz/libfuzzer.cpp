// The driver of the preset `fuzz`: libFuzzer's entries. `TARGET --seeds FOLDER` writes the seeds and stops.
#include "tests/fuzz/target.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

void fuzz::fail(const std::string& text)
{
    std::fprintf(stderr, "%s\n", text.c_str());
    std::abort();
}

extern "C" int LLVMFuzzerInitialize(int* count, char*** values)
{
    if (*count != 3 || std::strcmp((*values)[1], "--seeds") != 0) return 0;
    int number = 0;
    for (const fuzz::Bytes& seed : fuzz::seeds()) {
        std::ofstream out(std::string((*values)[2]) + "/seed" + std::to_string(++number), std::ios::binary);
        out.write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
    }
    std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::one(fuzz::Bytes(data, data + size));
    return 0;
}
