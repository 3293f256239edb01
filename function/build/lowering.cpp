#include "function/build/lowering.h"

#include "function/internal/internal.h"

#include <algorithm>
#include <utility>

namespace function {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::uint32_t kReferenceRegisters = 5;  // registers of a SceneReference's result

/// Calls f(operand) for every node that `node` reads or hangs on.
template <class F>
void for_operands(const Node& node, F&& f)
{
    switch (node.op) {
    case Op::Constant:
    case Op::Parameter: return;
    case Op::Counter:
    case Op::Component:
    case Op::BeginBranch: return f(node.a);
    case Op::Select: f(node.a); break;
    case Op::Call:
    case Op::Internal:
    case Op::SceneReference: break;
    default:
        f(node.a);
        if (!is_unary(node.op)) f(node.b);
    }
    for (const std::uint32_t v : node.operands) f(v);
}

class Lowering {
public:
    explicit Lowering(Function& function)
        : f_(function), nodes_(function.nodes), count_(static_cast<std::uint32_t>(nodes_.size()))
    {}

    void run()
    {
        find_live();
        find_ends();
        place_constants();
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (!live_[i]) continue;
            emit(i);
            for (const std::uint32_t v : dying_[i]) free_.push_back(register_[v]);
        }
        f_.result = register_of(f_.value);
        f_.registers = std::max(next_, 1u);
    }

private:
    bool placed(std::uint32_t v) const { return nodes_[v].op == Op::Constant || nodes_[v].op == Op::Parameter; }

    void find_live()
    {
        live_.assign(count_, false);
        live_[f_.value] = true;
        for (std::uint32_t i = count_; i-- > 0;)
            if (live_[i]) for_operands(nodes_[i], [&](std::uint32_t v) { live_[v] = true; });
        // A loop whose body ignores its counter has one all the same.
        for (std::uint32_t i = 0; i < count_; ++i)
            if (nodes_[i].op == Op::Counter && live_[nodes_[i].a]) live_[i] = true;
    }

