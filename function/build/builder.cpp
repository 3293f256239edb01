#include "function/build/builder.h"

#include "function/arithmetic.h"
#include "function/internal/internal.h"
#include "function/build/lowering.h"

#include <bit>
#include <utility>

namespace function {
namespace {

constexpr std::size_t kTakenIn = 200;         // nodes of a callee that is copied into its caller
constexpr std::size_t kLargeCaller = 20'000;  // nodes from which on nothing is copied any more

Node node_of(Op op, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t c = 0)
{
    Node node;
    node.op = op;
    node.a = a;
    node.b = b;
    node.c = c;
    return node;
}

}  // namespace

Builder::Builder(std::uint32_t parameters) : parameters_(parameters)
{
    for (std::uint32_t i = 0; i < parameters; ++i) nodes_.push_back(node_of(Op::Parameter, i));
}

Builder::Value Builder::append(Node node)
{
    nodes_.push_back(std::move(node));
    return static_cast<Value>(nodes_.size() - 1);
}

Builder::Value Builder::shared(Node node)
{
    Key key{static_cast<std::uint32_t>(node.op), node.a, node.b, node.c};
    key.insert(key.end(), node.operands.begin(), node.operands.end());
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    const Value value = append(std::move(node));
    if (!scopes_.empty()) scopes_.back().push_back(key);
    known_.emplace(std::move(key), value);
    return value;
}

void Builder::close_scope()
{
    for (const Key& key : scopes_.back()) known_.erase(key);
    scopes_.pop_back();
}

Builder::Value Builder::constant(double v)
{
    const auto [found, fresh] = constants_.try_emplace(std::bit_cast<std::uint64_t>(v), 0u);
    if (fresh) {
        Node node = node_of(Op::Constant);
        node.number = v;
        found->second = append(std::move(node));
    }
    return found->second;
}

Builder::Value Builder::binary(Op op, Value a, Value b)
{
    if (is_constant(a) && is_constant(b)) return constant(apply(op, number(a), number(b)));
    if ((op == Op::Add || op == Op::Multiply) && b < a) std::swap(a, b);
    return shared(node_of(op, a, b));
}

Builder::Value Builder::unary(Op op, Value a)
{
    return is_constant(a) ? constant(apply(op, number(a))) : shared(node_of(op, a));
}

std::uint32_t Builder::place_of(const SceneReference& what)
{
    // Equal only where it is the same thing: enough for one function used twice.
    for (std::uint32_t i = 0; i < outer_.size(); ++i) {
        if (outer_[i].index() != what.index()) continue;
        if (const auto* f = std::get_if<FunctionPtr>(&what); f && *f == std::get<FunctionPtr>(outer_[i])) return i;
        if (const auto* n = std::get_if<std::uint32_t>(&what); n && *n == std::get<std::uint32_t>(outer_[i])) return i;
        if (const auto* u = std::get_if<SceneUse>(&what); u && u->external == std::get<SceneUse>(outer_[i]).external)
            return i;
        using SplinePtr = std::shared_ptr<const Spline>;
        if (const auto* s = std::get_if<SplinePtr>(&what); s && *s == std::get<SplinePtr>(outer_[i])) return i;
        if (const auto* t = std::get_if<csg::Transform>(&what)) {
            const auto& other = std::get<csg::Transform>(outer_[i]);
            if (t->linear == other.linear && t->offset == other.offset) return i;
        }
    }
    outer_.push_back(what);
    return static_cast<std::uint32_t>(outer_.size() - 1);
}

Builder::Value Builder::internal(std::uint32_t n, const std::vector<Value>& arguments)
{
    Node node = node_of(Op::Internal, 0, 1, place_of(n));
    node.operands = arguments;
    return shared(std::move(node));
}

Builder::Value Builder::outer(const SceneReference& what, std::uint32_t count, const std::vector<Value>& arguments)
{
    Node node = node_of(Op::SceneReference, 0, count, place_of(what));
    node.operands = arguments;
    return shared(std::move(node));
}

std::uint32_t Builder::components(Value v) const { return nodes_[v].op == Op::SceneReference ? nodes_[v].b : 1; }

Builder::Value Builder::component(Value vector, std::uint32_t k)
{
    return shared(node_of(Op::Component, vector, 0, k));
}

Builder::Value Builder::call(const FunctionPtr& callee, const std::vector<Value>& arguments)
{
    if (callee->nodes.size() <= kTakenIn && nodes_.size() < kLargeCaller) return take_in(*callee, arguments);
    Node node = node_of(Op::Call, 0, 1, place_of(callee));
    node.operands = arguments;
    return shared(std::move(node));
}

void Builder::begin_branch(Value condition)
{
    append(node_of(Op::BeginBranch, condition));
    open_scope();
    scopes_.back().reserve(8);
    branches_.push_back(static_cast<Value>(nodes_.size() - 1));
}

Builder::Value Builder::end_branch(Value result)
{
    close_scope();
    const Value begin = branches_.back();
    branches_.pop_back();
    return append(node_of(Op::EndBranch, result, begin));
}

Builder::Value Builder::select(Value condition, const std::vector<Value>& branches)
{
    Node node = node_of(Op::Select, condition, static_cast<std::uint32_t>(branches.size()));
    node.operands = branches;
    return append(std::move(node));
}

Builder::Value Builder::begin_loop(Value from, Value to)
{
    const Value begin = append(node_of(Op::BeginLoop, from, to));
    open_scope();
    return append(node_of(Op::Counter, begin));
}

Builder::Value Builder::end_loop(Value counter, Value body, bool product)
{
    close_scope();
    return append(node_of(Op::Loop, nodes_[counter].a, body, product ? 1 : 0));
}

/// The callee's nodes said again with its parameters replaced: constants meet constants, equal terms become one.
Builder::Value Builder::take_in(const Function& callee, const std::vector<Value>& arguments)
{
    std::vector<Value> now(callee.nodes.size(), 0);
    const auto mapped = [&](const std::vector<std::uint32_t>& from) {
        std::vector<Value> to;
        for (const std::uint32_t v : from) to.push_back(now[v]);
        return to;
    };
    for (std::size_t i = 0; i < callee.nodes.size(); ++i) {
        const Node& n = callee.nodes[i];
        switch (n.op) {
        case Op::Constant: now[i] = constant(n.number); break;
        case Op::Parameter: now[i] = arguments[n.a]; break;
        case Op::Component: now[i] = component(now[n.a], n.c); break;
        case Op::Internal: now[i] = internal(std::get<std::uint32_t>(callee.outer[n.c]), mapped(n.operands)); break;
        case Op::SceneReference: now[i] = outer(callee.outer[n.c], n.b, mapped(n.operands)); break;
        case Op::Call: now[i] = call(std::get<FunctionPtr>(callee.outer[n.c]), mapped(n.operands)); break;
        case Op::BeginBranch: begin_branch(now[n.a]); break;
        case Op::EndBranch: now[i] = end_branch(now[n.a]); break;
        case Op::Select: now[i] = select(now[n.a], mapped(n.operands)); break;
        case Op::BeginLoop: break;  // said with its counter, which follows
        case Op::Counter:
            now[i] = begin_loop(now[callee.nodes[n.a].a], now[callee.nodes[n.a].b]);
            now[n.a] = now[i];
            break;
        case Op::Loop: now[i] = end_loop(now[n.a], now[n.b], n.c != 0); break;
        default: now[i] = is_binary(n.op) ? binary(n.op, now[n.a], now[n.b]) : unary(n.op, now[n.a]);
        }
    }
    return now[callee.value];
}

FunctionPtr Builder::finish(Value result)
{
    auto made = std::make_shared<Function>();
    made->parameters = parameters_;
    made->components = components(result);
    made->nodes = std::move(nodes_);
    made->outer = std::move(outer_);
    made->value = result;
    for (const SceneReference& what : made->outer) {
        if (const auto* callee = std::get_if<FunctionPtr>(&what)) {
            made->depth = std::max(made->depth, (*callee)->depth + 1);
            made->asks_scene = made->asks_scene || (*callee)->asks_scene;
        }
        if (const auto* n = std::get_if<std::uint32_t>(&what))
            made->asks_scene = made->asks_scene || internal_asks_noise(*n);
        made->asks_scene = made->asks_scene || std::holds_alternative<SceneUse>(what);
    }
    lower(*made);
    return made;
}

FunctionPtr make_internal(std::uint32_t n)
{
    if (n >= kInternals) return nullptr;
    const std::uint32_t parameters = 3 + internal_parameters(n);
    Builder builder(parameters);
    std::vector<Builder::Value> arguments;
    for (std::uint32_t i = 0; i < parameters; ++i) arguments.push_back(builder.parameter(i));
    return builder.finish(builder.internal(n, arguments));
}

FunctionPtr make_outer(const SceneReference& what, std::uint32_t parameters, std::uint32_t components)
{
    Builder builder(parameters);
    std::vector<Builder::Value> arguments;
    for (std::uint32_t i = 0; i < parameters; ++i) arguments.push_back(builder.parameter(i));
    return builder.finish(builder.outer(what, components, arguments));
}

}  // namespace function
