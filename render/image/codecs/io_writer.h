#pragma once

#include "render/image/codecs/io_module.h"
#include "render/image/codecs/row_sink.h"

#include <string>
#include <vector>

namespace image {

/// Writes through the module, in runs of rows: its writers compress several rows together.
class IoWriter final : public RowSink {
public:
    /// \param request its shape and the kind of its rows are filled in here
    IoWriter(const IoModule& module, const std::string& path, const FileShape& shape, WriteRequest request);
    ~IoWriter() override;
    void put(const std::uint16_t* samples) override;
    /// The same in linear light.
    void put_levels(const float* levels);
    void finish() override;

private:
    template <class Sample>
    void add(std::vector<Sample>& run);
    template <class Sample>
    void write(std::vector<Sample>& run);
    void check(const char* message) const;

    const IoModule& module_;
    OpenPicture* picture_ = nullptr;
    std::size_t row_samples_;
    int bits_, written_ = 0;  ///< rows that the module has
    std::vector<std::uint8_t> bytes_;
    std::vector<std::uint16_t> integers_;
    std::vector<float> levels_;
};

}  // namespace image
