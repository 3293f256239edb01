#include "render/model/three_mf_reader.h"

#include "render/model/base/text_words.h"
#include "render/model/base/xml_scanner.h"
#include "render/model/base/zip_reader.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <map>
#include <unordered_map>

namespace model {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A list of colours that triangles point into.
struct Group {
    bool materials = false;  ///< places of the model's materials; else of its colours
    std::uint32_t first = 0, count = 0;
};
struct Component {
    std::string path;
    std::uint32_t object = 0;
    glm::dmat4 transform{1.0};
};
struct Object {
    std::vector<glm::dvec3> vertices;
    std::vector<Model::Face> faces;  ///< vertices counted within the object
    std::vector<Component> components;
    std::optional<std::uint32_t> group;
    std::uint32_t place = 0;  ///< in that
};
/// One XML file of the package.
struct Part {
    double millimetres = 1.0;  ///< in its unit
    std::unordered_map<std::uint32_t, Object> objects;
    std::unordered_map<std::uint32_t, Group> groups;
    std::vector<Component> build;
};

template <class Number>
Number number_in(const XmlScanner& xml, std::string_view text)
{
    try {
        TextWords words(text);
        const Number value = words.number<Number>();
        if (words.next().empty()) return value;
    } catch (const ModelError&) {}
    xml.fail("'" + shortened(text) + "' is no number that can stand here");
}

template <class Number>
Number number_of(const XmlScanner& xml, std::string_view name)
{
    const auto text = xml.attribute(name);
    if (!text) xml.fail("'" + std::string(xml.name()) + "' has no " + std::string(name));
    return number_in<Number>(xml, *text);
}

template <class Number>
std::optional<Number> number_if(const XmlScanner& xml, std::string_view name)
{
    const auto text = xml.attribute(name);
    return text ? std::optional(number_in<Number>(xml, *text)) : std::nullopt;
}

/// Twelve numbers, row by row of a matrix that stands behind its points.
glm::dmat4 transform_of(const XmlScanner& xml)
{
    glm::dmat4 out(1.0);
    const auto text = xml.attribute("transform");
    if (!text) return out;
    try {
        TextWords words(*text);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 3; ++column) out[row][column] = words.number<double>();
    } catch (const ModelError&) {
        xml.fail("a transform has twelve numbers");
    }
    return out;
}

/// #RRGGBB or #RRGGBBAA, sRGB.
glm::vec4 color_of(const XmlScanner& xml, std::string_view name)
{
    const std::string_view text = xml.attribute(name).value_or("");
    glm::vec4 out(1.0f);
    bool good = (text.size() == 7 || text.size() == 9) && text[0] == '#';
    for (std::size_t i = 1; good && i < text.size(); i += 2) {
        unsigned value = 0;
        const auto [end, failed] = std::from_chars(&text[i], &text[i] + 2, value, 16);
        good = failed == std::errc() && end == &text[i] + 2;
        out[static_cast<glm::length_t>(i / 2)] = static_cast<float>(value) / 255.0f;
    }
    if (!good) xml.fail("'" + shortened(text) + "' is no colour, as #RRGGBB is one");
    return out;
}

double millimetres_of(const XmlScanner& xml)
{
    constexpr std::pair<std::string_view, double> kUnits[] = {{"micron", 0.001},    {"millimeter", 1.0},
                                                              {"centimeter", 10.0}, {"inch", 25.4},
                                                              {"foot", 304.8},      {"meter", 1000.0}};
    const std::string_view unit = xml.attribute("unit").value_or("millimeter");
    for (const auto& [name, millimetres] : kUnits)
        if (name == unit) return millimetres;
    xml.fail("there is no unit '" + shortened(unit) + "'");
}

/// Reads one XML file; colours go to the model.
class PartReader {
public:
    PartReader(std::string_view text, Model& model) : xml_(text), model_(model) {}

