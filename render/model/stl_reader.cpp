#include "render/model/stl_reader.h"

#include "render/model/base/text_words.h"
#include "render/model/base/vertex_merger.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace model {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of binary STL are read as they lie in memory");

constexpr std::size_t kStlHead = 84, kStlTriangle = 50, kStlNormal = 12;

std::size_t told(std::string_view bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kStlHead - sizeof count, sizeof count);
    return count;
}

Model finished(const VertexMerger& merger, std::vector<Model::Face> faces)
{
    if (faces.empty()) throw ModelError("it has no triangles", 0);
    Model model;
    model.faces = std::move(faces);
    model.vertices.reserve(merger.points().size());
    for (const glm::vec3& p : merger.points()) model.vertices.emplace_back(p.x, p.z, p.y);
    return model;
}

/// The sense of turning goes with the axes that change places.
Model::Face face_of(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    Model::Face face;
    face.vertex = {a, c, b};
    return face;
}

Model binary(std::string_view bytes)
{
    if (bytes.size() < kStlHead)
        throw ModelError::at_byte("it ends before its number of triangles, which stands at byte 80", bytes.size());
    const std::size_t count = told(bytes), there = (bytes.size() - kStlHead) / kStlTriangle;
    if (there < count)
        throw ModelError::at_byte(
            "it ends within triangle " + std::to_string(there + 1) + " of " + std::to_string(count), bytes.size());
    if (bytes.size() > kStlHead + count * kStlTriangle)
        throw ModelError::at_byte("something stands behind the last of its " + std::to_string(count) + " triangles",
                                  kStlHead + count * kStlTriangle);
    VertexMerger merger(count / 2 + 2);  // as closed meshes have
    std::vector<Model::Face> faces;
    faces.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = kStlHead + i * kStlTriangle + kStlNormal;
        glm::vec3 corner[3];
        std::memcpy(corner, bytes.data() + at, sizeof corner);
        std::uint32_t number[3];
        for (std::size_t k = 0; k < 3; ++k) {
            for (int axis = 0; axis < 3; ++axis)
                if (!std::isfinite(corner[k][axis]))
                    throw ModelError::at_byte("a coordinate of triangle " + std::to_string(i + 1) + " is no number",
                                              at + k * sizeof corner[k] + 4 * static_cast<std::size_t>(axis));
            number[k] = merger.number(corner[k]);
        }
        faces.push_back(face_of(number[0], number[1], number[2]));
    }
    return finished(merger, std::move(faces));
}

class StlText {
public:
    explicit StlText(std::string_view text) : words_(text) {}

    Model read()
    {
        bool open = false;
        for (;;) {
            const std::string_view word = words_.next();
            if (word.empty()) break;
            if (is(word, "solid")) open = true, words_.skip_line();
            else if (is(word, "endsolid")) open = false, words_.skip_line();
            else if (is(word, "facet")) facet();
            else words_.fail("expected 'facet' or 'endsolid', found '" + shortened(word) + "'");
        }
        if (open) words_.fail("it ends without 'endsolid'");
        return finished(merger_, std::move(faces_));
    }

private:
    static bool is(std::string_view word, std::string_view lower)
    {
        return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                          [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; });
    }
    void expect(std::string_view what)
    {
        const std::string_view word = words_.next();
        if (!is(word, what))
            words_.fail("expected '" + std::string(what) + "', found " +
                        (word.empty() ? std::string("the end") : "'" + shortened(word) + "'"));
    }
    /// Behind `facet`: `normal x y z` is not looked at.
    void facet()
    {
        words_.skip_line();
        expect("outer");
        expect("loop");
        std::uint32_t number[3];
        for (std::uint32_t& one : number) {
            expect("vertex");
            glm::vec3 p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = words_.number<float>();
            one = merger_.number(p);
        }
        expect("endloop");
        expect("endfacet");
        faces_.push_back(face_of(number[0], number[1], number[2]));
    }

    TextWords words_;
    VertexMerger merger_{0};
    std::vector<Model::Face> faces_;
};

}  // namespace

bool is_binary_stl(std::string_view bytes)
{
    return bytes.size() >= kStlHead && bytes.size() == kStlHead + told(bytes) * kStlTriangle;
}

Model stl_of(std::string_view bytes)
{
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    // Some writers of binary files begin them with `solid` too.
    const bool text = !is_binary_stl(bytes) && bytes.substr(first, 5) == "solid" &&
                      bytes.find('\0') == std::string_view::npos;
    return text ? StlText(bytes).read() : binary(bytes);
}

}  // namespace model
