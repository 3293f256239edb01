#include "render/scene/base/dump_writer.h"

#include "function/build/listing.h"

#include <fmt/format.h>

#include <iterator>

namespace scene {

// -0 and 0 are the same fact.
std::string text(double v) { return fmt::format("{}", v == 0.0 ? 0.0 : v); }

std::string text(float v) { return fmt::format("{}", v == 0.0f ? 0.0f : v); }

std::string text(int v) { return fmt::format("{}", v); }

std::string text(const glm::dvec2& v) { return fmt::format("<{}, {}>", text(v.x), text(v.y)); }

std::string text(const glm::dvec3& v) { return fmt::format("<{}, {}, {}>", text(v.x), text(v.y), text(v.z)); }

std::string text(const glm::dvec4& v)
{
    return fmt::format("<{}, {}, {}, {}>", text(v.x), text(v.y), text(v.z), text(v.w));
}

std::string text(const std::string& v) { return '"' + v + '"'; }

std::string text(const Color& c)
{
    return fmt::format("<{}, {}, {}, {}, {}>", text(c.red), text(c.green), text(c.blue), text(c.filter),
                       text(c.transmit));
}

void DumpWriter::open(std::string_view title)
{
    fmt::format_to(std::back_inserter(text_), "{:{}}{} {{\n", "", 2 * depth_, title);
    ++depth_;
}

void DumpWriter::close()
{
    --depth_;
    fmt::format_to(std::back_inserter(text_), "{:{}}}}\n", "", 2 * depth_);
}

void DumpWriter::line(std::string_view name, std::string_view value)
{
    fmt::format_to(std::back_inserter(text_), "{:{}}{} {}\n", "", 2 * depth_, name, value);
}

void DumpWriter::steps(const function::FunctionPtr& made)
{
    open("function");
    for (const std::string& step : function::listing(*made)) line("step", step);
    close();
}

void DumpWriter::value(std::string_view name, double v) { line(name, text(v)); }

void DumpWriter::value(std::string_view name, const glm::dvec3& v) { line(name, text(v)); }

void DumpWriter::value(std::string_view name, const glm::vec3& v)
{
    line(name, fmt::format("<{}, {}, {}>", text(v.x), text(v.y), text(v.z)));
}

void DumpWriter::value(std::string_view name, const Color& c) { line(name, text(c)); }

void DumpWriter::flag(std::string_view name, bool v) { line(name, v ? "on" : "off"); }

void DumpWriter::value(std::string_view name, const csg::Transform& t)
{
    // Rows as in POV-Ray's `matrix`: the images of x, y, z, then the translation.
    line(name, fmt::format("{} {} {} {}", text(t.linear[0]), text(t.linear[1]), text(t.linear[2]), text(t.offset)));
}

}  // namespace scene
