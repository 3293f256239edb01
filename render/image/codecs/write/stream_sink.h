#pragma once

#include "render/image/codecs/write/row_sink.h"
#include "render/image/pixels/passing_failure.h"

#include <cerrno>
#include <fstream>
#include <string>

namespace image {

/// A sink of bytes that go into the file as they come.
template <class Sample>
class StreamSink : public SinkOf<Sample> {
public:
    void finish() override
    {
        if (!out_.flush()) fail_by_system(errno);
    }

protected:
    explicit StreamSink(const std::string& path) : out_(path, std::ios::binary) {}
    void write(const std::string& bytes)
    {
        if (!(out_ << bytes)) fail_by_system(errno);
    }
    /// How many bytes were written.
    std::size_t length() { return static_cast<std::size_t>(out_.tellp()); }

private:
    std::ofstream out_;
};

}  // namespace image
