// Parses every scene named on the command line (after the library folders given with +L) and says how each went:
// the survey behind the parse count of docs/parity.md.
#include "parser/parse.h"

#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

int main(int argc, char** argv)
{
    parser::Options options;
    int good = 0, bad = 0;
    bool dump = false;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word.rfind("+L", 0) == 0) {
            options.library_path.push_back(word.substr(2));
            continue;
        }
        if (word == "--dump") {
            dump = true;
            continue;
        }
        try {
            const parser::Result result = parser::parse_file(word, options);
            ++good;
            std::printf("OK %s objects %zu unsupported", word.c_str(), result.scene.objects.size());
            for (const auto& u : result.scene.unsupported) std::printf(" %s,", u.what.c_str());
            std::printf("\n");
            if (dump) std::fputs(scene::dump(result.scene).c_str(), stdout);
        } catch (const std::exception& error) {
            ++bad;
            std::printf("FAIL %s\n%s\n", word.c_str(), error.what());
        }
    }
    std::printf("%d parsed, %d not\n", good, bad);
    return bad == 0 ? 0 : 1;
}
