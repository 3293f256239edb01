#pragma once

#include "render/image/picture_writer.h"

namespace image {

class IoWriter;

/// An OpenEXR file of many channels on its way, row by row from the top; one that is not finished leaves nothing.
/// Methods throw FileError.
class ChannelWriter {
public:
    /// \param what  without its values
    ChannelWriter(IoLoader& loader, const std::string& path, const Channels& what);
    ~ChannelWriter();
    /// \param values  of the next row, all channels of a pixel together
    void put(const float* values);
    void finish(bool lasting);

private:
    template <class Work>
    void named(Work&& work) const;

    Replacement replacement_;
    std::unique_ptr<IoWriter> writer_;
};

}  // namespace image
