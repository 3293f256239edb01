#pragma once

#include "render/image/levels/transfer_curve.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace image {

/// The name under which a picture keeps what it is made from: a text of PNG, an attribute of OpenEXR.
inline constexpr const char* kFingerprintKey = "WhittleFingerprint";

/// The same of what it carries (FileSettings::carried): a chunk of PNG, which programs that do not know it pass over
/// and may copy (PNG specification, 2nd ed., 5.4), and an attribute of OpenEXR, which is text: in base64.
inline constexpr const char* kCarriedChunk = "whSc";
inline constexpr const char* kCarriedKey = "WhittleScene";

/// What a file of rows has to know before the first.
struct FileShape {
    int width = 0, height = 0, channels = 3;
    int bits = 8;         ///< of an integer: the largest is 2^bits - 1
    TransferCurve curve;  ///< that the values are stored with
    const char* software = "";
    std::string fingerprint = {};  ///< see FileSettings
    std::shared_ptr<const std::string> carried = {};
};

/// A picture file that grows row by row, from the top; a BMP from below. One that was not finished is of no use.
/// Methods throw FileError, whose text names no file.
template <class Sample>
class SinkOf {
public:
    SinkOf() = default;
    SinkOf(const SinkOf&) = delete;
    SinkOf& operator=(const SinkOf&) = delete;
    virtual ~SinkOf() = default;
    /// The next row: channels * width samples.
    virtual void put(const Sample* samples) = 0;
    /// After the last row. A full disk may show only now.
    virtual void finish() = 0;
};
using RowSink = SinkOf<std::uint16_t>;  ///< integers
using LevelSink = SinkOf<float>;        ///< linear light

/// Integers of `bits` bits over 16: shorter ones stand at the top and repeat below, so that the largest stays the
/// largest. For 8 stored bits the upper byte is what counts (spec 2, 12.4).
inline std::uint16_t widened(std::uint16_t value, int bits)
{
    std::uint32_t filled = 0;
    for (int shift = 16 - bits; shift > -bits; shift -= bits)
        filled |= shift >= 0 ? std::uint32_t{value} << shift : std::uint32_t{value} >> -shift;
    return static_cast<std::uint16_t>(filled);
}

/// The same over 8, of files that have no more.
inline std::uint8_t byte_of(std::uint16_t value, int bits)
{
    return static_cast<std::uint8_t>(widened(value, bits) >> 8);
}

}  // namespace image