    Part read()
    {
        bool whole = false;
        while (xml_.next()) {
            whole = whole || (xml_.closes() && xml_.name() == "model");
            if (xml_.opens()) open();
        }
        if (!whole) xml_.fail("it ends before </model>");
        return std::move(part_);
    }

private:
    void open()
    {
        const std::string_view name = xml_.name();
        if (name == "vertex")
            object().vertices.emplace_back(number_of<double>(xml_, "x"), number_of<double>(xml_, "y"),
                                           number_of<double>(xml_, "z"));
        else if (name == "triangle") triangle();
        else if (name == "model") part_.millimetres = millimetres_of(xml_);
        else if (name == "object") begin_object();
        else if (name == "basematerials") begin_group(true);
        else if (name == "colorgroup") begin_group(false);
        else if (name == "base") base();
        else if (name == "color" && group_ && !group_->materials) color();
        else if (name == "component") object().components.push_back(component());
        else if (name == "item") part_.build.push_back(component());
    }
    Object& object()
    {
        if (!object_) xml_.fail("'" + std::string(xml_.name()) + "' stands in no object");
        return *object_;
    }
    void begin_object()
    {
        Object made;
        made.group = number_if<std::uint32_t>(xml_, "pid");
        made.place = number_if<std::uint32_t>(xml_, "pindex").value_or(0);
        const auto [at, fresh] = part_.objects.try_emplace(number_of<std::uint32_t>(xml_, "id"), std::move(made));
        if (!fresh) xml_.fail("there are two objects of this id");
        object_ = &at->second;
    }
    void begin_group(bool materials)
    {
        const std::size_t first = materials ? model_.materials.size() : model_.colors.size();
        group_ = &part_.groups[number_of<std::uint32_t>(xml_, "id")];
        *group_ = {materials, static_cast<std::uint32_t>(first), 0};
    }
    void base()
    {
        if (!group_ || !group_->materials) xml_.fail("'base' stands in no basematerials");
        Model::Material& material = model_.materials.emplace_back();
        material.name = xml_.text("name");
        material.told = true;
        const glm::vec4 shown = color_of(xml_, "displaycolor");
        material.color = glm::vec3(shown);
        material.opacity = shown.w;
        ++group_->count;
    }
    void color()
    {
        model_.colors.emplace_back(color_of(xml_, "color"));
        ++group_->count;
    }
    void triangle()
    {
        Object& of = object();
        Model::Face face;
        constexpr std::string_view kCorners[] = {"v1", "v2", "v3"}, kPlaces[] = {"p1", "p2", "p3"};
        for (std::size_t k = 0; k < 3; ++k) {
            face.vertex[k] = number_of<std::uint32_t>(xml_, kCorners[k]);
            if (face.vertex[k] >= of.vertices.size())
                xml_.fail("there is no vertex " + std::to_string(face.vertex[k]) + ": " +
                          std::to_string(of.vertices.size()) + " are above");
        }
        const auto own = xml_.attribute("p1") ? number_if<std::uint32_t>(xml_, "pid") : std::nullopt;
        const auto group_id = own ? own : of.group;
        const auto group = group_id ? part_.groups.find(*group_id) : part_.groups.end();
        if (group != part_.groups.end()) {  // else of an extension
            Corners place{of.place, of.place, of.place};
            for (std::size_t k = 0; k < 3 && xml_.attribute("p1"); ++k)
                place[k] = number_if<std::uint32_t>(xml_, kPlaces[k]).value_or(k == 0 ? 0 : place[0]);
            for (std::uint32_t& one : place) {
                if (one >= group->second.count)
                    xml_.fail("its colour " + std::to_string(one) + " is none of " +
                              std::to_string(group->second.count));
                one += group->second.first;
            }
            if (group->second.materials) face.material = place[0];
            else face.color = place;
        }
        if (face.vertex[0] == face.vertex[1] || face.vertex[1] == face.vertex[2] || face.vertex[0] == face.vertex[2])
            return;
        of.faces.push_back(face);
    }
    Component component()
    {
        return {xml_.text("path"), number_of<std::uint32_t>(xml_, "objectid"), transform_of(xml_)};
    }

    XmlScanner xml_;
    Model& model_;
    Part part_;
    Object* object_ = nullptr;
    Group* group_ = nullptr;
};

class ThreeMf {
public:
    explicit ThreeMf(std::string_view bytes) : zip_(bytes), most_(4096 + 16 * bytes.size()) {}

