#include "bench/numerics/measure.h"

#include "bench/numerics/oracle.h"
#include "csg/tree/front.h"
#include "csg/items/spawn_epsilon.h"
#include "csg/base/tolerance.h"

#include <algorithm>
#include <chrono>

namespace numerics {
namespace {

using csg::Ray;
constexpr std::uint32_t kMostSpans = 160;
/// A crossing farther than this part of the object's size is another one, not a spawned ray's own start.
constexpr double kFarStart = 1e-2;

Parts parts(const csg::Solid& solid, const Ray& ray, double shift = 0.0)
{
    return std::visit(
        [&](const auto& s) -> Parts {
            if constexpr (requires { parts_of(s, along(ray, shift)); }) return parts_of(s, along(ray, shift));
            else return {};
        },
        solid);
}

/// A parameter near the solid.
double near(const csg::Solid& solid, const Ray& ray, double otherwise)
{
    return std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.frame; }) return foot(s.frame, ray);
            else return otherwise;
        },
        solid);
}

csg::Transform frame_of(const csg::Solid& solid)
{
    return std::visit(
        [](const auto& s) {
            if constexpr (requires { s.frame; }) return s.frame;
            else return csg::Transform{};
        },
        solid);
}

/// A solid's ends; of a surface what is seen.
class Answers {
public:
    explicit Answers(const Case& given) : solid_(given.solid), surface_(given.form && !given.form->holds)
    {
        if (surface_) object_.program = csg::build(csg::Tree::leaf(object_.store.add(solid_)), object_.store);
    }

    std::vector<double> operator()(const Ray& ray, std::vector<std::uint32_t>* faces = nullptr)
    {
        std::vector<double> ends;
        const auto add = [&](const csg::Crossing& end) {
            if (!(end.t > -numbers::kInfinity && end.t < numbers::kInfinity)) return;
            ends.push_back(end.t);
            if (faces) faces->push_back(end.face);
        };
        if (surface_) {
            const auto [first, last] = csg::visible_crossings(object_.program, object_.store, ray, -numbers::kInfinity,
                                                              numbers::kInfinity, object_.scratch);
            std::for_each(first, last, add);
            return ends;
        }
        csg::FixedSpans<kMostSpans> spans;
        std::visit([&](const auto& s) { csg::intersect(s, ray, spans); }, solid_);
        for (const csg::Span& span : spans) {
            add(span.in);
            add(span.out);
        }
        return ends;
    }

    /// As many answers as there are rays, and nothing done with them: what is timed.
    std::uint64_t count(const std::vector<Ray>& rays)
    {
        std::uint64_t ends = 0;
        if (surface_) {
            for (const Ray& ray : rays) {
                const auto [first, last] = csg::visible_crossings(
                    object_.program, object_.store, ray, -numbers::kInfinity, numbers::kInfinity, object_.scratch);
                ends += static_cast<std::uint64_t>(last - first);
            }
            return ends;
        }
        std::visit(
            [&](const auto& s) {
                for (const Ray& ray : rays) {
                    csg::FixedSpans<kMostSpans> spans;
                    csg::intersect(s, ray, spans);
                    ends += spans.size();
                }
            },
            solid_);
        return ends;
    }

private:
    const csg::Solid& solid_;
    const bool surface_;
    csg_test::Object object_;
};

/// The normal of the surface itself, not one that it is lit by.
glm::dvec3 facing(const Case& given, const glm::dvec3& p, std::uint32_t face)
{
    const csg::Solid& solid = given.solid;
    if (given.form && given.form->slope) return slope(*given.form, frame_of(solid), p);
    if (const auto* triangle = std::get_if<csg::Triangle>(&solid))
        return glm::normalize(glm::cross(triangle->edge1, triangle->edge2));
    return std::visit([&](const auto& s) { return s.normal(p, face); }, solid);
}

/// What one ray adds to a row.
class Judge {
public:
    Judge(const Case& given, Row& row, std::vector<double>& errors)
        : case_(given), answers_(given), band_(band_of(row.solid)), row_(row), errors_(errors),
          reach_(glm::max(given.distance, given.size)),
          tolerance_(csg::Tolerance::of_scene(given.distance + given.size))
    {}

