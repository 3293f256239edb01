#pragma once

#include "parser/form/form.h"
#include "render/scene/object.h"

#include <optional>
#include <string_view>
#include <vector>

namespace parser {

/// How a solid of a few numbers is written, and what they make.
struct SolidForm {
    Kind keyword;
    std::string_view values;  ///< v: a vector, n: a number; commas between them may be left out
    bool may_be_open;
    /// `v`: the components of all values. False: there is something to say about them, nothing was done.
    bool (*set)(const double* v, bool open, scene::Object& object);
};

/// Null: no such solid.
const SolidForm* solid_form(Kind keyword);

/// All of them, their keywords and blocks.
std::vector<Form> solids_of_numbers();

/// What a word of CSG does to its operands; nothing: it is no such word.
std::optional<scene::CsgOp> csg_op(Kind keyword);

}  // namespace parser
