#pragma once

#include "render/model/base/model.h"

#include <string>

/// What a reader of models says about bytes, behind the byte or the line that it tells; "none" where they are good.
template <class Read>
std::string failure_of(const Read& read, const std::string& bytes)
{
    try {
        (void)read(bytes);
    } catch (const model::ModelError& error) {
        std::string place;
        if (error.byte != model::ModelError::kNowhere) place = "byte " + std::to_string(error.byte) + ": ";
        else if (error.line > 0) place = std::to_string(error.line) + ": ";
        return place + error.what();
    }
    return "none";
}