    void ray(const Ray& ray, csg_test::Rng& rng, Asked* asked)
    {
        const double low = case_.distance - 20.0 * case_.size, high = case_.distance + 20.0 * case_.size;
        std::vector<std::uint32_t> faces;
        std::vector<double> ends = answers_(ray, &faces);
        if (spoiled) spoil(ends, faces);
        const std::vector<Quad> truth = truth_of(ray, low, high, case_.distance, ends);
        ++row_.rays;
        if (case_.form && case_.form->first_only) nearest(ray, truth, ends, faces, low, high);
        else all(ray, truth, ends, faces, low, high);
        point(ray, rng, low, high);
        if (asked) first(ray, truth, *asked);
    }

private:
    void all(const Ray& ray, const std::vector<Quad>& truth, const std::vector<double>& ends,
             const std::vector<std::uint32_t>& faces, double low, double high)
    {
        std::size_t i = 0, j = 0;
        const double close = 1e-3 * case_.size + 1e-12 * reach_;
        while (i < truth.size() || j < ends.size()) {
            if (j < ends.size() && (ends[j] < low || ends[j] > high)) {
                ++j;
                continue;
            }
            const bool both = i < truth.size() && j < ends.size();
            const double gap = both ? static_cast<double>(ends[j] - truth[i]) : 0.0;
            if (both && std::abs(gap) <= close) {
                error(ray, gap, ends[j], faces[j], 1.0);
                ++i, ++j;
            } else if (!both ? i < truth.size() : gap > 0.0) {
                const bool tangent = i + 1 < truth.size() &&
                                     truth[i + 1] - truth[i] < band_ * case_.size + 1e-15 * reach_;
                row_.missed += tangent ? 0 : 1;
                i += tangent ? 2 : 1;
            } else {
                const bool tangent = j + 1 < ends.size() && ends[j + 1] - ends[j] < band_ * case_.size + 1e-15 * reach_;
                row_.wrong += tangent ? 0 : 1;
                j += tangent ? 2 : 1;
            }
        }
    }

    /// Of a surface that tells its nearest crossing only, and that where a small box begins.
    void nearest(const Ray& ray, const std::vector<Quad>& truth, const std::vector<double>& ends,
                 const std::vector<std::uint32_t>& faces, double low, double high)
    {
        const csg::Transform frame = frame_of(case_.solid);
        const glm::dvec3 way = case_.size * frame.inverse_vector(ray.direction);
        const auto spread = [&](double t) {
            return case_.form->bar *
                   case_.form->spread(way, glm::normalize(glm::transpose(frame.linear) * facing(case_, ray.at(t), 0)));
        };
        if (truth.empty()) {
            if (ends.empty()) return;
            // Beside it, no farther than it may be off, a ray does meet it.
            bool beside = false;
            for (int axis = 0; axis < 6 && !beside; ++axis) {
                const glm::dvec3 aside = (axis < 3 ? 2.0 : -2.0) * case_.form->bar * frame.linear[axis % 3];
                beside = !truth_of({ray.origin + aside, ray.direction}, low, high, case_.distance, ends).empty();
            }
            row_.wrong += beside ? 0 : 1;
            return;
        }
        const auto t = static_cast<double>(truth[0]);
        const double off = spread(t), gap = ends.empty() ? numbers::kInfinity : ends[0] - t;
        if (std::abs(gap) <= off * case_.size + 1e-12 * reach_)
            return error(ray, gap, ends[0], faces[0], off / case_.form->bar);
        // Where it may be told farther off than its size it need not be told.
        if (off > 1.0 || (truth.size() > 1 && truth[1] - truth[0] < band_ * case_.size + 1e-15 * reach_)) return;
        ++row_.missed;
        row_.wrong += ends.empty() ? 0 : 1;
    }

    void spoil(std::vector<double>& ends, std::vector<std::uint32_t>& faces) const
    {
        const auto n = static_cast<std::ptrdiff_t>(ends.size());
        if (row_.rays % 7 == 3 && n > 0) {
            ends.erase(ends.begin() + row_.rays % n);
            faces.erase(faces.begin() + row_.rays % n);
        } else if (row_.rays % 7 == 5) {
            const auto place = std::lower_bound(ends.begin(), ends.end(), case_.distance + 0.37 * case_.size);
            faces.insert(faces.begin() + (place - ends.begin()), n > 0 ? faces[0] : 0);
            ends.insert(place, case_.distance + 0.37 * case_.size);
        }
    }

