#include "statement.h"

#include <cctype>
#include <map>
#include <stdexcept>
#include <vector>

namespace test {
namespace {

/// Words, numbers and single marks, in order.
std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> out;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c)) || c == ',') {
            ++i;
            continue;
        }
        std::size_t j = i + 1;
        const auto part_of_word = [&](char k) {
            return std::isalnum(static_cast<unsigned char>(k)) || k == '_' || k == '.';
        };
        if (part_of_word(c) || c == '-')
            while (j < text.size() && part_of_word(text[j])) ++j;
        out.push_back(text.substr(i, j - i));
        i = j;
    }
    return out;
}

class Reader {
public:
    explicit Reader(const std::string& text) : words_(split(text)) {}

    Statement read()
    {
        if (peek() != "warp" && peek() != "turbulence" && peek() != "scale" && peek() != "rotate") type();
        while (at_ < words_.size()) modifier(next());
        return std::move(out_);
    }

private:
    std::string peek() const { return at_ < words_.size() ? words_[at_] : std::string(); }
    std::string next()
    {
        if (at_ == words_.size()) throw std::runtime_error("statement ends too early");
        return words_[at_++];
    }
    bool accept(const std::string& word)
    {
        if (peek() != word) return false;
        ++at_;
        return true;
    }
    bool at_number() const
    {
        const std::string w = peek();
        return !w.empty() &&
               (std::isdigit(static_cast<unsigned char>(w[0])) || w[0] == '.' || (w[0] == '-' && w.size() > 1));
    }
    double number() { return std::stod(next()); }

