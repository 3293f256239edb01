#include "parser/parse.h"
#include "render/image/levels/transfer_curve.h"
#include "render/plan/textures/textures.h"
#include "render/texture/evaluate.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

// Pictures as patterns against what POV-Ray answered: data/images.txt, pictures by data/make_pictures.py.
namespace {

struct Answer {
    std::string statement;
    glm::dvec3 at{0};
    std::vector<double> expected;
};

std::vector<Answer> answers()
{
    std::ifstream in(WHITTLE_TEST_DATA "/images.txt");
    std::vector<Answer> out;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        Answer answer;
        const std::size_t mark = line.find(';');
        answer.statement = line.substr(0, mark);
        std::istringstream rest(line.substr(mark + 1));
        rest >> answer.at.x >> answer.at.y >> answer.at.z;
        for (double v = 0; rest >> v;) answer.expected.push_back(v);
        out.push_back(answer);
    }
    return out;
}

scene::Description parsed(const std::string& pigment, const char* head)
{
    parser::Options options;
    options.library_path = {WHITTLE_TEST_DATA};
    const std::string text = std::string(head) + " sphere { 0, 1 pigment { " + pigment + " } }";
    return parser::parse_text(text, "test.pov", options).scene;
}

const scene::Pigment& pigment_of(const scene::Description& scene)
{
    return std::get<std::vector<scene::Layer>>(scene.objects.at(0).texture->kind).at(0).pigment;
}

constexpr const char* kHead = "#version 3.7; global_settings { assumed_gamma 1 }";

}  // namespace

TEST_CASE("pictures answer as POV-Ray's do", "[plan][image]")
{
    const std::vector<Answer> all = answers();
    REQUIRE(all.size() == 456);
    for (const Answer& answer : all) {
        INFO(answer.statement << " at " << answer.at.x << ' ' << answer.at.y << ' ' << answer.at.z);
        const bool value = answer.statement.starts_with("image_pattern");
        const scene::Description scene =
            parsed(value ? answer.statement + " color_map { [0 rgb 0] [1 rgb 1] }" : answer.statement, kHead);
        texture::TextureSet set;
        std::vector<scene::Unsupported> notes;
        plan::TextureCompiler compiler(scene, plan::Quality(), set, notes);
        const std::uint32_t pigment = compiler.pigment(pigment_of(scene));
        CHECK(notes.empty());
        const scene::Color c = texture::pigment_color(set, pigment, answer.at, {});
        if (value) {
            CHECK(texture::image_value(set.images.at(0), answer.at) ==
                  Approx(answer.expected.at(0)).margin(2e-7));  // told in single precision
            continue;
        }
        const float got[5] = {c.red, c.green, c.blue, c.filter, c.transmit};
        for (std::size_t k = 0; k < 5; ++k)
            CHECK(static_cast<double>(got[k]) == Approx(answer.expected.at(k)).margin(2e-7));
    }
}

TEST_CASE("levels of pictures are decoded by the version of the scene", "[plan][image]")
{
    const auto first = [](const char* head, const std::string& options) {
        const scene::Description scene = parsed("image_map { png \"vrgb.png\" " + options + " }", head);
        texture::TextureSet set;
        std::vector<scene::Unsupported> notes;
        return texture::pigment_color(
                   set, plan::TextureCompiler(scene, plan::Quality(), set, notes).pigment(pigment_of(scene)),
                   {0.1, 0.9, 0}, {})
            .blue;
    };
    const float stored = 200.0f / 255.0f;
    CHECK(first("#version 3.7;", "") == Approx(image::TransferCurve::srgb().decode(stored)));
    CHECK(first("#version 3.7; global_settings { assumed_gamma 2.2 }", "") ==
          Approx(std::pow(image::TransferCurve::srgb().decode(stored), 1.0f / 2.2f)));
    CHECK(first("#version 3.6;", "") == stored);
    CHECK(first("#version 3.6; global_settings { assumed_gamma 1 }", "") == stored);
    CHECK(first(kHead, "gamma 2.2") == Approx(std::pow(stored, 2.2f)));
}

TEST_CASE("of several 'filter all' and 'transmit all' the last of each counts", "[plan][image]")
{
    const scene::Description scene =
        parsed("image_map { png \"vrgb.png\" gamma 1 transmit all 0.3 filter all 0.5 transmit all 0.1 filter all 0.2 }",
               kHead);
    texture::TextureSet set;
    std::vector<scene::Unsupported> notes;
    const scene::Color color = texture::pigment_color(
        set, plan::TextureCompiler(scene, plan::Quality(), set, notes).pigment(pigment_of(scene)), {0.1, 0.9, 0}, {});
    CHECK(color.filter == 0.2f);
    CHECK(color.transmit == 0.1f);
}

TEST_CASE("a picture that is not there leaves its layer out", "[plan][image]")
{
    const scene::Description scene = parsed("image_map { png \"vrgb.png\" once }", kHead);
    texture::TextureSet set;
    std::vector<scene::Unsupported> notes;
    const std::uint32_t pigment = plan::TextureCompiler(scene, plan::Quality(), set, notes).pigment(pigment_of(scene));
    CHECK(texture::pigment_missing(set, pigment, {1.5, 0.5, 0}, {}));
    CHECK_FALSE(texture::pigment_missing(set, pigment, {0.5, 0.5, 0}, {}));
    CHECK(texture::pigment_color(set, pigment, {1.5, 0.5, 0}, {}) == scene::Color{1, 1, 1, 0, 1});
}