    std::vector<Quad> truth_of(const Ray& ray, double low, double high, double otherwise,
                               const std::vector<double>& told) const
    {
        if (const auto* triangle = std::get_if<csg::Triangle>(&case_.solid))
            return crossings(*triangle, ray, low, high);
        if (case_.form) return crossings(*case_.form, frame_of(case_.solid), ray, low, high, told);
        const double middle = near(case_.solid, ray, otherwise);
        std::vector<Quad> truth = crossings(parts(case_.solid, ray, middle), static_cast<Quad>(low) - middle,
                                            static_cast<Quad>(high) - middle);
        for (Quad& t : truth) t += middle;
        return truth;
    }

    void error(const Ray& ray, double gap, double t, std::uint32_t face, double spread)
    {
        ++row_.hits;
        if (face == csg::kUndrawnFace) return;  // it has no normal, and nothing is spawned there
        const glm::dvec3 p = ray.at(t), n = facing(case_, p, face);
        const double incidence = std::abs(glm::dot(n, ray.direction)), relative = std::abs(gap) / (spread * reach_);
        if (incidence < kClear) {
            row_.grazing = glm::max(row_.grazing, relative);
            return;
        }
        row_.worst = glm::max(row_.worst, relative);
        errors_.push_back(relative);
        if (row_.hits % 4 == 0) {
            const Ray next{p, ray.direction - 2.0 * glm::dot(ray.direction, n) * n};
            spawned(next,
                    std::visit(
                        [&](const auto& solid) {
                            return csg::spawn_epsilon(solid, next, t, incidence, glm::dot(n, ray.direction) > 0.0,
                                                      tolerance_.hit_from(p, t));
                        },
                        case_.solid),
                    incidence);
        }
    }

    /// Leaves a hit as a mirror does: where does it meet its own start again?
    void spawned(const Ray& ray, double tolerance, double incidence)
    {
        ++spawns_;
        double own = numbers::kInfinity,
               beyond = numbers::kInfinity;  // the nearest; of those ahead, beyond the tolerance
        std::vector<std::uint32_t> faces;
        const std::vector<double> ends = answers_(ray, &faces);
        for (const double t : ends) {
            own = glm::min(own, std::abs(t));
            if (t > tolerance) beyond = glm::min(beyond, t);
        }
        if (beyond < kFarStart * case_.size) {
            // Where the start itself is not told it may be another crossing, which the oracle tells beside the start;
            // that lies as far off as the solid's hits may be.
            const double off = glm::max(tolerance, (case_.form ? 2.0 * case_.form->bar : 0.0) * case_.size / incidence);
            bool start = false, there = false;
            std::vector<double> places = ends;
            places.insert(std::upper_bound(places.begin(), places.end(), 0.0), 0.0);
            for (const Quad t : truth_of(ray, -off, 2.0 * beyond, 0.0, places)) {
                start = start || t <= glm::min(off, 0.5 * beyond);
                there = there || t >= 0.5 * beyond;
            }
            acne_ += start && there ? 0 : 1;
        }
        if (own < kFarStart * case_.size)
            row_.spawn = glm::max(row_.spawn, own / glm::max(case_.size, glm::length(ray.origin)));
        // A hit's error puts the start beside the surface, which the ray is the longer on its way back to the flatter
        // it leaves.
        const double behind =
            glm::max(2.0 * own, (case_.form ? 2.0 * case_.form->bar : 1e-12) * case_.size / incidence);
        // The oracle's own start is the nearest of its crossings: flatter than a blended normal tells it may be farther
        // off than that.
        const std::vector<Quad> truth = truth_of(ray, -tolerance, 20.0 * case_.size, 0.0, ends);
        const auto size = [](Quad t) { return t < 0 ? -t : t; };
        const auto start =
            std::min_element(truth.begin(), truth.end(), [&](Quad a, Quad b) { return size(a) < size(b); });
        for (auto t = truth.begin(); t != truth.end(); ++t)
            lost_ += t != start && *t > behind && *t < tolerance && !undrawn(*t, ends, faces) ? 1 : 0;
        row_.acne = 1e6 * static_cast<double>(acne_) / static_cast<double>(spawns_);
        row_.lost = 1e6 * static_cast<double>(lost_) / static_cast<double>(spawns_);
    }

