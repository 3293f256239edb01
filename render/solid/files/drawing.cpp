#include "render/solid/files/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace solid {
namespace {

constexpr double kDrawingMargin = 0.02,
                 kLineWidth = 0.002;       // of the longest side: about the drawing, width of its lines
constexpr std::size_t kLongestLayer = 31;  // characters of a layer's name in release 12

struct Frame {
    glm::dvec2 lower{0.0}, upper{1.0};
    double longest() const { return std::max(upper.x - lower.x, upper.y - lower.y); }
};

Frame frame_of(const std::vector<DrawnPart>& parts)
{
    Frame out;
    bool any = false;
    for (const DrawnPart& part : parts)
        for (const Loop& loop : part.loops)
            for (const glm::dvec2& p : loop) {
                out.lower = any ? glm::min(out.lower, p) : p;
                out.upper = any ? glm::max(out.upper, p) : p;
                any = true;
            }
    return out;
}

/// A multiple of a power of ten that is at most `exact`, without zeros at its end.
std::string decimal(double value, double exact)
{
    const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(exact))), 0, 15);
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else out += static_cast<unsigned char>(c) < ' ' ? '_' : c;
    }
    return out;
}

/// `name`, or with a number behind it where that is taken.
std::string unused(std::string name, std::size_t longest, std::set<std::string>& taken)
{
    name.resize(std::min(name.size(), longest));
    std::string tried = name;
    for (int i = 2; !taken.insert(tried).second; ++i) {
        const std::string end = fmt::format("_{}", i);
        tried = name.substr(0, std::min(name.size(), longest - end.size())) + end;
    }
    return tried;
}

std::string hex(const std::array<double, 3>& color)
{
    std::string out = "#";
    for (const double c : color) out += fmt::format("{:02x}", std::lround(255.0 * std::clamp(c, 0.0, 1.0)));
    return out;
}

/// The nearest of the colours that have one number in every program; 7 is white or black, whatever shows.
int color_decimal(const std::array<double, 3>& color)
{
    constexpr std::array<std::array<double, 3>, 9> kColors{{{1, 0, 0},
                                                            {1, 1, 0},
                                                            {0, 1, 0},
                                                            {0, 1, 1},
                                                            {0, 0, 1},
                                                            {1, 0, 1},
                                                            {1, 1, 1},
                                                            {0.5, 0.5, 0.5},
                                                            {0.75, 0.75, 0.75}}};
    std::size_t best = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < kColors.size(); ++i) {
        double off = 0.0;
        for (std::size_t k = 0; k < 3; ++k) off += (color[k] - kColors[i][k]) * (color[k] - kColors[i][k]);
        if (off >= least) continue;
        least = off;
        best = i;
    }
    return static_cast<int>(best) + 1;
}

/// Release 12 allows capitals, digits, '$', '_' and '-'.
std::vector<std::string> layers_of(const std::vector<DrawnPart>& parts)
{
    std::vector<std::string> out;
    std::set<std::string> taken{"0"};  // every drawing has it
    for (const DrawnPart& part : parts) {
        std::string name;
        for (const char c : part.name) {
            const auto byte = static_cast<unsigned char>(c);
            const bool plain = byte < 128 && (std::isalnum(byte) != 0 || c == '_' || c == '-' || c == '$');
            name += plain ? static_cast<char>(std::toupper(byte)) : '_';
        }
        out.push_back(unused(name.empty() ? "PART" : name, kLongestLayer, taken));
    }
    return out;
}

/// A group's code and its value, a line each.
void put_group(std::string& out, int code, const std::string& value) { out += fmt::format("{:>3}\n{}\n", code, value); }

void put_point(std::string& out, const glm::dvec2& p, double exact, int code = 10)
{
    put_group(out, code, decimal(p.x, exact));
    put_group(out, code + 10, decimal(p.y, exact));
    put_group(out, code + 20, "0");
}

