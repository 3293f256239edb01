#include "render/picture/render.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace {

scene::TexturePtr plain(float red, float green, float blue, float reflection)
{
    scene::Layer layer;
    layer.pigment.kind = scene::Color{red, green, blue, 0, 0};
    layer.finish.edit().reflection.min = layer.finish.edit().reflection.max = glm::vec3(reflection);
    auto texture = std::make_shared<scene::Texture>();
    texture->kind = std::vector<scene::Layer>{layer};
    return texture;
}

scene::Object object(scene::Shape shape, scene::TexturePtr texture)
{
    scene::Object made;
    made.shape = std::move(shape);
    made.texture = std::move(texture);
    return made;
}

/// Balls over a plane, a drilled box, a mirror, one light.
scene::Description description()
{
    scene::Description d;
    d.default_texture = plain(0, 0, 0, 0);
    d.camera.location = {0, 2, -8};
    d.camera.direction = {0, -0.1, 1};
    d.background = {0.2f, 0.3f, 0.5f, 0, 0};
    for (int i = 0; i < 40; ++i)
        d.objects.push_back(object(scene::Sphere{{i % 8 - 3.5, 0.3, i / 8}, 0.3 + 0.01 * i},
                                   plain(0.02f * static_cast<float>(i), 0.5f, 0.4f, i % 5 == 0 ? 0.4f : 0.0f)));
    scene::Csg cut;
    cut.op = scene::CsgOp::Difference;
    std::vector<scene::Object> operands{object(scene::Box{{-1, 1, 0}, {1, 3, 2}}, plain(1, 0, 0, 0))};
    operands.push_back(object(scene::Sphere{{0, 2, 0}, 0.8}, plain(0, 1, 0, 0)));
    operands.push_back(object(scene::Cylinder{{-2, 2, 1}, {2, 2, 1}, 0.4, false}, plain(0, 0, 1, 0)));
    cut.operands = std::make_shared<const std::vector<scene::Object>>(std::move(operands));
    d.objects.push_back(object(cut, nullptr));
    d.objects.push_back(object(scene::Plane{{0, 1, 0}, 0}, plain(0.8f, 0.8f, 0.7f, 0)));
    scene::Light light;
    light.location = {5, 9, -6};
    d.objects.push_back(object(light, nullptr));
    return d;
}

/// The same without its plane, larger.
scene::Description scaled(double by)
{
    scene::Description d = description();
    d.camera.location *= by;
    const scene::ObjectList all = std::move(d.objects);
    d.objects.clear();
    for (const scene::Object& o : all)
        if (!std::holds_alternative<scene::Plane>(o.shape)) d.objects.push_back(o);
    for (scene::Object& o : d.objects) {
        if (auto* light = std::get_if<scene::Shared<scene::Light>>(&o.shape)) light->edit().location *= by;
        else o.transform = csg::Transform::scale(glm::dvec3(by)) * *o.transform;
    }
    return d;
}

image::Image picture(const plan::CompiledScene& scene, int threads, trace::Isa isa)
{
    image::Image out;
    trace::RenderOptions options;
    options.threads = threads;
    options.isa = isa;
    trace::render(scene, options, out);
    return out;
}

