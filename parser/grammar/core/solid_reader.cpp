#include "parser/grammar/core/solid_reader.h"

#include <array>

namespace parser {
namespace {

template <class Solid>
bool read_as(SolidReader& s)
{
    auto written = std::make_shared<scene::WrittenSolid>();
    written->keyword = spelling(s.keyword());
    written->source = s.source();
    s.written = written;
    const bool drawn = read_parameters(s, written->parameters.emplace<Solid>());
    s.object().details.edit().written = std::move(written);
    return drawn;
}

template <class Solid>
Form form_as(Kind keyword)
{
    return parameters_form(static_cast<const SolidReader*>(nullptr), static_cast<const Solid*>(nullptr), keyword);
}

struct Head {
    SolidHead read = nullptr;
    Form (*form)(Kind) = nullptr;
};
using Heads = std::array<Head, kKindCount>;

template <class Solid>
void add_heads(Heads& heads)
{
    for (std::size_t kind = 0; kind < heads.size(); ++kind)
        for (const std::string_view keyword : Solid::kKeywords)
            if (spelling(static_cast<Kind>(kind)) == keyword) heads[kind] = {read_as<Solid>, form_as<Solid>};
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

const Heads& heads()
{
    static const Heads all = heads_of(static_cast<const scene::AnySolid*>(nullptr));
    return all;
}
SolidHead solid_head(Kind keyword) { return heads()[static_cast<std::size_t>(keyword)].read; }

std::vector<Form> written_solids()
{
    std::vector<Form> all;
    for (std::size_t kind = 0; kind < kKindCount; ++kind)
        if (const Head& head = heads()[kind]; head.form)
            all.push_back(solid_form(static_cast<Kind>(kind), head.form(static_cast<Kind>(kind))));
    return all;
}

Form solid_form(Kind keyword, Form head)
{
    return Form::sequence(
        {Form::token(keyword), Form::braces({Form::choice({Form::operand("identifier"), std::move(head)}),
                                             Form::repeated(Form::named(object_modifier))})});
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

bool kind_forgets_inverse(const scene::Object& object)
{
    return ask(object, []<class Solid>(const Solid&) { return scene::ForgetsInverse<Solid>; });
}

int read_count(TokenStream& in)
{
    constexpr double kMostPoints = 10'000'000;
    const double count = number(in);
    if (!(count < kMostPoints)) in.fail(in.last(), "this is too many points");
    return whole_number(count);
}

}  // namespace parser