    /// `<1, 2, 3>`, `x`, `0.7*x` (the star is its own word) or one number for all three.
    glm::dvec3 vector()
    {
        if (accept("<")) {
            glm::dvec3 v(0);
            for (int k = 0; k < 3 && peek() != ">"; ++k) v[k] = number();
            accept(">");
            return v;
        }
        if (at_number()) {
            const double a = number();
            if (accept("*")) return a * vector();
            return glm::dvec3(a);
        }
        static const std::map<std::string, glm::dvec3> axes{{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
        const glm::dvec3 axis = axes.at(next());
        if (accept("*")) return number() * axis;
        return axis;
    }

    void type()
    {
        scene::Pattern& p = out_.pattern;
        p.name = next();
        static const std::map<std::string, std::vector<double>> defaults{
            {"agate", {1}}, {"brick", {0.5}}, {"crackle", {2, 0, 0}}, {"facets", {0.1, 0, 2}}, {"quilted", {1, 1}}};
        const auto found = defaults.find(p.name);
        if (found != defaults.end()) p.numbers = found->second;
        if (p.name == "agate") p.turbulence.emplace();
        if (p.name == "brick") p.vector = {8, 3, 4.5};
        if (p.name == "crackle") p.vector = {-1, 1, 0};
        if (p.name == "gradient") p.vector = vector();
        if (p.name == "marble" || p.name == "wood" || p.name == "spiral1" || p.name == "spiral2")
            p.wave = scene::WaveForm::Triangle;
        for (const char* cells : {"checker", "brick", "hexagon", "square", "triangular", "cubic", "quilted"})
            if (p.name == cells) p.frequency = 0;
        if (p.name == "spiral1" || p.name == "spiral2") p.numbers = {number()};
        if (p.name == "magnet") magnet();
        else if (p.name == "mandel" || p.name == "julia") fractal();
    }
    void fractal()
    {
        scene::Pattern& p = out_.pattern;
        if (p.name == "julia" || p.name == "magnet_julia") p.vector = vector();
        p.numbers = {number(), 2, 1, 1, 0, 1};
    }
    void magnet()
    {
        const double kind = number();
        out_.pattern.name = "magnet_" + next();
        fractal();
        out_.pattern.numbers.push_back(kind);
    }

    scene::Turbulence& turbulence()
    {
        if (!out_.pattern.turbulence) out_.pattern.turbulence.emplace();
        return *out_.pattern.turbulence;
    }

    bool wave(const std::string& w)
    {
        using Form = scene::WaveForm;
        static const std::map<std::string, Form> forms{
            {"sine_wave", Form::Sine},   {"triangle_wave", Form::Triangle}, {"scallop_wave", Form::Scallop},
            {"cubic_wave", Form::Cubic}, {"poly_wave", Form::Poly},         {"ramp_wave", Form::Ramp}};
        const auto found = forms.find(w);
        if (found == forms.end()) return false;
        out_.pattern.wave = found->second;
        if (found->second == Form::Poly && at_number()) out_.pattern.poly_exponent = number();
        return true;
    }

    bool parameter(const std::string& w)
    {
        scene::Pattern& p = out_.pattern;
        static const std::map<std::string, std::size_t> places{{"agate_turb", 0}, {"mortar", 0}, {"control0", 0},
                                                               {"control1", 1},   {"offset", 1}, {"size", 0},
                                                               {"coords", 1}};
        if (w == "metric") p.numbers.at(p.name == "facets" ? 2 : 0) = number();
        else if (w == "solid") p.numbers.at(2) = 1;
        else if (w == "form" || w == "brick_size") p.vector = vector();
        else if (w == "exponent") p.numbers.at(1) = number();
        else if (w == "exterior" || w == "interior") {
            const std::size_t first = w == "exterior" ? 2 : 4;
            p.numbers.at(first) = number();
            p.numbers.at(first + 1) = number();
        } else if (places.count(w)) p.numbers.at(places.at(w)) = number();
        else return false;
        return true;
    }

    void modifier(const std::string& w)
    {
        scene::Pattern& p = out_.pattern;
        if (wave(w) || parameter(w)) return;
        if (w == "noise_generator") p.noise_generator = static_cast<int>(number());
        else if (w == "turbulence") turbulence().amount = vector();
        else if (w == "octaves") turbulence().octaves = static_cast<int>(number());
        else if (w == "lambda") turbulence().lambda = number();
        else if (w == "omega") turbulence().omega = number();
        else if (w == "frequency") p.frequency = number();
        else if (w == "phase") p.phase = number();
        else if (w == "accuracy") out_.accuracy = number();
        else if (w == "scale") p.transform(csg::Transform::scale(vector()));
        else if (w == "rotate") p.transform(csg::Transform::rotate_degrees(vector()));
        else if (w == "translate") p.transform(csg::Transform::translate(vector()));
        else if (w == "warp") warp();
        else if (!w.empty() && (std::isdigit(static_cast<unsigned char>(w[0])) || w[0] == '.'))
            out_.amount = std::stod(w);
        else throw std::runtime_error("unknown word " + w);
    }

    void warp()
    {
        accept("{");
        const std::string w = next();
        auto& warps = out_.pattern.warps;
        if (w == "turbulence") warps.push_back(warp_turbulence());
        else if (w == "repeat") warps.push_back(repeat());
        else if (w == "black_hole") warps.push_back(black_hole());
        else warps.push_back(mapping(w));
        if (!accept("}")) throw std::runtime_error("warp does not end");
    }
    scene::Turbulence warp_turbulence()
    {
        scene::Turbulence t;
        t.amount = vector();
        while (peek() != "}") {
            const std::string w = next();
            if (w == "octaves") t.octaves = static_cast<int>(number());
            else if (w == "lambda") t.lambda = number();
            else if (w == "omega") t.omega = number();
            else throw std::runtime_error("unknown word " + w);
        }
        return t;
    }
    scene::RepeatWarp repeat()
    {
        scene::RepeatWarp r;
        r.width = vector();
        while (peek() != "}") {
            glm::dvec3& target = next() == "offset" ? r.offset : r.flip;
            target = vector();
        }
        return r;
    }
    scene::BlackHoleWarp black_hole()
    {
        scene::BlackHoleWarp h;
        h.center = vector();
        h.radius = number();
        while (peek() != "}") {
            const std::string w = next();
            if (w == "strength") h.strength = number();
            else if (w == "falloff") h.falloff = number();
            else if (w == "inverse") h.inverse = true;
            else if (w == "repeat") h.repeat = vector();
            else if (w == "turbulence") h.turbulence = vector();
            else throw std::runtime_error("unknown word " + w);
        }
        return h;
    }
    scene::MappingWarp mapping(const std::string& kind)
    {
        using Kind = scene::MappingWarp::Kind;
        static const std::map<std::string, Kind> kinds{{"planar", Kind::Planar},
                                                       {"cylindrical", Kind::Cylindrical},
                                                       {"spherical", Kind::Spherical},
                                                       {"toroidal", Kind::Toroidal},
                                                       {"cubic", Kind::Cubic}};
        scene::MappingWarp m;
        m.kind = kinds.at(kind);
        if (m.kind == Kind::Planar && peek() != "}") {
            m.orientation = glm::normalize(vector());
            m.distance = number();
        }
        while (peek() != "}") {
            const std::string w = next();
            if (w == "orientation") m.orientation = glm::normalize(vector());
            else if (w == "dist_exp") m.dist_exp = number();
            else if (w == "major_radius") m.major_radius = number();
            else throw std::runtime_error("unknown word " + w);
        }
        return m;
    }

    std::vector<std::string> words_;
    std::size_t at_ = 0;
    Statement out_;
};

}  // namespace

Statement read_statement(const std::string& text) { return Reader(text).read(); }

}  // namespace test
