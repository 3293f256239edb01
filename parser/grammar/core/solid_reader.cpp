#include "parser/grammar/core/solid_reader.h"

#include <array>

namespace parser {
namespace {

template <class Solid>
bool read_as(SolidReader& s)
{
    auto written = std::make_shared<scene::WrittenSolid>();
    written->keyword = s.keyword();
    written->source = s.source();
    s.written = written;
    const bool drawn = read_parameters(s, written->parameters.emplace<Solid>());
    s.object().details.edit().written = std::move(written);
    return drawn;
}

using Heads = std::array<SolidHead, kKindCount>;

template <class Solid>
void add_heads(Heads& heads)
{
    for (std::size_t kind = 0; kind < heads.size(); ++kind)
        for (const std::string_view keyword : Solid::kKeywords)
            if (spelling(static_cast<Kind>(kind)) == keyword) heads[kind] = read_as<Solid>;
}
template <class... Solids>
Heads heads_of(const std::variant<Solids...>*)
{
    Heads heads{};
    (add_heads<Solids>(heads), ...);
    return heads;
}

/// Whether the object has written parameters of which the question is true.
template <class Question>
bool ask(const scene::Object& object, Question&& question)
{
    const auto& written = object.details->written;
    return written && std::visit(question, written->parameters);
}

}  // namespace

SolidHead solid_head(Kind keyword)
{
    static const Heads heads = heads_of(static_cast<const scene::AnySolid*>(nullptr));
    return heads[static_cast<std::size_t>(keyword)];
}

bool is_written(Kind keyword) { return solid_head(keyword) != nullptr; }

bool takes_sturm(const scene::Object& object)
{
    return ask(object, []<class Solid>(const Solid&) { return scene::TakesSturm<Solid>; });
}

bool takes_hierarchy(const scene::Object& object)
{
    return ask(object, []<class Solid>(const Solid&) { return scene::TakesHierarchy<Solid>; });
}

bool forgets_inverse(const scene::Object& object)
{
    return ask(object, []<class Solid>(const Solid&) { return scene::ForgetsInverse<Solid>; });
}

int read_count(SolidReader& s)
{
    constexpr double kMost = 10'000'000;
    const double count = float_expr(s.in());
    if (!(count < kMost)) s.fail("this is too many points");
    return whole_number(count);
}

void read_open_and_sturm(SolidReader& s, bool* open)
{
    for (;;) {
        if (open && s.accept(Kind::Open)) *open = true;
        else if (s.accept(Kind::Sturm)) optional_flag(s.in());
        else return;
    }
}

}  // namespace parser
