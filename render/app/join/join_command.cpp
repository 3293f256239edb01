#include "render/app/join/join_command.h"

#include "render/app/base/text.h"
#include "render/app/join/shelf.h"
#include "render/app/options/settings.h"
#include "render/app/run/cancellation.h"
#include "render/image/channel_writer.h"
#include "render/image/codecs/write/row_sink.h"
#include "render/image/picture_writer.h"
#include "render/layers/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace app {

namespace {

constexpr const char* kJoinUsage =
    R"(usage: whittle join OUT PART...        makes the picture OUT of the parts that --shard has rendered
       whittle join --check PART...    only tells whether they are all there, whole and of one picture

Layers that the parts have (--aov) go to OUT.layers.exr. OUT has the bytes of one run.
Exit status: 0 done; 75 parts are missing or cut short, tasks that are run once more may bring them; 1 parts are of different
pictures, or the picture cannot be written.
)";

struct JoinRequest {
    bool check = false;
    std::string out;
    std::vector<std::string> parts;
};

JoinRequest request_of(const std::vector<std::string>& arguments)
{
    JoinRequest request;
    bool words = true;
    for (const std::string& word : arguments) {
        if (words && word == "--") words = false;
        else if (words && word == "--check") request.check = true;
        else if (words && word.starts_with("--")) throw OptionError("unknown option '" + word + "'");
        else request.parts.push_back(word);
    }
    if (!request.check && !request.parts.empty()) {
        request.out = request.parts.front();
        request.parts.erase(request.parts.begin());
    }
    if (request.parts.empty())
        throw OptionError("join wants parts: whittle join OUT PART..., whittle join --check PART...");
    if (request.out.ends_with(".whittle-part"))
        throw OptionError("join wants the name of the picture before the parts, found '" + request.out + "'");
    return request;
}

void write_picture(const image::Files& files, const std::string& out, Shelf& shelf)
{
    const BlocksOf& of = shelf.of();
    image::FileSettings settings = of.file;
    settings.lasting = true;
    const auto writer = files.start(out, of.width, of.height, settings);
    image::Image rows;
    const auto held = [&rows] { return static_cast<int>(rows.pixels.size() / 4) / std::max(1, rows.width); };
    for (int i = 0; i < of.height; ++i) {
        const int row = writer->next_row();
        if (row < rows.top || row >= rows.top + held()) shelf.load(row, rows);
        writer->put(rows.at(0, row));
    }
    writer->finish();
}

void write_layers(const image::Files& files, const std::string& out, Shelf& shelf)
{
    const BlocksOf& of = shelf.of();
    image::Image rows, one;
    one.width = of.width;
    one.height = 1;
    std::unique_ptr<image::ChannelWriter> writer;
    for (int row = 0; row < of.height; ++row) {
        if (row == 0 || row >= rows.top + static_cast<int>(rows.pixels.size() / 4) / of.width) shelf.load(row, rows);
        one.pixels.assign(rows.at(0, row), rows.at(0, row) + 4 * of.width);
        image::Channels channels;
        channels.width = of.width;
        channels.height = of.height;
        channels.names = of.layers;
        channels.values = shelf.layer_row(row);
        layers::add_picture(channels, one, of.file.encoding.curves.working);
        if (!writer) {
            channels.attributes = of.attributes;
            channels.attributes.emplace_back(image::kFingerprintKey, of.file.fingerprint);
            writer = files.start_channels(out, channels);
        }
        writer->put(channels.values.data());
    }
    writer->finish(true);
}

int join(const JoinRequest& request)
{
    Shelf shelf(request.parts);
    int status = kSuccess;
    for (const Shelf::Fault& fault : shelf.faults()) {
        fmt::print(stderr, "whittle: error: {}\n", fault.text);
        status = status == kError || !fault.may_mend ? kError : kTryAgain;
    }
    if (status != kSuccess) return status;
    const BlocksOf& of = shelf.of();
    if (request.check) {
        fmt::print("{}x{}, {} blocks, fingerprint {}: all there\n", of.width, of.height, of.blocks.size(),
                   of.file.fingerprint);
        return kSuccess;
    }
    const std::string extension = std::filesystem::path(request.out).extension().string(),
                      wanted = image::extension(of.file.type);
    if (!same_text(extension, wanted) && !(wanted == ".jpg" && same_text(extension, ".jpeg")))
        throw OptionError(
            fmt::format("the parts are of a picture in {}, and '{}' has another ending", wanted, request.out));
    const image::Files files;
    files.prepare(of.layers.empty() ? of.file.type : image::FileType::OpenExr);
    write_picture(files, request.out, shelf);
    fmt::print(stderr, "{}  {}x{}\n", request.out, of.width, of.height);
    if (of.layers.empty()) return kSuccess;
    const std::string layers = std::filesystem::path(request.out).replace_extension(".layers.exr").string();
    write_layers(files, layers, shelf);
    fmt::print(stderr, "note: layers: {}\n", layers);
    return kSuccess;
}

}  // namespace

std::string join_help() { return kJoinUsage; }

int join_command(const std::vector<std::string>& arguments) { return join(request_of(arguments)); }

}  // namespace app
