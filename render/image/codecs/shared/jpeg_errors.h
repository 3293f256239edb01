#pragma once

#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h wants it first
#include <jpeglib.h>

namespace image {

/// What libjpeg reports, and where it jumps to when it fails; what it only warns of is taken as it is. It leaves by
/// longjmp: nothing with a destructor may be made between setjmp(failed) and its calls.
struct JpegErrors {
    jpeg_error_mgr manager{};
    std::jmp_buf failed{};
    std::array<char, JMSG_LENGTH_MAX> message{};

    /// Of a decoder or an encoder.
    template <class State>
    void take(State& state)
    {
        state.err = jpeg_std_error(&manager);
        state.client_data = this;
        manager.error_exit = [](j_common_ptr at) {
            auto* self = static_cast<JpegErrors*>(at->client_data);
            at->err->format_message(at, self->message.data());
            std::longjmp(self->failed, 1);
        };
        manager.emit_message = [](j_common_ptr, int) {};
    }
};

}  // namespace image
