#pragma once

#include <cstdint>

/// The one interface to the module that holds OpenImageIO. Plain C types: the module shares no state with the program.
namespace image {

/// What the writer of OpenEXR files is told. Strings live until the call returns.
struct WriteRequest {
    const char* path;
    int width, height, channels;
    const char* software;
    /// Names of the channels, stored as floats of 32 bits; null: the usual ones, of 16 bits.
    const char* const* channel_names;
    const char* const* attributes;  ///< names and texts in turn, ended by null; or null
};

/// What a reader returns; `samples` belongs to the module until `release`.
struct ReadResult {
    int width, height, channels;
    int bits;            ///< of the file's samples: 8, 16 or 32 (float)
    float* samples;      ///< 0 to 1 for integer files, channels interleaved, straight alpha
    float gamma;         ///< of the file's gAMA entry, 0 if it has none
    bool srgb;           ///< the file says that it is sRGB
    bool premultiplied;  ///< its colours are times alpha
};

class OpenPicture;  ///< a file that is being written

/// All but `discard` and `release` return null or a message that stays valid until the next call of the same thread.
struct IoModule {
    const char* (*open)(const WriteRequest&, OpenPicture*& out);  ///< `out` ends in close() or discard()
    /// Rows [first, first + count), each once, from the top, in linear light.
    const char* (*put)(OpenPicture& picture, int first, int count, const float* rows);
    const char* (*close)(OpenPicture* picture);
    void (*discard)(OpenPicture* picture);
    const char* (*read)(const char* path, ReadResult&);
    void (*release)(ReadResult&);
};

inline constexpr const char* kIoModuleName = "libwhittle_image_io.so";
inline constexpr const char* kIoModuleEntry = "whittle_image_io";

}  // namespace image
