#pragma once

#include "csg/freeform/field/field.h"
#include "function/program.h"

#include <optional>

namespace function {

/// How functions are evaluated; see evaluate.h and interval.h. Each build of those sources has its own.
struct Evaluators {
    double (*one)(const Function& function, const double* arguments, const Host& host);
    std::array<double, 5> (*all)(const Function& function, const double* arguments, const Host& host);
    void (*lanes)(const Function& function, const double* const* arguments, std::size_t count, const Host& host,
                  std::uint32_t components, double* const* out);
    void (*intervals)(const Function& function, const double (*low)[8], const double (*high)[8], const Host& host,
                      double* out_low, double* out_high);
    bool (*along)(const Function& function, const csg::FieldStretch& stretch, csg::FieldPolynomial& out);
};

/// Fields use these from now on, in every thread: those of a kernel module know the processor better. All give the same
/// bits. Before any thread asks a field.
void use(const Evaluators& evaluators);
const Evaluators& in_use();

/// A function of x, y and z as what solids are made of.
class FunctionField final : public csg::Field {
public:
    /// Of at most three parameters. `host` answers what the function asks of the scene; it must be linked by then.
    /// `negated`: its values with the other sign.
    explicit FunctionField(FunctionPtr function, std::shared_ptr<const Host> host = nullptr, bool negated = false);

    double value(const glm::dvec3& p) const override;
    void values(const csg::EightPoints& p, csg::Eight& out) const override;
    void ranges(const csg::EightBoxes& boxes, csg::EightRanges& out) const override;
    bool ranged() const override { return ranged_; }
    bool along(const csg::FieldStretch& stretch, csg::FieldPolynomial& out) const override;
    bool polynomial() const override { return polynomial_; }
    const csg::RoundedBox* rounded_box() const override { return rounded_box_ ? &*rounded_box_ : nullptr; }

    const FunctionPtr& function() const { return function_; }
    bool negated() const { return negated_; }

private:
    FunctionPtr function_;
    std::shared_ptr<const Host> host_;
    bool ranged_, polynomial_, negated_;
    std::optional<csg::RoundedBox> rounded_box_;
};

}  // namespace function
