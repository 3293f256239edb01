#pragma once

#include "render/app/watch/place/spotlight.h"
#include "render/app/watch/view.h"

#include <optional>
#include <string>

namespace app {

/// What a page asks to be changed of a view; what it does not name stays.
struct ViewChange {
    std::optional<std::optional<double>> clock;
    std::optional<std::map<std::string, double>> declared;
    std::optional<std::map<std::string, NumberEdits>> numbers;
    std::optional<View::Orbit> orbit;
    std::optional<std::optional<View::Cut>> cut;
    std::optional<std::uint64_t> request;

    void apply(View& view) const;
};

/// \param body  JSON of a page, which may be anything
/// \param looked  whose numbers may be set: those of files that it has read; null: none
/// \return nothing: it is no object
std::optional<ViewChange> view_change(const std::string& body, const Looked* looked);

}  // namespace app
