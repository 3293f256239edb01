#include "bench/numerics/forms.h"

#include "bench/numerics/oracle.h"

#include <algorithm>
#include <cmath>

namespace numerics {
namespace {

/// A ray in a form's space: from + (t - start) way.
struct Course {
    WidePoint from, way;
    double start;
};

WidePoint coefficient(const Point& p, std::size_t i)
{
    return {static_cast<Wide>(p.x.c[i]), static_cast<Wide>(p.y.c[i]), static_cast<Wide>(p.z.c[i])};
}

WidePoint at(const Course& c, Wide s)
{
    return {c.from.x + s * c.way.x, c.from.y + s * c.way.y, c.from.z + s * c.way.z};
}

/// Halves until the last bit, or until `fine`.
Wide closed_in(const Form& form, const Course& course, Wide a, Wide b, bool at_b, Wide fine)
{
    for (int i = 0; i < 90 && b - a > fine; ++i) {
        const Wide middle = (a + b) / 2;
        if (middle == a || middle == b) break;
        (held(form, at(course, middle)) == at_b ? b : a) = middle;
    }
    return (a + b) / 2;
}

/// A place of a ray that the definition is asked at.
struct Place {
    Wide s;
    bool told;
};

/// The change between two places. What was told is most likely near to it: steps that grow from there enclose it
/// sooner.
Wide change_between(const Form& form, const Course& course, const Place& from, const Place& to, bool at_to, Wide reach)
{
    if (plain_judge) return closed_in(form, course, from.s, to.s, at_to, 0);
    // Far below the last bit of a double of the ray's length, which is what errors are counted in.
    const Wide fine = std::ldexp(reach, -62);
    Wide a = from.s, b = to.s;
    const bool forwards = from.told;
    for (Wide step = 16 * fine; (from.told || to.told) && step < b - a; step *= 16) {
        const Wide next = forwards ? from.s + step : to.s - step;
        if (!(next > a && next < b)) break;
        const bool is = held(form, at(course, next));
        (is == at_to ? b : a) = next;
        if ((is == at_to) == forwards) break;
    }
    return closed_in(form, course, a, b, at_to, fine);
}

std::vector<Place> looks(const Form& form, const Course& c, double low, double high, const std::vector<double>& told)
{
    std::vector<Place> all;
    all.reserve(static_cast<std::size_t>(form.looks) + 2 * told.size() + 3);
    const Wide from = low - static_cast<Wide>(c.start), to = high - static_cast<Wide>(c.start);
    const Wide a = c.way.x * c.way.x + c.way.y * c.way.y + c.way.z * c.way.z;
    const Wide room = static_cast<Wide>(form.reach) * form.reach -
                      (c.from.x * c.from.x + c.from.y * c.from.y + c.from.z * c.from.z);
    const auto add = [&](Wide s, bool is_told) {
        if (s >= from && s <= to) all.push_back({s, is_told});
    };
    if (room > 0) {
        const Wide half = std::sqrt(room / a);
        for (int i = 0; i <= form.looks; ++i) add(half * (2 * static_cast<Wide>(i) / form.looks - 1), false);
    }
    const auto even = static_cast<std::ptrdiff_t>(all.size());
    const auto before = [](const Place& one, const Place& other) { return one.s < other.s; };
    add(from, false);
    add(to, false);
    for (std::size_t i = 0; i < told.size(); ++i) {
        if (!(told[i] > low && told[i] < high)) continue;
        add(told[i] - static_cast<Wide>(c.start), true);
        if (i + 1 < told.size() && told[i + 1] < high)
            add((static_cast<Wide>(told[i]) + told[i + 1]) / 2 - c.start, false);
    }
    std::sort(all.begin() + even, all.end(), before);
    std::inplace_merge(all.begin(), all.begin() + even, all.end(), before);
    return all;
}

}  // namespace

bool held(const Form& form, const WidePoint& p) { return form.quick && !plain_judge ? form.quick(p) : form.holds(p); }

std::vector<Quad> crossings(const Form& form, const csg::Transform& frame, const csg::Ray& ray, double low, double high,
                            const std::vector<double>& told)
{
    const double start = foot(frame, ray);
    const Point p = local(frame, along(ray, start));
    const Course course{coefficient(p, 0), coefficient(p, 1), start};
    std::vector<Quad> found;
    if (form.meets) {
        for (const Wide s : form.meets(course.from, course.way)) {
            const Quad t = static_cast<Quad>(s) + start;
            if (t >= low && t <= high) found.push_back(t);
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    const std::vector<Place> places = looks(form, course, low, high, told);
    const Wide reach = std::max(std::abs(low), std::abs(high));
    bool was = held(form, at(course, places.front().s));
    for (std::size_t i = 1; i < places.size(); ++i) {
        const bool is = held(form, at(course, places[i].s));
        if (is != was)
            found.push_back(static_cast<Quad>(change_between(form, course, places[i - 1], places[i], is, reach)) +
                            start);
        was = is;
    }
    return found;
}

bool holds(const Form& form, const csg::Transform& frame, const glm::dvec3& p)
{
    return form.holds && held(form, coefficient(local(frame, along({p, glm::dvec3(0.0)}, 0.0)), 0));
}

bool blurred(const Form& form, const csg::Transform& frame, const glm::dvec3& p)
{
    if (!(form.blur > 0.0)) return false;
    const WidePoint q = coefficient(local(frame, along({p, glm::dvec3(0.0)}, 0.0)), 0);
    // A plane nearer than the blur is crossed along one of the axes, which leaves it by 1/sqrt(3) of the way or more.
    const Wide way = 1.75L * form.blur;
    const bool is = held(form, q);
    for (const Wide step : {-way, way})
        if (held(form, {q.x + step, q.y, q.z}) != is || held(form, {q.x, q.y + step, q.z}) != is ||
            held(form, {q.x, q.y, q.z + step}) != is)
            return true;
    return false;
}

glm::dvec3 slope(const Form& form, const csg::Transform& frame, const glm::dvec3& p)
{
    const WidePoint n = form.slope(coefficient(local(frame, along({p, glm::dvec3(0.0)}, 0.0)), 0));
    return glm::normalize(frame.normal(glm::normalize(glm::dvec3(n.x, n.y, n.z))));
}

const std::vector<Form>& forms()
{
    static const std::vector<Form> all = [] {
        std::vector<Form> made = field_forms();
        for (auto* const more : {&sweep_forms, &outline_forms, &surface_forms})
            for (Form& form : more()) made.push_back(std::move(form));
        return made;
    }();
    return all;
}

const Form* form_of(const std::string& name)
{
    for (const Form& form : forms())
        if (form.name == name) return &form;
    return nullptr;
}

}  // namespace numerics
