#include "parser/parse.h"

#include "parser/grammar.h"
#include "parser/grammar/core/productions.h"

#include "parser/grammar/core/scene_builder.h"
#include "parser/stream/told_values.h"
#include "parser/stream/token_stream.h"
#include "render/files/whole_file.h"

#include <fmt/format.h>

#include <iterator>

namespace parser {
namespace {

template <class Open>
Result parse(const Options& options, MessageSink sink, void* context, Open&& open)
{
    SceneBuilder build;
    TokenStream stream(options, build, sink, context);
    build.attach(stream);
    open(stream);
    build.read_scene();
    Result result;
    if (options.tell_values) result.values = told_values(stream.symbols(), stream.names());
    result.scene = build.take();
    result.messages = std::move(stream.messages());
    result.statistics = stream.statistics();
    constexpr std::size_t kToldCosts = 10;
    result.statistics.costs = stream.reading_costs(kToldCosts);
    const files::ReadFiles& read = stream.read_files();
    result.data_files = read.data_files();
    result.text_hashes = read.text_hashes();
    result.data_hashes = read.data_hashes();
    return result;
}

}  // namespace

Result parse_file(const std::string& path, const Options& options, MessageSink sink, void* context)
{
    return parse(options, sink, context, [&](TokenStream& stream) { stream.open_file(path); });
}

Result parse_text(const std::string& text, const std::string& name, const Options& options, MessageSink sink,
                  void* context)
{
    return parse(options, sink, context, [&](TokenStream& stream) { stream.open_text(text, name); });
}

std::string dump_tokens(const std::string& path)
{
    std::optional<std::string> found = files::whole_file_if(path);
    if (!found) throw Error({path, {}}, "cannot read this file");
    SourceFile file;
    file.path = path;
    file.text = std::move(*found);
    Names names;
    tokenize(file, 0, names, true, false);
    std::string out;
    for (const Token& token : file.tokens) {
        const SourceFile::Place place = file.locate(token.offset);
        fmt::format_to(std::back_inserter(out), "{}:{} {}", place.line, place.column, spelling(token.kind));
        const std::string_view text = file.token_text(token);
        if (!text.empty() && text != spelling(token.kind)) fmt::format_to(std::back_inserter(out), " {}", text);
        out += '\n';
    }
    return out;
}

const std::vector<Production>& grammar()
{
    static const std::vector<Production> all = productions_from(scene_text);
    return all;
}

}  // namespace parser
