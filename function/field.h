#pragma once

#include "csg/freeform/field.h"
#include "function/program.h"

namespace function {

/// A function of x, y and z as what solids are made of.
class FunctionField final : public csg::Field {
public:
    /// Of at most three parameters. `host` answers what the function asks of the scene; it must be linked by then.
    explicit FunctionField(FunctionPtr function, std::shared_ptr<const Host> host = nullptr);

    double value(const glm::dvec3& p) const override;
    void values(const csg::EightPoints& p, csg::Eight& out) const override;
    void ranges(const csg::EightBoxes& boxes, csg::EightRanges& out) const override;
    bool ranged() const override { return ranged_; }

    const FunctionPtr& function() const { return function_; }

private:
    FunctionPtr function_;
    std::shared_ptr<const Host> host_;
    bool ranged_;
};

}  // namespace function
