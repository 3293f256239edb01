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

/// Halves until the last bit.
Wide closed_in(const Form& form, const Course& course, Wide a, Wide b, bool at_b)
{
    for (int i = 0; i < 90; ++i) {
        const Wide middle = (a + b) / 2;
        if (middle == a || middle == b) break;
        (form.holds(at(course, middle)) == at_b ? b : a) = middle;
    }
    return (a + b) / 2;
}

std::vector<Wide> looks(const Form& form, const Course& c, double low, double high, const std::vector<double>& told)
{
    std::vector<Wide> all{low - static_cast<Wide>(c.start), high - static_cast<Wide>(c.start)};
    const Wide a = c.way.x * c.way.x + c.way.y * c.way.y + c.way.z * c.way.z;
    const Wide room = static_cast<Wide>(form.reach) * form.reach - (c.from.x * c.from.x + c.from.y * c.from.y + c.from.z * c.from.z);
    if (room > 0) {
        const Wide half = std::sqrt(room / a);
        for (int i = 0; i <= form.looks; ++i) all.push_back(half * (2 * static_cast<Wide>(i) / form.looks - 1));
    }
    for (std::size_t i = 0; i < told.size(); ++i) {
        if (!(told[i] > low && told[i] < high)) continue;
        all.push_back(told[i] - static_cast<Wide>(c.start));
        if (i + 1 < told.size() && told[i + 1] < high) all.push_back((static_cast<Wide>(told[i]) + told[i + 1]) / 2 - c.start);
    }
    std::erase_if(all, [&, from = all[0], to = all[1]](Wide s) { return s < from || s > to; });
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

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
        if (form.first_only && found.size() > 1) found.erase(found.begin() + 1, found.end());
        return found;
    }
    const std::vector<Wide> places = looks(form, course, low, high, told);
    bool was = form.holds(at(course, places.front()));
    for (std::size_t i = 1; i < places.size(); ++i) {
        const bool is = form.holds(at(course, places[i]));
        if (is != was) found.push_back(static_cast<Quad>(closed_in(form, course, places[i - 1], places[i], is)) + start);
        was = is;
    }
    return found;
}

bool holds(const Form& form, const csg::Transform& frame, const glm::dvec3& p)
{
    return form.holds && form.holds(coefficient(local(frame, along({p, glm::dvec3(0.0)}, 0.0)), 0));
}

const std::vector<Form>& forms()
{
    static const std::vector<Form> all = [] {
        std::vector<Form> made = field_forms();
        for (auto* const more : {&outline_forms, &surface_forms})
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
