#pragma once

#include "parser/lexer/token.h"

#include <cstdint>
#include <vector>

namespace parser {

/// Lists of literal numbers that bodies of meshes are made of. The lexer turns one into a single token, Kind::Numbers,
/// whose values lie in SourceFile::numbers: no token a number. Text that is not just such a list - names, operators,
/// comments between the braces, another count than it says - becomes tokens as all other text does.
struct NumberList {
    std::uint32_t items = 0;   ///< vectors
    std::uint32_t stride = 0;  ///< values of each; 0: faces, each with the number of its values before them
};

/// Values of a triangle and of a smooth one among Kind::Faces.
inline constexpr std::size_t kFlatFace = 9, kSmoothFace = 18;

/// Of a face without textures of its own.
inline constexpr double kNoTexture = -1.0;

/// Whether `{` behind this word may begin such a list.
constexpr bool begins_numbers(Kind keyword)
{
    return keyword == Kind::Mesh || keyword == Kind::Triangle || keyword == Kind::SmoothTriangle ||
           keyword == Kind::VertexVectors || keyword == Kind::NormalVectors || keyword == Kind::UvVectors ||
           keyword == Kind::FaceIndices || keyword == Kind::NormalIndices || keyword == Kind::UvIndices;
}

/// Reads the list from `at`, behind the brace, up to its end: behind the last corner of a triangle, at the closing
/// brace of a list, behind the last of the triangles that a mesh begins with (those that have nothing but corners).
/// Values are added to `values`; a face that names textures has six, three indices and the numbers of its textures or
/// kNoTexture (all faces of its list then). Returns where it ends; null, with nothing added: it is no such list.
/// `first`: where its first number or '<', or the first triangle, stands.
const char* read_number_list(Kind keyword, const char* at, const char* end, std::vector<double>& values,
                             NumberList& list, const char*& first);

}  // namespace parser
