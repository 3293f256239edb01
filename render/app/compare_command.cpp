#include "render/app/compare_command.h"

#include "render/app/settings.h"
#include "render/image/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace app {

namespace {

constexpr int kAgree = 0, kDiffer = 1, kFailed = 2;

struct Request {
    std::vector<std::string> pictures;
    std::string out;
    double tolerance = 3.0;  ///< of 255
    double share = 0.99;     ///< of the pixels
};

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
        const std::size_t equals = word.find('=');
        const std::string option = word.substr(0, equals);
        if (option != "--out" && option != "--tolerance" && option != "--share") throw OptionError("unknown option '" + word + "'");
        if (equals == std::string::npos && i + 1 == arguments.size()) throw OptionError(option + " wants a value");
        const std::string value = equals == std::string::npos ? arguments[++i] : word.substr(equals + 1);
        if (option == "--out") request.out = value;
        else if (option == "--tolerance") request.tolerance = number_in(option, value, 255.0);
        else request.share = number_in(option, value, 1.0);
    }
    if (request.pictures.size() != 2) throw OptionError("compare wants two pictures: whittle compare A B [--out diff.png] [--tolerance n] [--share x]");
    return request;
}

std::string levels(const float (&pixel)[4])
{
    const auto level = [](float v) { return std::round(static_cast<double>(v) * 10.0) / 10.0; };
    return fmt::format("<{:g}, {:g}, {:g}>", level(pixel[0]), level(pixel[1]), level(pixel[2]));
}

void print(const Request& request, const image::Comparison& c, bool agree)
{
    fmt::print("agreeing  {:.4f} % of pixels within {:g}/255 in every channel\n", 100.0 * c.agreeing, request.tolerance);
    fmt::print("rmse      {:.4f} of 255\n", c.rmse);
    fmt::print("psnr      {}\n", std::isinf(c.psnr) ? "infinite" : fmt::format("{:.2f} dB", c.psnr));
    fmt::print("ssim      {:.6f}\n", c.ssim);
    if (c.largest > 0.0)
        fmt::print("worst     pixel ({}, {}): {} and {}, {:g} apart\n", c.worst_x, c.worst_y, levels(c.worst_a), levels(c.worst_b), std::round(c.largest * 10.0) / 10.0);
    else
        fmt::print("worst     none: the pictures are equal\n");
    fmt::print("{}: {:g} % asked for\n", agree ? "agree" : "differ", 100.0 * request.share);
}

}  // namespace

int compare_command(const std::vector<std::string>& arguments)
{
    try {
        const image::Files files;
        const Request request = request_of(arguments);
        const image::Picture a = files.read(request.pictures[0]), b = files.read(request.pictures[1]);
        const image::Comparison comparison = image::compare(a, b, request.tolerance);
        const bool agree = comparison.agreeing >= request.share;
        print(request, comparison, agree);
        if (!request.out.empty())
            files.write(request.out, image::difference_picture(a, b, request.tolerance), image::FileType::Png, image::TransferCurve::srgb());
        return agree ? kAgree : kDiffer;
    } catch (const std::exception& error) {
        fmt::print(stderr, "whittle: error: {}\n", error.what());
        return kFailed;
    }
}

}  // namespace app
