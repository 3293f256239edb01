#include "render/scene/dump_writer.h"

#include "function/listing.h"

#include <fmt/format.h>

/// Constructs kept as written: an item a line, blocks inside each other.
namespace scene {
namespace {

/// Operands that fit on the item's line; the others follow as blocks.
struct Inline {
    std::string operator()(double v) const { return text(v); }
    std::string operator()(const glm::dvec2& v) const { return fmt::format("<{}, {}>", text(v.x), text(v.y)); }
    std::string operator()(const glm::dvec3& v) const { return text(v); }
    std::string operator()(const glm::dvec4& v) const
    {
        return fmt::format("<{}, {}, {}, {}>", text(v.x), text(v.y), text(v.z), text(v.w));
    }
    std::string operator()(const Color& c) const { return text(c); }
    std::string operator()(const std::string& s) const { return '"' + s + '"'; }
    template <class Block> std::string operator()(const Block&) const { return {}; }
};

struct Blocks {
    DumpWriter& out;
    void operator()(const function::FunctionPtr& made) const
    {
        out.open("function");
        for (const std::string& step : function::listing(*made)) out.line("step", step);
        out.close();
    }
    void operator()(const csg::Transform& t) const { out.value("transform", t); }
    void operator()(const std::shared_ptr<const Pigment>& p) const { dump(out, *p); }
    void operator()(const std::shared_ptr<const Texture>& t) const { dump(out, *t); }
    void operator()(const std::shared_ptr<const Object>& o) const { dump(out, *o); }
    void operator()(const StatementPtr& s) const { dump(out, *s); }
    template <class Inlined> void operator()(const Inlined&) const {}
};

}  // namespace

void dump(DumpWriter& out, const Statement& statement)
{
    out.open(statement.keyword);
    for (const StatementItem& item : statement.items) {
        std::string line;
        for (const StatementItem::Operand& operand : item.operands) {
            const std::string one = std::visit(Inline{}, operand);
            if (one.empty()) continue;
            if (!line.empty()) line += ' ';
            line += one;
        }
        out.line(item.name.empty() ? "-" : item.name, line);
        for (const StatementItem::Operand& operand : item.operands) std::visit(Blocks{out}, operand);
    }
    out.close();
}

}  // namespace scene
