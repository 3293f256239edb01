#include "render/image/codecs/read/direct_readers.h"

#include <gif_lib.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace image {
namespace {

/// More pixels a byte than its codes of up to 12 bits can stand for, each a string of at most 4096: such sizes are not
/// to be believed.
constexpr std::size_t kMostGifPixelsPerByte = 4096, kSmallGif = 65536;

/// Bytes handed to giflib, and its structure.
class GifDecoder {
public:
    explicit GifDecoder(const ByteList& bytes) : bytes_(bytes)
    {
        int error = 0;
        file_.reset(DGifOpen(this, read, &error));
        if (!file_) fail(error);
    }

    /// Up to the first picture; the place in the palette that a block before it makes clear.
    std::optional<std::size_t> find_picture()
    {
        std::optional<std::size_t> clear;
        for (;;) {
            GifRecordType type = UNDEFINED_RECORD_TYPE;
            check(DGifGetRecordType(file_.get(), &type));
            if (type == TERMINATE_RECORD_TYPE) throw FileError("the GIF file holds no picture");
            if (type == IMAGE_DESC_RECORD_TYPE) break;
            if (type == EXTENSION_RECORD_TYPE) skip_extension(clear);
        }
        check(DGifGetImageDesc(file_.get()));
        return clear;
    }

    const GifImageDesc& description() const { return file_->Image; }

    const ColorMapObject* palette() const { return file_->Image.ColorMap ? file_->Image.ColorMap : file_->SColorMap; }

    void read_row(std::uint8_t* row, std::size_t width)
    {
        check(DGifGetLine(file_.get(), row, static_cast<int>(width)));
    }

private:
    void skip_extension(std::optional<std::size_t>& clear)
    {
        int code = 0;
        GifByteType* block = nullptr;
        check(DGifGetExtension(file_.get(), &code, &block));
        GraphicsControlBlock control{};
        if (code == GRAPHICS_EXT_FUNC_CODE && block && DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
            clear = control.TransparentColor == NO_TRANSPARENT_COLOR
                        ? std::nullopt
                        : std::optional(static_cast<std::size_t>(control.TransparentColor));
        while (block) check(DGifGetExtensionNext(file_.get(), &block));
    }

    void check(int result) const
    {
        if (result != GIF_OK) fail(file_->Error);
    }

    [[noreturn]] static void fail(int error)
    {
        const char* reason = GifErrorString(error);
        throw FileError(std::string("the GIF file is broken (") + (reason ? reason : "unknown failure") + ")");
    }

    static int read(GifFileType* file, GifByteType* out, int count)
    {
        auto* self = static_cast<GifDecoder*>(file->UserData);
        const std::size_t given =
            std::min(static_cast<std::size_t>(std::max(count, 0)), self->bytes_.size() - self->at_);
        std::copy_n(self->bytes_.data() + self->at_, given, out);
        self->at_ += given;
        return static_cast<int>(given);
    }

    struct Closer {
        void operator()(GifFileType* file) const { DGifCloseFile(file, nullptr); }
    };

    const ByteList& bytes_;
    std::size_t at_ = 0;
    std::unique_ptr<GifFileType, Closer> file_;
};

}  // namespace

Picture decode_gif(const ByteList& bytes)
{
    GifDecoder decoder(bytes);
    const std::optional<std::size_t> clear = decoder.find_picture();
    Picture out;
    out.width = decoder.description().Width;
    out.height = decoder.description().Height;
    if (out.width <= 0 || out.height <= 0) throw FileError("the GIF file holds no picture");
    if (out.count() > kSmallGif + kMostGifPixelsPerByte * bytes.size())
        throw FileError("the GIF file is broken (it ends too early)");
    const ColorMapObject* palette = decoder.palette();
    for (int i = 0; palette && i < palette->ColorCount; ++i) {
        const GifColorType& color = palette->Colors[i];
        for (const GifByteType level : {color.Red, color.Green, color.Blue})
            out.palette.push_back(static_cast<float>(level) / 255.0f);
        out.palette.push_back(clear == static_cast<std::size_t>(i) ? 0.0f : 1.0f);
    }
    const auto width = static_cast<std::size_t>(out.width);
    out.indices.resize(out.count());
    // In the file's order of rows even if they are interlaced, as POV-Ray takes them (spec 4, 12.10).
    for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y)
        decoder.read_row(&out.indices[y * width], width);
    finish_palette(out);
    return out;
}

}  // namespace image
