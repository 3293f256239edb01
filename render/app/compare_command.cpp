#include "render/app/compare_command.h"

#include "render/app/options/settings.h"
#include "render/app/base/text.h"
#include "render/image/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>

namespace app {

namespace {

struct Request {
    std::vector<std::string> pictures;
    std::string out;
    image::FileType out_type = image::FileType::Png;
    double tolerance = 3.0;  ///< of 255
    double share = 0.99;     ///< of the pixels
    bool flip = false;       ///< told, and drawn instead of the largest difference
};

constexpr const char* kCompareUsage =
    R"(usage: whittle compare A B [--out diff.png] [--flip] [--tolerance n] [--share x]

How far two pictures of one size are apart. Exit status: 0 they agree, 1 they differ, 2 they cannot be compared.

  --out FILE    draw the difference: what agrees as dim grey, the rest from red (just apart) to white; the type is that of
                the name: .png .ppm .tga .jpg .bmp
  --flip        how different they look on a screen, A being the reference: the mean of FLIP (Andersson et al. 2020), 0 to 1;
                --out draws it pixel by pixel, from black (nothing to be seen) to white
  --tolerance n largest difference of a channel that agrees, of 255; usual: 3
  --share x     of the pixels that have to agree, 0 to 1; usual: 0.99
)";

/// By the name's ending, as the picture is written; a name without one is a PNG's.
image::FileType out_type_of(const std::string& name)
{
    using image::FileType;
    const std::string extension = std::filesystem::path(name).extension().string();
    if (extension.empty()) return FileType::Png;
    if (same_text(extension, ".jpeg")) return FileType::Jpeg;
    for (const FileType type : {FileType::Png, FileType::Ppm, FileType::Targa, FileType::Jpeg, FileType::Bmp})
        if (same_text(extension, image::extension(type))) return type;
    throw OptionError("--out wants a name that ends in .png, .ppm, .tga, .jpg or .bmp, found '" + name + "'");
}

double number_in(const std::string& option, const std::string& text, double largest)
{
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != 0 || !(number >= 0.0) || number > largest)
        throw OptionError(fmt::format("{} wants a number from 0 to {}, found '{}'", option, largest, text));
    return number;
}

Request request_of(const std::vector<std::string>& arguments)
{
    Request request;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        if (!word.starts_with("--")) {
            request.pictures.push_back(word);
            continue;
        }
        if (word == "--flip") {
            request.flip = true;
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string option = word.substr(0, equals);
        if (option != "--out" && option != "--tolerance" && option != "--share")
            throw OptionError("unknown option '" + word + "'");
        if (equals == std::string::npos && i + 1 == arguments.size()) throw OptionError(option + " wants a value");
        const std::string value = equals == std::string::npos ? arguments[++i] : word.substr(equals + 1);
        if (option == "--out") request.out_type = out_type_of(request.out = value);
        else if (option == "--tolerance") request.tolerance = number_in(option, value, 255.0);
        else request.share = number_in(option, value, 1.0);
    }
    if (request.pictures.size() != 2)
        throw OptionError(
            "compare wants two pictures: whittle compare A B [--out diff.png] [--flip] [--tolerance n] [--share x]");
    return request;
}

double rounded_level(float v) { return std::round(static_cast<double>(v) * 10.0) / 10.0; }

std::string levels(const float (&pixel)[4], bool alpha)
{
    const std::string color =
        fmt::format("<{:g}, {:g}, {:g}>", rounded_level(pixel[0]), rounded_level(pixel[1]), rounded_level(pixel[2]));
    return alpha ? fmt::format("{} alpha {:g}", color, rounded_level(pixel[3])) : color;
}

void print(const Request& request, const image::Comparison& c, const std::vector<float>& flip, bool agree)
{
    fmt::print("agreeing  {:.4f} % of pixels within {:g}/255 in every channel\n", 100.0 * c.agreeing,
               request.tolerance);
    fmt::print("rmse      {:.4f} of 255\n", c.rmse);
    fmt::print("psnr      {}\n", std::isinf(c.psnr) ? "infinite" : fmt::format("{:.2f} dB", c.psnr));
    fmt::print("ssim      {:.6f}\n", c.ssim);
    if (!flip.empty())
        fmt::print("flip      {:.6f}\n",
                   std::accumulate(flip.begin(), flip.end(), 0.0) / static_cast<double>(flip.size()));
    const bool alpha = c.worst_a[3] != c.worst_b[3];
    if (c.largest > 0.0)
        fmt::print("worst     pixel ({}, {}): {} and {}, {:g} apart\n", c.worst_x, c.worst_y, levels(c.worst_a, alpha),
                   levels(c.worst_b, alpha), std::round(c.largest * 10.0) / 10.0);
    else fmt::print("worst     none: the pictures are equal\n");
    fmt::print("{}: {:g} % asked for\n", agree ? "agree" : "differ", 100.0 * request.share);
}

}  // namespace

std::string compare_help() { return kCompareUsage; }

int compare_command(const std::vector<std::string>& arguments)
{
    try {
        const image::Files files;
        const Request request = request_of(arguments);
        const image::Picture a = files.read(request.pictures[0]), b = files.read(request.pictures[1]);
        const image::Comparison comparison = image::compare(a, b, request.tolerance);
        const bool agree = comparison.agreeing >= request.share;
        const std::vector<float> flip = request.flip ? image::flip_map(a, b) : std::vector<float>{};
        print(request, comparison, flip, agree);
        if (!request.out.empty())
            files.write(request.out,
                        request.flip ? image::flip_picture(flip, a.width, a.height)
                                     : image::difference_picture(a, b, request.tolerance),
                        request.out_type, image::TransferCurve::srgb());
        return agree ? kAgree : kDiffer;
    } catch (const std::exception& error) {
        fmt::print(stderr, "whittle: error: {}\n", error.what());
        return kNotCompared;
    }
}

}  // namespace app
