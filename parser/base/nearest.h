#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parser {

/// Keeps the candidate nearest to `word`, if any is near enough to be a slip of the pen.
class NearestName {
public:
    explicit NearestName(std::string_view word);
    void offer(std::string_view candidate);
    std::string_view best() const { return best_; }  ///< empty if none

private:
    std::string_view word_, best_;
    std::size_t distance_;
};

/// The name nearest to `word`, upper and lower case being one; empty if none is near enough to be a slip of the pen.
std::string nearest_of(std::string_view word, const std::vector<std::string>& names);

}  // namespace parser
