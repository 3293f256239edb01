#pragma once

#include "csg/types.h"
#include "function/program.h"
#include "render/image/picture.h"
#include "render/scene/color.h"
#include "render/scene/source_ref.h"
#include "render/scene/volume.h"

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Constructs that are read whole but not drawn yet, as the author wrote them: every value worked out, in the order of the
/// text, what was left out left out.
namespace scene {

struct Object;
struct Pigment;
struct Texture;
struct Statement;
using StatementPtr = std::shared_ptr<const Statement>;

struct StatementItem {
    using Operand = std::variant<double, glm::dvec2, glm::dvec3, glm::dvec4, Color, std::string, function::FunctionPtr,
                                 csg::Transform, std::shared_ptr<const Pigment>, std::shared_ptr<const Texture>,
                                 std::shared_ptr<const Object>, StatementPtr, std::shared_ptr<const image::Picture>, std::shared_ptr<const Volume>>;
    std::string name;                ///< keyword; empty for what stands first in the block without one
    std::vector<Operand> operands;   ///< none: the keyword alone
};

struct Statement {
    std::string keyword;
    std::vector<StatementItem> items;
    SourceRef source;
};

/// Number of an item's operand; 0 for operands that are none.
inline double number_of(const StatementItem::Operand& operand)
{
    const double* number = std::get_if<double>(&operand);
    return number ? *number : 0.0;
}

/// The first item of that name; null: none.
inline const StatementItem* item_of(const Statement& statement, std::string_view name)
{
    for (const StatementItem& item : statement.items)
        if (item.name == name) return &item;
    return nullptr;
}

}  // namespace scene
