#include "parser/lexer/number_blocks.h"

#include "parser/lexer/short_number.h"

#include <charconv>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace parser {
namespace {

bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

class ListReader {
public:
    ListReader(const char* at, const char* end) : at_(at), end_(end) {}
    const char* at() const { return at_; }

    /// The next character that is no blank; 0: the text ends, or is such a character.
    char next()
    {
        while (at_ < end_ && (*at_ == ' ' || (*at_ >= '\t' && *at_ <= '\r'))) ++at_;
        return at_ < end_ ? *at_ : '\0';
    }
    bool accept(char c)
    {
        if (next() != c) return false;
        ++at_;
        return true;
    }
    /// A literal, with a minus or without.
    bool number(double& value)
    {
        const bool minus = accept('-');
        if (minus) next();
        if (!literal(value)) return false;
        if (minus) value = -value;
        return true;
    }
    /// `< a, b, c >`: `count` numbers.
    bool vector(double* values, int count)
    {
        if (next() == '<' && plain_vector(values, count)) return true;
        if (!accept('<')) return false;
        for (int i = 0; i < count; ++i)
            if (!number(values[i]) || !accept(i + 1 < count ? ',' : '>')) return false;
        return true;
    }

    /// A word of letters and '_', if that is what stands here.
    bool word(std::string_view wanted)
    {
        next();
        if (static_cast<std::size_t>(end_ - at_) <= wanted.size()) return false;
        if (std::memcmp(at_, wanted.data(), wanted.size()) != 0) return false;
        const char after = at_[wanted.size()];
        if (is_digit(after) || after == '_' || ((after | 0x20) >= 'a' && (after | 0x20) <= 'z')) return false;
        at_ += wanted.size();
        return true;
    }
    void go_back(const char* to) { at_ = to; }

private:
    /// A vector of short numbers with at most a blank between them. False: it stands where it stood.
    bool plain_vector(double* values, int count)
    {
        constexpr std::ptrdiff_t kMost = 3 * (kShortNumber + 3);
        if (end_ - at_ < kMost) return false;
        const char* at = at_;
        for (int i = 0; i < count; ++i) {
            ++at;  // '<' or ','
            at += *at == ' ' ? 1 : 0;
            const bool minus = *at == '-';
            at = short_number(at + (minus ? 1 : 0), values[i]);
            if (!at || *at != (i + 1 < count ? ',' : '>')) return false;
            values[i] = minus ? -values[i] : values[i];
        }
        at_ = at + 1;
        return true;
    }
    /// Numbers that do not round once are left to the library.
    bool literal(double& value)
    {
        const char* const begin = at_;
        std::uint64_t significand = 0;
        int count = 0, point = 0;
        const auto take_digits = [&] {
            const char* const from = at_;
            for (; at_ < end_ && is_digit(*at_); ++at_) {
                if (significand == 0 && *at_ == '0') continue;
                significand = significand * 10 + static_cast<std::uint64_t>(*at_ - '0');
                ++count;
            }
            return at_ - from;
        };
        std::ptrdiff_t length = take_digits();
        if (at_ < end_ && *at_ == '.') {
            ++at_;
            const std::ptrdiff_t behind = take_digits();
            length += behind;
            point = static_cast<int>(behind);
            if (at_ < end_ && *at_ == '.') return false;
        }
        if (length == 0 || length > kLongest) return false;
        int exponent = 0;
        if (at_ < end_ && (*at_ == 'e' || *at_ == 'E') && !take_exponent(exponent)) return false;
        if (at_ < end_ && (is_digit(*at_) || *at_ == '_' || ((*at_ | 0x20) >= 'a' && (*at_ | 0x20) <= 'z')))
            return false;
        const int power = exponent - point;
        if (count <= 19 && significand <= kExactDigits && power >= -22 && power <= 22) {
            const double whole = static_cast<double>(significand);
            value = power < 0 ? whole / kPowersOfTen[-power] : whole * kPowersOfTen[power];
            return true;
        }
        const auto result = std::from_chars(begin, at_, value);
        return result.ec == std::errc() && result.ptr == at_;
    }
    bool take_exponent(int& exponent)
    {
        ++at_;
        const bool minus = at_ < end_ && *at_ == '-';
        if (at_ < end_ && (*at_ == '-' || *at_ == '+')) ++at_;
        const char* const from = at_;
        for (; at_ < end_ && is_digit(*at_) && at_ - from < 5; ++at_) exponent = exponent * 10 + (*at_ - '0');
        if (minus) exponent = -exponent;
        return at_ != from;
    }

