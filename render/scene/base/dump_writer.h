#pragma once

#include "csg/base/types.h"
#include "function/program.h"
#include "render/scene/base/color.h"

#include <string>
#include <string_view>

namespace scene {

struct Interior;
struct Normal;
struct Object;
struct Pigment;
struct Texture;
struct Turbulence;

std::string text(double v);
std::string text(float v);
std::string text(int v);
std::string text(const glm::dvec2& v);
std::string text(const glm::dvec3& v);
std::string text(const glm::dvec4& v);
std::string text(const Color& c);
/// In quotation marks.
std::string text(const std::string& v);

/// Indented lines of text: `name value`. Numbers are printed with the fewest digits that read back the same.
class DumpWriter {
public:
    /// Opens `title {`; close() ends it.
    void open(std::string_view title);
    void close();
    void line(std::string_view name, std::string_view value);
    void value(std::string_view name, double v);
    void value(std::string_view name, const glm::dvec3& v);
    void value(std::string_view name, const glm::vec3& v);
    void value(std::string_view name, const Color& c);
    void flag(std::string_view name, bool v);
    void value(std::string_view name, const csg::Transform& t);
    /// The name alone.
    void word(std::string_view name) { line(name, {}); }
    /// Values one after the other on the name's line.
    template <class... Values>
    void words(std::string_view name, const Values&... values)
    {
        std::string all;
        (join(all, text(values)), ...);
        line(name, all);
    }
    template <class Values>
    void list(std::string_view name, const Values& values)
    {
        std::string all;
        for (const auto& v : values) join(all, text(v));
        line(name, all);
    }
    /// A line for what is not as it usually is.
    template <class Value>
    void changed(std::string_view name, const Value& v, const Value& usual)
    {
        if (v != usual) words(name, v);
    }
    /// The steps of a user function.
    void steps(const function::FunctionPtr& made);
    /// Below a name.
    void steps(std::string_view name, const function::FunctionPtr& made)
    {
        word(name);
        steps(made);
    }
    std::string take() { return std::move(text_); }

private:
    static void join(std::string& all, const std::string& one)
    {
        if (!all.empty()) all += ' ';
        all += one;
    }
    std::string text_;
    int depth_ = 0;
};

void dump(DumpWriter& out, const Pigment& pigment);
void dump(DumpWriter& out, const Normal& normal);
void dump(DumpWriter& out, const Texture& texture);
void dump(DumpWriter& out, const Interior& interior);
void dump(DumpWriter& out, const Turbulence& turbulence);
/// default_texture: of a top-level object.
void dump(DumpWriter& out, const Object& object, const Texture* default_texture = nullptr);

}  // namespace scene
