#include "render/model/base/zip_reader.h"

#include "render/model/base/model.h"

#include <zlib.h>

#include <algorithm>

// Numbers below are those of PKWARE's APPNOTE.TXT 6.3.9, section 4.3.
namespace model {
namespace {

constexpr std::uint64_t kStored = 0, kDeflated = 8, kInExtra = 0xffffffffu;

}  // namespace

/// Little-endian.
std::uint64_t ZipReader::number(std::uint64_t at, std::size_t count) const
{
    if (at > bytes_.size() || bytes_.size() - at < count)
        throw ModelError::at_byte("its ZIP directory ends", bytes_.size());
    std::uint64_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[at + i]);
    return value;
}

/// Where the directory begins.
std::uint64_t ZipReader::directory(std::uint64_t& count) const
{
    constexpr std::size_t kTail = 22, kMostComment = 65535, kLocator = 20;
    constexpr std::string_view kMark("PK\5\6", 4), kLongMark("PK\6\7", 4);
    const std::size_t last = bytes_.rfind(kMark);
    if (last == std::string_view::npos || bytes_.size() - last < kTail || bytes_.size() - last > kTail + kMostComment)
        throw ModelError::at_byte("its ZIP directory is missing: it may be cut off", bytes_.size());
    count = number(last + 10, 2);
    std::uint64_t begin = number(last + 16, 4);
    if (last >= kLocator && bytes_.substr(last - kLocator, 4) == kLongMark) {
        const std::uint64_t tail = number(last - kLocator + 8, 8);
        count = number(tail + 32, 8);
        begin = number(tail + 48, 8);
    }
    return begin;
}

ZipReader::ZipReader(std::string_view bytes) : bytes_(bytes), room_((std::uint64_t{1} << 20) + 200 * bytes.size())
{
    constexpr std::size_t kHead = 46;
    std::uint64_t count = 0, at = directory(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (number(at, 4) != 0x02014b50u)
            throw ModelError::at_byte("no entry of its ZIP directory stands here",
                                      std::min<std::uint64_t>(at, bytes_.size()));
        Entry entry;
        entry.method = static_cast<std::uint32_t>(number(at + 10, 2));
        entry.sum = static_cast<std::uint32_t>(number(at + 16, 4));
        entry.packed = number(at + 20, 4);
        entry.length = number(at + 24, 4);
        entry.at = number(at + 42, 4);
        const std::uint64_t name = number(at + 28, 2), extra = number(at + 30, 2), comment = number(at + 32, 2);
        number(at + kHead + name, 0);
        // Numbers of 64 bits stand behind the name, those that did not fit, in this order.
        for (std::uint64_t of = at + kHead + name, end = of + extra; of + 4 <= end;) {
            const std::uint64_t kind = number(of, 2), length = number(of + 2, 2);
            std::uint64_t field = of + 4;
            of = field + length;
            if (kind != 1) continue;
            for (std::uint64_t* one : {&entry.length, &entry.packed, &entry.at})
                if (*one == kInExtra && field + 8 <= of) *one = number(field, 8), field += 8;
        }
        entries_.emplace(std::string(bytes_.substr(at + kHead, name)), entry);
        at += kHead + name + extra + comment;
    }
}

std::string ZipReader::read(const std::string& name)
{
    const auto found = entries_.find(name);
    if (found == entries_.end()) throw ModelError("there is no '" + name + "' in it", 0);
    const Entry& entry = found->second;
    constexpr std::size_t kHead = 30;
    if (entry.at > bytes_.size()) throw ModelError::at_byte("'" + name + "' begins behind its end", bytes_.size());
    const std::uint64_t begin = entry.at + kHead + number(entry.at + 26, 2) + number(entry.at + 28, 2);
    if (begin > bytes_.size() || entry.packed > bytes_.size() - begin)
        throw ModelError::at_byte("it ends within '" + name + "'", bytes_.size());
    if (entry.length > room_) throw ModelError::at_byte("'" + name + "' is too long for a file of this size", entry.at);
    room_ -= entry.length;
    const std::string_view packed = bytes_.substr(begin, entry.packed);
    std::string out;
    if (entry.method == kStored) {
        out = packed;
    } else if (entry.method == kDeflated && entry.packed < kInExtra && entry.length < kInExtra) {
        out.resize(entry.length);
        z_stream stream{};
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream.avail_in = static_cast<uInt>(packed.size());
        stream.next_out = reinterpret_cast<Bytef*>(out.data());
        stream.avail_out = static_cast<uInt>(out.size());
        if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw ModelError("no memory is left to read it", 0);
        const int status = inflate(&stream, Z_FINISH);
        inflateEnd(&stream);
        if (status != Z_STREAM_END || stream.avail_out != 0)
            throw ModelError::at_byte("the deflated '" + name + "' is broken", begin + stream.total_in);
    } else {
        throw ModelError::at_byte("'" + name + "' is packed by a method that is not read", entry.at);
    }
    if (crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(out.data()), static_cast<uInt>(out.size())) !=
        entry.sum)
        throw ModelError::at_byte("'" + name + "' is not what its checksum says", begin);
    return out;
}

}  // namespace model