    static constexpr std::ptrdiff_t kLongest = 100;
    const char* at_;
    const char* end_;
};

/// Corners of a triangle, each with its normal if it is smooth.
bool read_corners(ListReader& in, std::vector<double>& values, NumberList& list, bool smooth)
{
    list = {smooth ? 6u : 3u, 3};
    const std::size_t begin = values.size();
    values.resize(begin + 3 * std::size_t{list.items});
    for (std::uint32_t i = 0; i < list.items; ++i) {
        if (i != 0) in.accept(',');
        if (!in.vector(&values[begin + 3 * std::size_t{i}], 3)) return false;
    }
    // A modifier or the end: no operator that goes on.
    const char after = in.next();
    return after == '}' || (after >= 'a' && after <= 'z');
}

/// Triangles one after the other, up to the first that has more than its corners.
bool read_faces(ListReader& in, std::vector<double>& values, NumberList& list)
{
    list = {0, 0};
    for (;; ++list.items) {
        const char* const begin = in.at();
        const bool smooth = in.next() == 's';
        const std::size_t before = values.size();
        NumberList corners;
        if (in.word(smooth ? "smooth_triangle" : "triangle") && in.accept('{')) {
            values.push_back(static_cast<double>(smooth ? kSmoothFace : kFlatFace));
            if (read_corners(in, values, corners, smooth) && in.accept('}')) continue;
        }
        values.resize(before);
        in.go_back(begin);
        return list.items > 0;
    }
}

bool ends_item(char c) { return c == ',' || c == '<' || c == '}'; }

/// Numbers of a face's textures, behind its indices.
bool read_face_textures(ListReader& in, double* textures, bool& any)
{
    textures[0] = textures[1] = textures[2] = kNoTexture;
    for (int t = 0; t < 3; ++t) {
        if (!in.accept(',')) break;
        const char c = in.next();
        if (c == '<' || c == '}') return true;
        if (!in.number(textures[t]) || !ends_item(in.next())) return false;
        if (textures[t] < 0.0) return false;
        any = true;
    }
    in.accept(',');
    return true;
}

/// Gives every face of the list six values.
void widen(std::vector<double>& values, std::size_t begin)
{
    const std::size_t items = (values.size() - begin) / 3;
    values.resize(begin + 6 * items);
    for (std::size_t i = items; i-- > 0;)
        for (std::size_t k = 6; k-- > 0;) values[begin + 6 * i + k] = k < 3 ? values[begin + 3 * i + k] : kNoTexture;
}

bool read_list(ListReader& in, std::vector<double>& values, NumberList& list, Kind keyword)
{
    const std::size_t begin = values.size();
    double count = 0.0;
    if (!in.number(count) || !(count >= 0.0) || !ends_item(in.next())) return false;
    in.accept(',');
    list = {0, keyword == Kind::UvVectors ? 2u : 3u};
    while (in.next() == '<') {
        double item[6];
        if (!in.vector(item, static_cast<int>(list.stride == 2 ? 2 : 3))) return false;
        if (!ends_item(in.next())) return false;
        if (keyword == Kind::FaceIndices) {
            bool any = false;
            if (!read_face_textures(in, item + 3, any)) return false;
            if (any && list.stride == 3) {
                widen(values, begin);
                list.stride = 6;
            }
        } else {
            in.accept(',');
        }
        for (std::uint32_t i = 0; i < list.stride; ++i) values.push_back(item[i]);
        ++list.items;
    }
    return in.next() == '}' && count == static_cast<double>(list.items);
}

}  // namespace

const char* read_number_list(Kind keyword, const char* at, const char* end, std::vector<double>& values,
                             NumberList& list, const char*& first)
{
    const std::size_t before = values.size();
    ListReader in(at, end);
    in.next();
    first = in.at();
    const bool corners = keyword == Kind::Triangle || keyword == Kind::SmoothTriangle;
    const bool read = keyword == Kind::Mesh ? read_faces(in, values, list)
                      : corners             ? read_corners(in, values, list, keyword == Kind::SmoothTriangle)
                                            : read_list(in, values, list, keyword);
    if (read) return in.at();
    values.resize(before);
    return nullptr;
}

}  // namespace parser