    /// No light is lost where nothing is drawn: a height field's sides.
    bool undrawn(Quad t, const std::vector<double>& ends, const std::vector<std::uint32_t>& faces) const
    {
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (faces[i] == csg::kUndrawnFace && std::abs(static_cast<double>(t - ends[i])) < 1e-9 * reach_)
                return true;
        return false;
    }

    void point(const Ray& ray, csg_test::Rng& rng, double low, double high)
    {
        // Anywhere, or near: in or out as like as not.
        const double at = rng.coin() ? rng.uniform(low, high) : case_.distance + rng.uniform(-1.2, 1.2) * case_.size;
        const glm::dvec3 p = ray.at(at);
        const bool held = std::visit([&](const auto& s) { return s.contains(p); }, case_.solid);
        if (case_.form && !case_.form->holds) return;
        const bool is = case_.form ? holds(*case_.form, frame_of(case_.solid), p)
                                   : inside(parts(case_.solid, {p, glm::dvec3(0.0)}), 0);
        if (held != is && !(case_.form && blurred(*case_.form, frame_of(case_.solid), p))) ++row_.disagree;
    }

    void first(const Ray& ray, const std::vector<Quad>& truth, Asked& asked) const
    {
        asked.ray = ray;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const auto t = static_cast<double>(truth[i]);
            if (t < csg::Tolerance{}.hit) continue;
            if (!asked.hit) asked.t = t;
            asked.hit = true;
            if (i + 1 < truth.size() && static_cast<double>(truth[i + 1]) - t < 0.02 * case_.size) asked.clear = false;
        }
    }

    const Case& case_;
    Answers answers_;
    const double band_;
    Row& row_;
    std::vector<double>& errors_;
    const double reach_;
    const csg::Tolerance tolerance_;  ///< of a scene with nothing else in it
    long spawns_ = 0, acne_ = 0, lost_ = 0;
};

double nanoseconds(Answers& answers, const std::vector<Ray>& rays)
{
    constexpr double kLong = 2e7;
    using Clock = std::chrono::steady_clock;
    double best = numbers::kInfinity, spent = 0.0;
    while (spent < kLong) {
        const auto begin = Clock::now();
        const std::uint64_t ends = answers.count(rays);
        const double took = std::chrono::duration<double, std::nano>(Clock::now() - begin).count() +
                            (ends == ~std::uint64_t{0} ? 1.0 : 0.0);
        best = glm::min(best, took);
        spent += took;
    }
    return best / static_cast<double>(rays.size());
}

}  // namespace

bool Row::passes() const
{
    // At every scale no ray may meet its own start, and none what lies nearer than it looks.
    const bool leaves = sweep != "scale" || (acne == 0.0 && lost == 0.0);
    return missed == 0 && wrong == 0 && disagree == 0 && worst < bar_of(solid) && leaves;
}

Row measure(const Sweep& sweep, const std::string& solid, double value, long rays, bool timed,
            std::vector<Asked>* asked)
{
    const Case given = sweep.make(solid, value);
    Row row{.sweep = sweep.name, .solid = solid, .value = value};
    std::vector<double> errors;
    std::vector<Ray> first;
    Judge judge(given, row, errors);
    csg_test::Rng rng(static_cast<std::uint32_t>(std::hash<std::string>{}(sweep.name + solid) +
                                                 static_cast<std::size_t>(std::llround(100.0 * std::log10(value)))));
    for (long i = 0; i < rays; ++i) {
        const glm::dvec3 origin = given.target + rng.direction() * given.distance;
        const glm::dvec3 aim = given.target + rng.point(given.spread);
        const Ray ray{origin, glm::normalize(aim - origin)};
        if (first.size() < 2000) first.push_back(ray);
        judge.ray(ray, rng, asked ? &asked->emplace_back() : nullptr);
    }
    if (timed) {
        Answers answers(given);
        row.ns = nanoseconds(answers, first);
    }
    if (!errors.empty()) {
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
        row.median = errors[errors.size() / 2];
    }
    return row;
}

}  // namespace numerics
