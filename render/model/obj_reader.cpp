#include "render/model/obj_reader.h"

#include "render/model/base/polygon_triangles.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

namespace model {
namespace {

constexpr std::string_view kBlank = " \t\r\f\v";

/// One statement: what stands on a line, or on several that a backslash joins.
class Words {
public:
    explicit Words(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    std::string_view next()
    {
        skip();
        const char* const from = at_;
        while (at_ != end_ && !blank(*at_)) ++at_;
        return {from, static_cast<std::size_t>(at_ - from)};
    }
    /// Without blanks at its ends.
    std::string_view rest()
    {
        skip();
        std::string_view all(at_, static_cast<std::size_t>(end_ - at_));
        all.remove_suffix(all.size() - (all.find_last_not_of(kBlank) + 1));
        at_ = end_;
        return all;
    }

private:
    static bool blank(char c) { return kBlank.find(c) != std::string_view::npos; }
    void skip()
    {
        while (at_ != end_ && blank(*at_)) ++at_;
    }
    const char *at_, *end_;
};

struct Corner {
    std::uint32_t vertex, uv, normal;
};

class ObjText {
public:
    explicit ObjText(std::string_view text) : text_(text) {}

    Model read()
    {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
        if (text_.find('\0') != std::string_view::npos) fail("this is no text file");
        while (next_statement()) statement();
        if (model_.faces.empty()) throw ModelError("it has no faces", 0);
        return std::move(model_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw ModelError(what, line_); }

    /// The next line, with those that it continues in `joined_`.
    bool next_statement()
    {
        line_ += lines_;
        lines_ = 0;
        joined_.clear();
        while (place_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', place_), text_.size());
            std::string_view one = text_.substr(place_, end - place_);
            place_ = end + 1;
            ++lines_;
            if (one.ends_with('\r')) one.remove_suffix(1);
            const bool goes_on = one.ends_with('\\');
            if (goes_on) one.remove_suffix(1);
            if (!goes_on && joined_.empty()) {
                statement_ = one;
                return true;
            }
            joined_ += one;
            joined_ += ' ';
            statement_ = joined_;
            if (!goes_on) return true;
        }
        return lines_ > 0;
    }

    void statement()
    {
        const std::string_view all = statement_.substr(0, std::min(statement_.find('#'), statement_.size()));
        Words words(all);
        const std::string_view word = words.next();
        if (word == "v") model_.vertices.push_back(numbers<3>(words, "a vertex", 3));
        else if (word == "f") face(words);
        else if (word == "vn") model_.normals.push_back(numbers<3>(words, "a normal", 3));
        else if (word == "vt") model_.uvs.push_back(numbers<2>(words, "a texture coordinate", 1));
        else if (word == "usemtl") material(words.rest());
        else if (word == "mtllib") model_.libraries.emplace_back(words.rest());
    }

    /// `least`: so many must be there, others are 0.
    template <int count>
    glm::vec<count, double> numbers(Words& words, const char* what, int least)
    {
        glm::vec<count, double> out(0.0);
        for (int i = 0; i < count; ++i) {
            const std::string_view one = words.next();
            if (one.empty() && i >= least) break;
            if (one.empty()) fail(std::string(what) + " has too few numbers");
            const std::string_view digits = one.starts_with('+') ? one.substr(1) : one;
            const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), out[i]);
            if (failed == std::errc::result_out_of_range) out[i] = 0.0;  // too small: what is too large is no number
            else if (failed != std::errc() || end != digits.data() + digits.size() || !std::isfinite(out[i]))
                fail("'" + std::string(one) + "' is no number");
        }
        return out;
    }

    /// One of a corner's three indices, which count from 1, or from the last one backwards. Empty: it has none.
    std::uint32_t index(std::string_view text, std::size_t count, const char* what)
    {
        if (text.empty()) return kNone;
        long long n = 0;
        const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), n);
        if (failed != std::errc() || end != text.data() + text.size())
            fail("'" + std::string(text) + "' is no index of a " + what);
        const auto have = static_cast<long long>(count);
        if (n == 0 || n > have || n < -have)
            fail("there is no " + std::string(what) + " " + std::to_string(n) + ": " + std::to_string(count) +
                 " are above this line");
        return static_cast<std::uint32_t>(n > 0 ? n - 1 : have + n);
    }

    void face(Words& words)
    {
        corners_.clear();
        for (std::string_view one = words.next(); !one.empty(); one = words.next()) {
            std::array<std::string_view, 3> parts{};
            std::size_t part = 0, from = 0;
            for (std::size_t i = 0; i <= one.size(); ++i) {
                if (i < one.size() && one[i] != '/') continue;
                if (part == parts.size()) fail("'" + std::string(one) + "' has more than three indices");
                parts[part++] = one.substr(from, i - from);
                from = i + 1;
            }
            if (parts[0].empty()) fail("'" + std::string(one) + "' names no vertex");
            corners_.push_back({index(parts[0], model_.vertices.size(), "vertex"),
                                index(parts[1], model_.uvs.size(), "texture coordinate"),
                                index(parts[2], model_.normals.size(), "normal")});
        }
        if (corners_.size() < 3) fail("a face needs at least three corners");
        if (corners_.size() == 3) return add(0, 1, 2);
        outline_.clear();
        for (const Corner& corner : corners_) outline_.push_back(model_.vertices[corner.vertex]);
        triangulate(outline_, triangles_);
        for (const auto& [a, b, c] : triangles_) add(a, b, c);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const Corner &p = corners_[a], &q = corners_[b], &r = corners_[c];
        Model::Face face;
        face.vertex = {p.vertex, q.vertex, r.vertex};
        if (p.normal != kNone && q.normal != kNone && r.normal != kNone) face.normal = {p.normal, q.normal, r.normal};
        if (p.uv != kNone && q.uv != kNone && r.uv != kNone) face.uv = {p.uv, q.uv, r.uv};
        face.material = material_;
        model_.faces.push_back(face);
    }

    void material(std::string_view name)
    {
        if (name.empty()) fail("usemtl without a name");
        const auto [known, fresh] =
            known_.try_emplace(std::string(name), static_cast<std::uint32_t>(model_.materials.size()));
        if (fresh) model_.materials.emplace_back().name = name;
        material_ = known->second;
    }

    std::string_view text_, statement_;
    std::string joined_;
    std::size_t place_ = 0, line_ = 1, lines_ = 0;  ///< of the statement: its first line, and how many it has
    Model model_;
    std::uint32_t material_ = kNone;
    std::unordered_map<std::string, std::uint32_t> known_;
    std::vector<Corner> corners_;
    std::vector<glm::dvec3> outline_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

Model obj_of(std::string_view text) { return ObjText(text).read(); }

}  // namespace model
