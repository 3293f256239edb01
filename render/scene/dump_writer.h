#pragma once

#include "render/scene/description.h"

#include <string>
#include <string_view>

namespace scene {

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
    std::string take() { return std::move(text_); }

private:
    std::string text_;
    int depth_ = 0;
};

std::string text(double v);
std::string text(float v);
std::string text(const glm::dvec3& v);
std::string text(const Color& c);

void dump(DumpWriter& out, const Pigment& pigment);
void dump(DumpWriter& out, const Normal& normal);
void dump(DumpWriter& out, const Texture& texture);
void dump(DumpWriter& out, const Interior& interior);
void dump(DumpWriter& out, const Turbulence& turbulence);
void dump(DumpWriter& out, const Object& object);
void dump(DumpWriter& out, const Statement& statement);

}  // namespace scene
