#pragma once

#include "render/image/codecs/io_module.h"
#include "render/image/codecs/write/row_sink.h"

#include <string>
#include <vector>

namespace image {

/// Writes OpenEXR files through the module, in runs of rows: several are compressed together.
class IoWriter final : public LevelSink {
public:
    /// \param request its path and shape are filled in here
    IoWriter(const IoModule& module, const std::string& path, const FileShape& shape, WriteRequest request);
    ~IoWriter() override;
    void put(const float* levels) override;
    void finish() override;

private:
    void write();
    void check(const char* message) const;

    const IoModule& module_;
    OpenPicture* picture_ = nullptr;
    std::size_t row_samples_;
    int written_ = 0;  ///< rows that the module has
    std::vector<float> levels_;
};

}  // namespace image