bool same_bytes(const image::Image& a, const image::Image& b)
{
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("a picture has the same bytes for any number of threads and any instruction set", "[trace][render]")
{
    for (const int method : {0, 1, 2}) {
        plan::Options options;
        options.width = 150;
        options.height = 110;
        options.antialiasing.method = method;
        const plan::CompiledScene scene = plan::compile(description(), options);
        const std::vector<trace::Isa> kernels = trace::kernels_there();
        const image::Image reference = picture(scene, 1, kernels.front());
        INFO("antialiasing " << method);
        CHECK(*std::max_element(reference.pixels.begin(), reference.pixels.end()) > 0.5f);
        for (const trace::Isa isa : kernels)
            for (const int threads : {1, 2, 3}) {
                INFO("isa " << static_cast<int>(isa) << " threads " << threads);
                CHECK(same_bytes(reference, picture(scene, threads, isa)));
            }
    }
}

TEST_CASE("rays are counted by kind and the same for any number of threads", "[trace][render]")
{
    plan::Options options;
    options.width = 64;
    options.height = 48;
    const plan::CompiledScene scene = plan::compile(description(), options);
    image::Image out;
    trace::RenderOptions one;
    one.threads = 1;
    trace::RenderOptions three;
    three.threads = 3;
    const trace::RayCounts a = trace::render(scene, one, out).rays, b = trace::render(scene, three, out).rays;
    CHECK(a.camera == 64 * 48);
    CHECK(a.shadow > 0);
    CHECK(a.reflected > 0);
    CHECK(a.shadow == b.shadow);
    CHECK(a.reflected == b.reflected);
}

TEST_CASE("a scene looks the same at any scale", "[trace][render]")
{
    // Powers of two change no digit, so what differs is what is not to scale: 2^-30 is 9e-10, 2^30 is 1e9.
    plan::Options options;
    options.width = 120;
    options.height = 90;
    const image::Image usual = picture(plan::compile(scaled(1.0), options), 2, trace::Isa::Auto);
    for (const int power : {-30, -20, -10, 10, 20, 30}) {
        const image::Image other = picture(plan::compile(scaled(std::ldexp(1.0, power)), options), 2, trace::Isa::Auto);
        int differ = 0;
        for (std::size_t i = 0; i < usual.pixels.size(); ++i)
            differ += std::abs(usual.pixels[i] - other.pixels[i]) > 1e-3f;
        INFO("scale 2^" << power);
        CHECK(differ == 0);  // of 32400; with tolerances of one size 113 at 2^-10, 4299 at 2^-20
    }
}

TEST_CASE("glass has two sides however thin it is", "[trace][render]")
{
    plan::Options options;
    options.width = 80;
    options.height = 60;
    const auto behind = [&](double thickness) {
        scene::Description d = description();
        scene::Object glass = object(scene::Box{{-4, 0.5, -4}, {4, 4, -4 + thickness}}, plain(1, 1, 1, 0));
        std::get<std::vector<scene::Layer>>(const_cast<scene::Texture&>(*glass.texture).kind)[0].pigment.kind =
            scene::Color{1, 1, 1, 0.9f, 0};
        auto interior = std::make_shared<scene::Interior>();
        interior->ior = 1.5f;
        glass.details.edit().interior = interior;
        glass.transform = csg::Transform::rotate_degrees({0, 20, 0});
        d.objects.push_back(glass);
        return picture(plan::compile(d, options), 2, trace::Isa::Auto);
    };
    // So thin that nothing is moved by a pixel. Without the far side the rays stay bent: 6,191 of 14,400 values differ.
    const image::Image thick = behind(2e-3), thin = behind(2e-6);
    int differ = 0;
    for (std::size_t i = 0; i < thick.pixels.size(); ++i) differ += std::abs(thick.pixels[i] - thin.pixels[i]) > 0.02f;
    CHECK(differ < 150);
}

TEST_CASE("pixels outside the window stay black", "[trace][render]")
{
    plan::Options options;
    options.width = 40;
    options.height = 30;
    options.start_column = 10;
    options.end_column = 19;
    options.start_row = 5;
    options.end_row = 14;
    image::Image out = picture(plan::compile(description(), options), 2, trace::Isa::Auto);
    const auto sum = [&](int x, int y) { return out.at(x, y)[0] + out.at(x, y)[1] + out.at(x, y)[2]; };
    CHECK(sum(9, 10) == 0.0f);
    CHECK(sum(20, 10) == 0.0f);
    CHECK(sum(10, 5) > 0.0f);
    CHECK(sum(19, 14) > 0.0f);
}
