#include "render/solid/files/three_mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#include <cstdio>
#include <string>

namespace {

using namespace NMR;

constexpr DWORD kMillimetres = MODELUNIT_MILLIMETER;

/// Releases what it holds.
template <class T>
class Held {
public:
    ~Held()
    {
        if (thing_ != nullptr) lib3mf_release(thing_);
    }
    T** place() { return &thing_; }
    T* get() const { return thing_; }

private:
    T* thing_ = nullptr;
};

bool failed(LIB3MFRESULT result) { return result != LIB3MF_OK; }

/// Null where all went well, else what did not.
const char* add(PLib3MFModel* model, PLib3MFModelBaseMaterial* materials, const solid::ThreeMfPart& part)
{
    DWORD material = 0, group = 0;
    if (failed(lib3mf_basematerial_addmaterialutf8(materials, part.name, part.color[0], part.color[1], part.color[2],
                                                   &material)) ||
        failed(lib3mf_basematerial_setdisplaycolorrgba(materials, material, part.color[0], part.color[1], part.color[2],
                                                       255)) ||
        failed(lib3mf_resource_getresourceid(materials, &group)))
        return "a colour";
    Held<PLib3MFModelMeshObject> object;
    if (failed(lib3mf_model_addmeshobject(model, object.place()))) return "an object";
    if (failed(lib3mf_object_setnameutf8(object.get(), part.name))) return "a name";
    static_assert(sizeof(MODELMESHVERTEX) == 12 && sizeof(MODELMESHTRIANGLE) == 12);
    std::vector<MODELMESHVERTEX> vertices(part.vertex_count);
    std::vector<MODELMESHTRIANGLE> triangles(part.triangle_count);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) vertices[i].m_fPosition[k] = part.vertices[3 * i + k];
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) triangles[i].m_nIndices[k] = part.triangles[3 * i + k];
    if (failed(lib3mf_meshobject_setgeometry(object.get(), vertices.data(), part.vertex_count, triangles.data(),
                                             part.triangle_count)))
        return "triangles";
    BOOL closed = 0;
    if (failed(lib3mf_meshobject_ismanifoldandoriented(object.get(), &closed)) || !closed)
        return "triangles that do not close";
    Held<PLib3MFDefaultPropertyHandler> properties;
    if (failed(lib3mf_object_createdefaultpropertyhandler(object.get(), properties.place())) ||
        failed(lib3mf_defaultpropertyhandler_setbasematerial(properties.get(), group, material)))
        return "the colour of an object";
    if (part.colors != nullptr) {  // a colour for each corner of a triangle, mixed in between
        Held<PLib3MFPropertyHandler> corners;
        if (failed(lib3mf_meshobject_createpropertyhandler(object.get(), corners.place())))
            return "colours of vertices";
        for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
            MODELMESH_TRIANGLECOLOR_SRGB all{};
            for (std::size_t k = 0; k < 3; ++k) {
                const unsigned char* own = part.colors + 3 * std::size_t{part.triangles[3 * t + k]};
                all.m_Colors[k].m_Red = own[0];
                all.m_Colors[k].m_Green = own[1];
                all.m_Colors[k].m_Blue = own[2];
                all.m_Colors[k].m_Alpha = 255;
            }
            if (failed(lib3mf_propertyhandler_setgradientcolor(corners.get(), t, &all)))
                return "the colour of a vertex";
        }
    }
    Held<PLib3MFModelBuildItem> item;
    if (failed(lib3mf_model_addbuilditem(model, object.get(), nullptr, item.place()))) return "an item to build";
    return nullptr;
}

const char* write(const char* path, const solid::ThreeMfPart* parts, std::uint32_t count)
{
    Held<PLib3MFModel> model;
    if (failed(lib3mf_createmodel(model.place()))) return "a model";
    if (failed(lib3mf_model_setunit(model.get(), kMillimetres))) return "the unit";
    Held<PLib3MFModelBaseMaterial> materials;
    if (failed(lib3mf_model_addbasematerialgroup(model.get(), materials.place()))) return "colours";
    for (std::uint32_t i = 0; i < count; ++i)
        if (const char* what = add(model.get(), materials.get(), parts[i])) return what;
    Held<PLib3MFModelWriter> writer;
    if (failed(lib3mf_model_querywriter(model.get(), "3mf", writer.place()))) return "a writer";
    if (failed(lib3mf_writer_writetofileutf8(writer.get(), path))) return "the file";
    return nullptr;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] bool whittle_write_3mf(const char* path, const solid::ThreeMfPart* parts,
                                                                 std::uint32_t count, char* reason, std::uint32_t room)
{
    const char* const what = write(path, parts, count);
    if (what != nullptr) std::snprintf(reason, room, "lib3mf refused %s", what);
    return what == nullptr;
}
