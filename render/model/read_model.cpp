#include "render/model/read_model.h"

#include "render/model/glb_reader.h"
#include "render/model/obj_reader.h"
#include "render/model/ply_reader.h"
#include "render/model/stl_reader.h"
#include "render/model/three_mf_reader.h"

#include <algorithm>
#include <cctype>

namespace model {
namespace {

bool ends_in(std::string_view name, std::string_view lower)
{
    if (name.size() < lower.size()) return false;
    name.remove_prefix(name.size() - lower.size());
    return std::equal(name.begin(), name.end(), lower.begin(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

/// `solid` at the start, and behind that line something that only STL has.
bool is_stl_text(std::string_view bytes)
{
    constexpr std::size_t kLooked = 1000;
    const std::string_view start = bytes.substr(0, kLooked);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || start.substr(first, 5) != "solid") return false;
    return start.find("facet") != std::string_view::npos || start.find("endsolid") != std::string_view::npos;
}

}  // namespace

Model model_of(std::string_view bytes, std::string_view name)
{
    if (is_glb(bytes)) return glb_of(bytes);
    if (is_zip(bytes)) return three_mf_of(bytes);
    if (is_ply(bytes)) return ply_of(bytes);
    if (is_binary_stl(bytes) || is_stl_text(bytes)) return stl_of(bytes);
    if (ends_in(name, ".stl")) return stl_of(bytes);
    if (ends_in(name, ".obj")) return obj_of(bytes);
    if (ends_in(name, ".ply")) return ply_of(bytes);
    if (ends_in(name, ".gltf"))
        throw ModelError("glTF is read where all of it is in one file, which is named .glb: most programs write both",
                         0);
    throw ModelError("neither its bytes nor its name say what kind of file it is: .stl, .ply, .glb, .3mf, .obj", 0);
}

}  // namespace model