    Model read()
    {
        const std::string root = root_path();
        const double millimetres = part(root).millimetres;
        // A copy: parts that are read on the way move those that are there.
        const std::vector<Component> build = part(root).build;
        for (const Component& item : build) show(root, item, glm::scale(glm::dmat4(1.0), glm::dvec3(millimetres)));
        if (model_.faces.empty()) throw ModelError("its build has no triangles", 0);
        return std::move(model_);
    }

private:
    static std::string without_slash(const std::string& path) { return path.starts_with('/') ? path.substr(1) : path; }

    /// The relation that every package has names it.
    std::string root_path()
    {
        constexpr const char* kRelations = "_rels/.rels";
        if (!zip_.has(kRelations)) throw ModelError("it is a ZIP file, but no 3MF file: it has no '_rels/.rels'", 0);
        const std::string text = zip_.read(kRelations);
        XmlScanner xml(text);
        while (xml.next())
            if (xml.opens() && xml.name() == "Relationship" && xml.attribute("Type").value_or("").ends_with("/3dmodel"))
                return without_slash(xml.text("Target"));
        throw ModelError("it is a ZIP file, but no 3MF file: nothing in it is a model", 0);
    }

    const Part& part(const std::string& path)
    {
        const auto known = parts_.find(path);
        if (known != parts_.end()) return known->second;
        const std::string text = zip_.read(path);
        most_ = std::max(most_, text.size());
        try {
            return parts_.emplace(path, PartReader(text, model_).read()).first->second;
        } catch (const ModelError& error) {
            throw ModelError("'" + path + "', line " + std::to_string(error.line) + ": " + error.what(), 0);
        }
    }

    /// An object and what it is made of, one after the other.
    void show(const std::string& root, const Component& item, const glm::dmat4& to_scene)
    {
        struct Waiting {
            std::string path;
            std::uint32_t object;
            glm::dmat4 to_scene;
            int depth;
        };
        constexpr int kDeepest = 64;
        std::vector<Waiting> waiting{
            {item.path.empty() ? root : without_slash(item.path), item.object, to_scene * item.transform, 0}};
        while (!waiting.empty()) {
            const Waiting now = std::move(waiting.back());
            waiting.pop_back();
            const Part& of = part(now.path);
            const auto found = of.objects.find(now.object);
            if (found == of.objects.end())
                throw ModelError("'" + now.path + "': there is no object " + std::to_string(now.object), 0);
            const Object& object = found->second;
            visited_ += 1 + object.components.size();
            if (now.depth > kDeepest || visited_ > most_ || model_.faces.size() + object.faces.size() > most_ ||
                model_.vertices.size() + object.vertices.size() > most_)
                throw ModelError("'" + now.path + "': object " + std::to_string(now.object) +
                                     " is shown too often for a file of this size",
                                 0);
            add(object, now.to_scene);
            for (auto one = object.components.rbegin(); one != object.components.rend(); ++one)
                waiting.push_back({one->path.empty() ? now.path : without_slash(one->path), one->object,
                                   now.to_scene * one->transform, now.depth + 1});
        }
    }

    void add(const Object& object, const glm::dmat4& to_scene)
    {
        const auto first = static_cast<std::uint32_t>(model_.vertices.size());
        for (const glm::dvec3& v : object.vertices) {
            const glm::dvec4 p = to_scene * glm::dvec4(v, 1.0);
            if (!std::isfinite(p.x + p.y + p.z)) throw ModelError("a vertex is out of all bounds", 0);
            model_.vertices.emplace_back(p.x, p.z, p.y);
        }
        const bool keep = glm::determinant(glm::dmat3(to_scene)) < 0.0;  // axes that change places turn all round once
        for (Model::Face face : object.faces) {
            if (!keep) {
                std::swap(face.vertex[1], face.vertex[2]);
                std::swap(face.color[1], face.color[2]);
            }
            for (std::uint32_t& one : face.vertex) one += first;
            model_.faces.push_back(face);
        }
    }

    ZipReader zip_;
    std::size_t most_, visited_ = 0;
    std::map<std::string, Part> parts_;
    Model model_;
};

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with(std::string_view("PK\3\4", 4)); }

Model three_mf_of(std::string_view bytes) { return ThreeMf(bytes).read(); }

}  // namespace model