void put_head(std::string& out, const std::vector<DrawnPart>& parts, const std::vector<std::string>& layers,
              double exact)
{
    const Frame frame = frame_of(parts);
    for (const auto& [code, value] : {std::pair(0, "SECTION"), {2, "HEADER"}, {9, "$ACADVER"}, {1, "AC1009"}})
        put_group(out, code, value);
    put_group(out, 9, "$EXTMIN");
    put_point(out, frame.lower, exact);
    put_group(out, 9, "$EXTMAX");
    put_point(out, frame.upper, exact);
    for (const auto& [code, value] : {std::pair(0, "ENDSEC"),
                                      {0, "SECTION"},
                                      {2, "TABLES"},
                                      {0, "TABLE"},
                                      {2, "LTYPE"},
                                      {70, "1"},
                                      {0, "LTYPE"},
                                      {2, "CONTINUOUS"},
                                      {70, "0"},
                                      {3, "Solid line"},
                                      {72, "65"},
                                      {73, "0"},
                                      {40, "0"},
                                      {0, "ENDTAB"},
                                      {0, "TABLE"},
                                      {2, "LAYER"}})
        put_group(out, code, value);
    put_group(out, 70, fmt::format("{}", layers.size()));
    for (std::size_t i = 0; i < layers.size(); ++i) {
        put_group(out, 0, "LAYER");
        put_group(out, 2, layers[i]);
        put_group(out, 70, "0");
        put_group(out, 62, fmt::format("{}", color_decimal(parts[i].color)));
        put_group(out, 6, "CONTINUOUS");
    }
    for (const auto& [code, value] : {std::pair(0, "ENDTAB"), {0, "ENDSEC"}}) put_group(out, code, value);
}

}  // namespace

DrawingFormat drawing_format_of(const std::string& path)
{
    std::string end = std::filesystem::path(path).extension().string();
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
    if (end == ".svg") return DrawingFormat::Svg;
    if (end == ".dxf") return DrawingFormat::Dxf;
    throw std::runtime_error(fmt::format("a cut is written as .svg or .dxf, not as '{}'", path));
}

std::string svg_text(const std::vector<DrawnPart>& parts, const std::string& title, double exact)
{
    const Frame frame = frame_of(parts);
    const double margin = kDrawingMargin * frame.longest();
    const glm::dvec2 size = frame.upper - frame.lower + 2.0 * margin;
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} "
                       "{0} {1}\">\n<title>{4}</title>\n",
                       decimal(size.x, exact), decimal(size.y, exact), decimal(frame.lower.x - margin, exact),
                       decimal(-frame.upper.y - margin, exact), escaped(title));
    // Numbers within are those of the scene, where y goes up.
    out += fmt::format("<g transform=\"scale(1 -1)\" fill-rule=\"evenodd\" stroke=\"#000000\" stroke-width=\"{}\" "
                       "stroke-linejoin=\"round\">\n",
                       decimal(kLineWidth * frame.longest(), 1e-3 * kLineWidth * frame.longest()));
    std::set<std::string> taken;
    for (const DrawnPart& part : parts) {
        std::string id = part.name;
        std::replace_if(
            id.begin(), id.end(), [](unsigned char c) { return c <= ' '; }, '_');
        out += fmt::format("<g id=\"{}\" fill=\"{}\">\n<title>{}</title>\n<path d=\"", escaped(unused(id, 200, taken)),
                           hex(part.color), escaped(part.name));
        for (const Loop& loop : part.loops) {
            const char* before = "M";
            for (const glm::dvec2& p : loop) {
                out += fmt::format("{}{} {}", before, decimal(p.x, exact), decimal(p.y, exact));
                before = "\nL";
            }
            out += "Z\n";
        }
        out += "\"/>\n</g>\n";
    }
    return out + "</g>\n</svg>\n";
}

std::string dxf_text(const std::vector<DrawnPart>& parts, double exact)
{
    std::string out;
    const std::vector<std::string> layers = layers_of(parts);
    put_head(out, parts, layers, exact);
    put_group(out, 0, "SECTION");
    put_group(out, 2, "ENTITIES");
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (const Loop& loop : parts[i].loops) {
            put_group(out, 0, "POLYLINE");
            put_group(out, 8, layers[i]);
            put_group(out, 66, "1");  // vertices follow
            put_point(out, {0, 0}, exact);
            put_group(out, 70, "1");  // closed
            for (const glm::dvec2& p : loop) {
                put_group(out, 0, "VERTEX");
                put_group(out, 8, layers[i]);
                put_point(out, p, exact);
            }
            put_group(out, 0, "SEQEND");
            put_group(out, 8, layers[i]);
        }
    put_group(out, 0, "ENDSEC");
    put_group(out, 0, "EOF");
    return out;
}

}  // namespace solid
