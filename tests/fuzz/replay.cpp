// The driver of ./check: TARGET COUNT reads that many inputs, TARGET --write N FILE writes input N, TARGET FILE...
// reads files.
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/target.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>

extern "C" void __sanitizer_set_death_callback(void (*)()) __attribute__((weak));

namespace {

constexpr unsigned kSecondsPerInput =
    60;  // hundreds of times what the slowest takes, on a machine that does other things too

char at_hand[128];  // said when the program dies

void say_input() { [[maybe_unused]] const auto written = write(STDERR_FILENO, at_hand, std::strlen(at_hand)); }

void on_signal(int signal)
{
    say_input();
    if (signal == SIGALRM) std::fputs("it takes too long\n", stderr);
    _exit(1);
}

void read_one(const std::string& name, const fuzz::Bytes& bytes)
{
    std::snprintf(at_hand, sizeof at_hand, "\nwhile reading input %s\n", name.c_str());
    alarm(kSecondsPerInput);
    fuzz::one(bytes);
    alarm(0);
}

}  // namespace

void fuzz::fail(const std::string& text)
{
    std::fprintf(stderr, "%s\n", text.c_str());
    say_input();
    std::_Exit(1);
}

int main(int count, char** values)
{
    if (&__sanitizer_set_death_callback) __sanitizer_set_death_callback(say_input);
    else std::signal(SIGSEGV, on_signal);
    for (const int signal : {SIGABRT, SIGALRM}) std::signal(signal, on_signal);
    const std::vector<fuzz::Bytes> seeds = fuzz::seeds();
    if (seeds.empty()) {
        std::puts("no seeds: the files that they are made of are not installed");
        return 0;
    }
    if (count == 4 && std::strcmp(values[1], "--write") == 0) {
        const fuzz::Bytes bytes =
            fuzz::Mutator(seeds, static_cast<std::uint32_t>(std::strtoul(values[2], nullptr, 10))).input();
        std::ofstream(values[3], std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return 0;
    }
    char* end = nullptr;
    const unsigned long inputs = count == 2 ? std::strtoul(values[1], &end, 10) : 0;
    if (end != nullptr && *end == 0) {
        for (std::uint32_t i = 0; i < inputs; ++i) read_one(std::to_string(i), fuzz::Mutator(seeds, i).input());
        std::printf("%lu inputs read\n", inputs);
        return 0;
    }
    for (int i = 1; i < count; ++i) {
        std::ifstream in(values[i], std::ios::binary);
        read_one(values[i], fuzz::Bytes(std::istreambuf_iterator<char>(in), {}));
    }
    return 0;
}
