#pragma once

#include "render/app/frames/frames.h"
#include "render/image/files.h"
#include "render/picture/blocks.h"

#include <cstddef>
#include <exception>
#include <string>

namespace app {

/// Bytes of a traced pixel.
inline constexpr double kTracedPixelBytes = 16.0;

/// Bytes of the traced picture.
double picture_bytes(const Settings& settings);

/// What a picture's pixels may take: --memory, or half of what the system, the control group and the process have left.
/// Nobody is asked, and it is infinite, where few bytes are needed: the program itself takes as many.
double picture_memory(const Settings& settings, double needed);

/// Whether so many bytes, 0 or more, are within picture_memory().
bool has_memory_for(const Settings& settings, double bytes);

/// Rows [first, last) of blocks that are in memory at a time; all of them where the picture fits.
/// \param memory bytes \return rows of blocks; 0: not even one fits
std::size_t rows_of_blocks_in(double memory, const trace::Blocks& blocks, int width, int height, image::FileType type);

/// Refuses, before anything is read, what cannot fit into memory, the type of file or the folder. Throws OptionError.
/// \param path of the picture; empty: standard output
void check_fits(const Settings& settings, const std::string& path);

/// Bytes from which on a piece of memory is mapped by itself instead of coming from the heap; glibc takes no greater
/// limit.
inline constexpr int kMapped = 32 << 20;

/// Throws what `new` throws where the system refuses memory: its message has this size, what is used and what is
/// allowed.
[[noreturn]] void refuse_memory(std::size_t bytes);
/// What an exception says, of refused memory that too.
std::string text_of(const std::exception& error);
/// Whether it says that the system starts no more threads.
bool refuses_thread(const std::exception& error);

/// Whether the folder of `path` has room for the picture and a state of all its blocks.
bool has_room_for_state(const Settings& settings, const std::string& path);

}  // namespace app
