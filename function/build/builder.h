#pragma once

#include "function/program.h"

#include <map>
#include <vector>

namespace function {

/// Takes a body in the order in which it is read and makes the program of it. Operations on constants are done at once;
/// equal operations on equal operands are one. What is the same wherever it stands is decided here; what depends on how
/// the text is written (x / 3 is x times a third) is the reader's.
class Builder {
public:
    using Value = std::uint32_t;  ///< a node
    static constexpr std::uint32_t kMostNodes = 1'000'000;

    explicit Builder(std::uint32_t parameters);

    Value constant(double v);
    Value parameter(std::uint32_t i) const { return i; }
    Value binary(Op op, Value a, Value b);
    Value unary(Op op, Value a);
    /// A function applied to as many values as it has parameters. Small ones are taken in, large ones called.
    Value call(const FunctionPtr& callee, const std::vector<Value>& arguments);
    /// internal(n) of x, y, z and its own parameters.
    Value internal(std::uint32_t n, const std::vector<Value>& arguments);
    /// A transformation, spline, pattern or pigment of its arguments: up to five components.
    Value outer(const SceneReference& what, std::uint32_t components, const std::vector<Value>& arguments);
    Value component(Value vector, std::uint32_t k);
    std::uint32_t components(Value v) const;

    // select(condition, a, b[, c]): begin_branch() before each of a, b, c is read, end_branch(value) after it.
    void begin_branch(Value condition);
    Value end_branch(Value result);  ///< to be handed to select()
    Value select(Value condition, const std::vector<Value>& branches);

    // sum(i, from, to, body), prod: the counter is begin_loop()'s value.
    Value begin_loop(Value from, Value to);
    Value end_loop(Value counter, Value body, bool product);

    bool is_constant(Value v) const { return nodes_[v].op == Op::Constant; }
    double number(Value v) const { return nodes_[v].number; }
    bool full() const { return nodes_.size() > kMostNodes; }

    /// The program whose value is `result`. The builder is spent.
    FunctionPtr finish(Value result);

private:
    using Key = std::vector<std::uint32_t>;
    Value shared(Node node);
    Value append(Node node);
    Value take_in(const Function& callee, const std::vector<Value>& arguments);
    void open_scope() { scopes_.emplace_back(); }
    void close_scope();
    std::uint32_t place_of(const SceneReference& what);

    std::uint32_t parameters_;
    std::vector<Node> nodes_;
    std::vector<SceneReference> outer_;
    std::map<std::uint64_t, Value> constants_;
    std::map<Key, Value> known_;
    std::vector<Value> branches_;           ///< open ones: where they began
    std::vector<std::vector<Key>> scopes_;  ///< what was learned inside branches and loops, forgotten at their end
};

/// Whole functions of one kind.
FunctionPtr make_internal(std::uint32_t n);  ///< null: there is none
FunctionPtr make_outer(const SceneReference& what, std::uint32_t parameters, std::uint32_t components);

}  // namespace function
