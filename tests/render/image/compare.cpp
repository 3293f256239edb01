#include "render/image/compare/compare.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace image;

namespace {

std::vector<float>& floats(Picture& picture) { return std::get<Samples::Floats>(picture.samples.kept); }

Picture noise(int width, int height, int channels, unsigned seed)
{
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.channels = channels;
    for (int i = 0; i < width * height * channels; ++i) {
        seed = seed * 1664525u + 1013904223u;
        floats(picture).push_back(static_cast<float>(seed >> 24) / 255.0f);
    }
    return picture;
}

float& sample(Picture& picture, int x, int y, int channel)
{
    return floats(picture)[static_cast<std::size_t>((y * picture.width + x) * picture.channels + channel)];
}

}  // namespace

TEST_CASE("a picture equals itself", "[image][compare]")
{
    for (const int channels : {1, 2, 3, 4}) {
        const Picture picture = noise(23, 17, channels, 7);
        const Comparison result = compare(picture, picture, 0.0);
        CHECK(result.agreeing == 1.0);
        CHECK(result.rmse == 0.0);
        CHECK(std::isinf(result.psnr));
        CHECK(result.ssim == 1.0);
        CHECK(result.largest == 0.0);
    }
}

TEST_CASE("one changed pixel is named, counted and drawn", "[image][compare]")
{
    const Picture a = noise(20, 10, 3, 1);
    Picture b = a;
    float& changed = sample(b, 13, 4, 1);
    changed = changed > 0.5f ? 0.0f : 1.0f;
    const double difference = 255.0 *
                              std::fabs(static_cast<double>(a.at(13, 4)[1]) - static_cast<double>(b.at(13, 4)[1]));
    const Comparison result = compare(a, b, 3.0);
    CHECK(result.agreeing == Approx(199.0 / 200.0));
    CHECK(result.worst_x == 13);
    CHECK(result.worst_y == 4);
    CHECK(result.largest == Approx(difference));
    CHECK(result.rmse == Approx(difference / std::sqrt(600.0)));
    CHECK(result.psnr == Approx(20.0 * std::log10(255.0 / result.rmse)));
    CHECK(result.ssim < 1.0);
    const Raster drawn = difference_picture(a, b, 3.0);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) CHECK((drawn.at(x, y)[0] == 255) == (x == 13 && y == 4));
}

TEST_CASE("a difference of the tolerance itself agrees, one more does not", "[image][compare]")
{
    Picture a = noise(8, 8, 3, 3);
    for (float& value : floats(a)) value = 100.0f / 255.0f;
    Picture b = a;
    sample(b, 2, 2, 0) = 103.0f / 255.0f;
    CHECK(compare(a, b, 3.0).agreeing == 1.0);
    sample(b, 2, 2, 0) = 104.0f / 255.0f;
    CHECK(compare(a, b, 3.0).agreeing == Approx(63.0 / 64.0));
    CHECK(compare(a, b, 4.0).agreeing == 1.0);
}

TEST_CASE("comparison does not depend on the order of the two", "[image][compare]")
{
    const Picture a = noise(31, 9, 3, 5), b = noise(31, 9, 3, 6);
    const Comparison one = compare(a, b, 3.0), two = compare(b, a, 3.0);
    CHECK(one.agreeing == two.agreeing);
    CHECK(one.rmse == two.rmse);
    CHECK(one.ssim == Approx(two.ssim));
    CHECK(one.worst_x == two.worst_x);
    CHECK(std::fabs(one.ssim) < 0.2);  // unrelated noise has no structure in common
}

TEST_CASE("grey counts as colour and a missing alpha as opaque", "[image][compare]")
{
    Picture grey = noise(6, 6, 1, 9), colour = grey;
    colour.channels = 4;
    floats(colour).clear();
    for (const float value : floats(grey)) floats(colour).insert(floats(colour).end(), {value, value, value, 1.0f});
    CHECK(compare(grey, colour, 0.0).agreeing == 1.0);
    sample(colour, 5, 5, 3) = 0.0f;
    const Comparison clear = compare(grey, colour, 3.0);
    CHECK(clear.largest == 255.0);
    CHECK(clear.worst_x == 5);
}

TEST_CASE("a value that is no number never agrees", "[image][compare]")
{
    const Picture a = noise(4, 4, 3, 2);
    Picture b = a;
    sample(b, 1, 1, 0) = std::nanf("");
    CHECK(compare(a, b, 255.0).agreeing == Approx(15.0 / 16.0));
}

TEST_CASE("pictures of two sizes are not compared", "[image][compare]")
{
    CHECK_THROWS_AS(compare(noise(4, 5, 3, 1), noise(5, 4, 3, 1), 3.0), FileError);
}