    /// Where each value is read last. What a loop reads from outside lives as long as the loop; results of branches
    /// live until all branches have run.
    void find_ends()
    {
        std::vector<std::uint32_t> loop_end(count_, kNone), select_of(count_, kNone), open;
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (nodes_[i].op == Op::Loop) loop_end[nodes_[i].a] = i;
            if (nodes_[i].op == Op::Select)
                for (const std::uint32_t end : nodes_[i].operands) select_of[end] = i;
        }
        std::vector<std::uint32_t> last(count_, kNone);
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (!live_[i]) continue;
            while (!open.empty() && loop_end[open.back()] <= i) open.pop_back();
            if (nodes_[i].op == Op::BeginLoop) open.push_back(i);
            for_operands(nodes_[i], [&](std::uint32_t v) {
                std::uint32_t at = nodes_[i].op == Op::EndBranch   ? select_of[i]
                                   : nodes_[i].op == Op::BeginLoop ? loop_end[i]
                                                                   : i;
                while (nodes_[v].op == Op::Component) v = nodes_[v].a;
                for (const std::uint32_t loop : open)
                    if (v < loop) at = std::max(at, loop_end[loop]);
                if (last[v] == kNone || last[v] < at) last[v] = at;
            });
        }
        dying_.resize(count_);
        const auto recycled = [](Op op) {
            return is_binary(op) || is_unary(op) || op == Op::Call || op == Op::Internal || op == Op::Select ||
                   op == Op::Loop;
        };
        for (std::uint32_t v = 0; v < count_; ++v)
            if (live_[v] && v != f_.value && last[v] != kNone && recycled(nodes_[v].op)) dying_[last[v]].push_back(v);
    }

    void place_constants()
    {
        register_.assign(count_, kNone);
        for (std::uint32_t i = 0; i < count_; ++i)
            if (live_[i] && nodes_[i].op == Op::Constant) {
                register_[i] = next_++;
                f_.constants.push_back(nodes_[i].number);
            }
        for (std::uint32_t i = 0; i < count_; ++i)
            if (nodes_[i].op == Op::Parameter) register_[i] = f_.first_parameter() + nodes_[i].a;
        next_ += f_.parameters;
    }

    std::uint32_t register_of(std::uint32_t v) const
    {
        return nodes_[v].op == Op::Component ? register_of(nodes_[v].a) + nodes_[v].c : register_[v];
    }

    std::uint32_t fresh()
    {
        if (free_.empty()) return next_++;
        const std::uint32_t r = free_.back();
        free_.pop_back();
        return r;
    }

    void emit(std::uint32_t i)
    {
        const Node& n = nodes_[i];
        switch (n.op) {
        case Op::Constant:
        case Op::Parameter:
        case Op::Component: return;
        case Op::BeginBranch: return begin_branch(n);
        case Op::EndBranch: return end_branch(n);
        case Op::Select: return end_select(i);
        case Op::BeginLoop: return begin_loop(i);
        case Op::Counter: return;
        case Op::Loop: return end_loop(i);
        case Op::Call:
        case Op::Internal:
        case Op::SceneReference: {
            Instruction in{n.op, 0, static_cast<std::uint32_t>(f_.arguments.size()),
                           static_cast<std::uint32_t>(n.operands.size()), n.c};
            for (const std::uint32_t v : n.operands) f_.arguments.push_back(register_of(v));
            if (n.op == Op::SceneReference) {  // its registers stay its own: components are read at any time
                register_[i] = next_;
                next_ += kReferenceRegisters;
            } else {
                register_[i] = fresh();
            }
            in.dst = register_[i];
            if (n.op == Op::Internal) in.weights = known_weights(n);
            f_.code.push_back(in);
            return;
        }
        default: {
            const std::uint32_t a = register_of(n.a), b = is_binary(n.op) ? register_of(n.b) : 0;
            register_[i] = fresh();
            f_.code.push_back({n.op, register_[i], a, b, 0});
        }
        }
    }

    /// Weights of octaves that do not change from call to call: powers are what f_ridged_mf spends most on.
    std::uint32_t known_weights(const Node& n)
    {
        constexpr std::size_t kH = 3, kLacunarity = 4, kOctaves = 5;
        if (std::get<std::uint32_t>(f_.outer[n.c]) != kRidgedMultifractal) return Instruction::kNone;
        const auto constant = [&](std::size_t parameter) -> const Node& { return nodes_[n.operands[parameter]]; };
        for (const std::size_t parameter : {kH, kLacunarity, kOctaves})
            if (constant(parameter).op != Op::Constant) return Instruction::kNone;
        f_.octave_weights.push_back(
            ridged_weights(constant(kH).number, constant(kLacunarity).number, constant(kOctaves).number));
        return static_cast<std::uint32_t>(f_.octave_weights.size() - 1);
    }

    std::uint32_t here() const { return static_cast<std::uint32_t>(f_.code.size()); }

    /// The first branch of a select brings its instruction; the others follow it in the same entry.
    void begin_branch(const Node& n)
    {
        if (!continues_) {
            Branching made;
            made.condition = register_of(n.a);
            made.count = 0;
            open_.push_back(static_cast<std::uint32_t>(f_.branchings.size()));
            // The result's register is taken now: the branches may not use it.
            results_.push_back(fresh());
            f_.code.push_back({Op::Select, results_.back(), open_.back(), 0, 0});
            f_.branchings.push_back(made);
        }
        continues_ = false;
        Branching& entry = f_.branchings[open_.back()];
        entry.begin[entry.count] = here();
    }
    void end_branch(const Node& n)
    {
        Branching& entry = f_.branchings[open_.back()];
        entry.end[entry.count] = here();
        entry.result[entry.count++] = register_of(n.a);
        continues_ = true;
    }
    void end_select(std::uint32_t i)
    {
        register_[i] = results_.back();
        results_.pop_back();
        open_.pop_back();
        continues_ = false;
    }

    void begin_loop(std::uint32_t i)
    {
        Loop made;
        made.from = register_of(nodes_[i].a);
        made.to = register_of(nodes_[i].b);
        made.counter = fresh();
        register_[i + 1] = made.counter;  // the counter's node follows
        register_[i] = static_cast<std::uint32_t>(f_.loops.size());
        results_.push_back(fresh());
        f_.code.push_back({Op::Loop, results_.back(), register_[i], 0, 0});
        made.begin = here();
        f_.loops.push_back(made);
    }
    void end_loop(std::uint32_t i)
    {
        Loop& entry = f_.loops[register_[nodes_[i].a]];
        entry.end = here();
        entry.result = register_of(nodes_[i].b);
        entry.product = nodes_[i].c != 0;
        register_[i] = results_.back();
        results_.pop_back();
        free_.push_back(entry.counter);
    }

    Function& f_;
    const std::vector<Node>& nodes_;
    std::uint32_t count_, next_ = 0;
    std::vector<bool> live_;
    std::vector<std::vector<std::uint32_t>> dying_;
    std::vector<std::uint32_t> register_, free_, open_, results_;
    bool continues_ = false;
};

}  // namespace

void lower(Function& function) { Lowering(function).run(); }

}  // namespace function
