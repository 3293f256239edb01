#pragma once

#include "parser/lexer/token.h"

namespace parser {

/// The numbers that a colour keyword takes (reference manual: Color Keywords).
struct ColorWord {
    int components = 0;      ///< 3 to 5; 0: it is no colour keyword
    bool transmits = false;  ///< the fourth number is transmit, not filter
    bool encoded = false;    ///< red, green and blue are sRGB's
};

constexpr ColorWord color_word(Kind keyword)
{
    switch (keyword) {
    case Kind::Rgb: return {3, false, false};
    case Kind::Rgbf: return {4, false, false};
    case Kind::Rgbt: return {4, true, false};
    case Kind::Rgbft: return {5, false, false};
    case Kind::Srgb: return {3, false, true};
    case Kind::Srgbf: return {4, false, true};
    case Kind::Srgbt: return {4, true, true};
    case Kind::Srgbft: return {5, false, true};
    default: return {};
    }
}

}  // namespace parser
