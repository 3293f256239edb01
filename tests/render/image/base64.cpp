#include "render/image/base64.h"

#include <catch2/catch.hpp>

TEST_CASE("base64 has the vectors of RFC 4648, section 10, and takes them back", "[image]")
{
    const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) {
        CHECK(image::base64(bytes) == text);
        CHECK(image::from_base64(text) == bytes);
    }
    std::string all;
    for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
    CHECK(image::from_base64(image::base64(all)) == all);
    for (const char* wrong : {"Z", "Zg=", "Zg", "Zm9v!", "Zm=v", "====", "Zm9vZg==Zm9v", "Zm9\n"}) {
        INFO(wrong);
        CHECK_FALSE(image::from_base64(wrong).has_value());
    }
}
