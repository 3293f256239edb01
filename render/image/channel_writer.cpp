#include "render/image/channel_writer.h"

#include "render/image/pixels/passing_failure.h"
#include "render/image/file_types.h"
#include "render/image/codecs/io_loader.h"
#include "render/image/codecs/io_writer.h"

namespace image {

template <class Work>
void ChannelWriter::named(Work&& work) const
{
    try {
        work();
    } catch (const FileError& error) {
        fail_named("cannot write '" + replacement_.path() + "': ", error);
    }
}

ChannelWriter::ChannelWriter(IoLoader& loader, const std::string& path, const Channels& what) : replacement_(path)
{
    std::vector<const char*> names, attributes;
    for (const std::string& name : what.names) names.push_back(name.c_str());
    for (const auto& [key, text] : what.attributes) attributes.insert(attributes.end(), {key.c_str(), text.c_str()});
    attributes.push_back(nullptr);
    WriteRequest request{};
    request.channel_names = names.data();
    request.attributes = attributes.data();
    const FileShape shape{what.width, what.height, static_cast<int>(names.size()), 32, {}, kSoftware, {}};
    named([&] { writer_ = std::make_unique<IoWriter>(loader.get(), replacement_.temporary(), shape, request); });
}

ChannelWriter::~ChannelWriter()
{
    writer_.reset();  // before its file is removed
}

void ChannelWriter::put(const float* values)
{
    named([&] { writer_->put(values); });
}

void ChannelWriter::finish(bool lasting)
{
    named([&] { writer_->finish(); });
    replacement_.put_in_place(lasting);
}

}  // namespace image
