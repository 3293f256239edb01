#include "bench/numerics/cases.h"

#include <fmt/format.h>

#include <cmath>

namespace numerics {
namespace {

using csg::Transform;

const std::vector<std::string> kQuadrics{"sphere",   "ellipsoid", "box",        "oriented_box",
                                         "cylinder", "cone",      "paraboloid", "hyperboloid"};
const std::vector<std::string> kHigher{"torus", "cubic", "quartic", "degree6", "degree10", "degree20", "degree35"};

std::vector<std::string> with_forms(std::vector<std::string> names)
{
    for (const Form& form : forms()) names.push_back(form.name);
    return names;
}

std::vector<std::string> all()
{
    std::vector<std::string> names = kQuadrics;
    names.insert(names.end(), kHigher.begin(), kHigher.end());
    return with_forms(names);
}

std::size_t place(int degree, int i, int j, int k)
{
    const int a = degree - i, b = a - j;
    return static_cast<std::size_t>(a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + (b - k));
}

/// x^n + y^n + z^n <= 1 with lower terms that make its sections differ; odd degrees are open.
std::vector<double> coefficients(int degree)
{
    std::vector<double> c(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
    c[place(degree, degree, 0, 0)] = c[place(degree, 0, degree, 0)] = c[place(degree, 0, 0, degree)] = 1.0;
    c[place(degree, 1, 1, 1)] += 0.3;
    c[place(degree, 2, 0, 0)] += degree > 2 ? -0.4 : 0.0;
    c[place(degree, 0, 1, 0)] += 0.1;
    c[place(degree, 0, 0, 0)] -= 0.7;
    return c;
}

int degree_of(const std::string& name)
{
    if (name == "cubic") return 3;
    if (name == "quartic") return 4;
    return name.rfind("degree", 0) == 0 ? std::stoi(name.substr(6)) : 0;
}

/// The opening of the solid in the scene language; empty for forms, which are not compared.
std::string sdl_of(const std::string& name)
{
    if (form_of(name) != nullptr) return "";
    if (name == "sphere") return "sphere{0,1";
    if (name == "ellipsoid") return "sphere{0,1 scale <1,.6,1.4>";
    if (name == "box") return "box{<-1,-.7,-.5>,<1,.7,.5>";
    if (name == "oriented_box") return "box{<-1,-.7,-.5>,<1,.7,.5> rotate <30,40,50>";
    if (name == "cylinder") return "cylinder{<-.3,-1,.2>,<.3,1,0>,.6";
    if (name == "cone") return "cone{<-.3,-1,.2>,.8,<.3,1,0>,.2";
    if (name == "paraboloid") return "quadric{<1,0,1>,<0,0,0>,<0,1,0>,-.5";
    if (name == "hyperboloid") return "quadric{<1,-1,1>,<0,0,0>,<0,0,0>,-.3";
    if (name == "torus") return "torus{1,.3";
    const int degree = degree_of(name);
    std::string text = fmt::format("polynomial{{{}", degree);
    const std::vector<double> c = coefficients(degree);
    for (int i = degree; i >= 0; --i)
        for (int j = degree - i; j >= 0; --j)
            for (int k = degree - i - j; k >= 0; --k)
                if (const double v = c[place(degree, i, j, k)]; v != 0.0)
                    text += fmt::format(",xyz({},{},{}):{}", i, j, k, v);
    return text + " sturm";
}

/// The solid of ordinary size about the origin, then `t`.
csg::Solid solid_of(const std::string& name, const Transform& t)
{
    const Transform turn = Transform::rotate_degrees({30, 40, 50});
    if (name == "sphere") {
        const double factor = std::cbrt(glm::determinant(t.linear));
        if (glm::abs(t.linear[0].x - factor) + glm::abs(t.linear[1].y - factor) + glm::abs(t.linear[2].z - factor) <
            1e-12 * factor)
            return csg::Sphere{t.offset, t.linear[0].x};
        return csg::Ellipsoid{t};
    }
    if (name == "ellipsoid") return csg::Ellipsoid{t * Transform::scale({1, 0.6, 1.4})};
    if (name == "box") return csg::Box{t.point({-1, -0.7, -0.5}), t.point({1, 0.7, 0.5})};
    if (name == "oriented_box") return csg::OrientedBox{{-1, -0.7, -0.5}, {1, 0.7, 0.5}, t * turn};
    if (name == "cylinder") return csg::Cylinder::make({-0.3, -1, 0.2}, {0.3, 1, 0}, 0.6, false, t);
    if (name == "cone") {
        csg::Cone cone;
        double radius = 0.0;
        csg::Cone::make({-0.3, -1, 0.2}, 0.8, {0.3, 1, 0}, 0.2, false, t, cone, radius);
        return cone;
    }
    if (name == "paraboloid") return csg::Quadric{{1, 0, 1}, {0, 0, 0}, {0, 1, 0}, -0.5, t};
    if (name == "hyperboloid") return csg::Quadric{{1, -1, 1}, {0, 0, 0}, {0, 0, 0}, -0.3, t};
    if (name == "torus") return csg::Torus{1.0, 0.3, t};
    const int degree = degree_of(name);
    return csg::Polynomial{std::make_shared<csg::PolynomialShape>(degree, coefficients(degree)), t};
}

/// `size`: the longest side of a solid of ordinary size in `t`.
Case case_of(const std::string& name, const Transform& t, double size)
{
    Case made;
    made.form = form_of(name);
    made.solid = made.form ? made.form->make(t, size) : solid_of(name, t);
    made.target = t.offset;
    made.spread = made.size = size;
    made.distance = 6.0 * size;
    if (!made.form) made.sdl = sdl_of(name);
    return made;
}

/// `rest`: what follows the solid's opening words.
Case told(Case made, const std::string& rest)
{
    if (!made.sdl.empty()) made.sdl += rest;
    return made;
}

std::vector<double> decades(int from, int to, int step = 1)
{
    std::vector<double> values;
    for (int k = from; k <= to; k += step) values.push_back(std::pow(10.0, k));
    return values;
}

}  // namespace

std::vector<Sweep> sweeps()
{
    std::vector<Sweep> all_sweeps;
    all_sweeps.push_back({"scale", "scale of the object; the camera 6 sizes away", decades(-9, 9, 3),
                          [](const std::string& name, double s) {
                              return told(case_of(name, Transform::scale(glm::dvec3(s)), s),
                                          fmt::format(" scale {:e}}}", s));
                          },
                          all()});
    all_sweeps.push_back({"offset", "distance of object and camera from the origin", decades(0, 9, 3),
                          [](const std::string& name, double d) {
                              const glm::dvec3 at = d * glm::dvec3(0.6, -0.48, 0.64);
                              return told(case_of(name, Transform::translate(at), 1.0),
                                          fmt::format(" translate <{:.17g},{:.17g},{:.17g}>}}", at.x, at.y, at.z));
                          },
                          all()});
    all_sweeps.push_back({"distance", "distance of the camera", decades(0, 9, 3),
                          [](const std::string& name, double d) {
                              Case made = told(case_of(name, {}, 1.0), "}");
                              made.distance = 6.0 * d;
                              return made;
                          },
                          all()});
    all_sweeps.push_back(
        {"aspect", "length over thickness", decades(0, 8, 2),
         [](const std::string& name, double a) {
             return told(case_of(name, Transform::scale({1.0, 1.0 / a, 1.0}), 1.0),
                         fmt::format(" scale <1,{:e},1>}}", 1.0 / a));
         },
         with_forms({"sphere", "ellipsoid", "box", "oriented_box", "cylinder", "cone", "torus", "quartic"})});
    all_sweeps.push_back(
        {"tube",
         "major over minor radius of a torus",
         decades(0, 6, 2),
         [](const std::string&, double a) {
             const double minor = 0.9 / a;
             return Case{.solid = csg::Torus{1.0, minor, {}}, .sdl = fmt::format("torus{{1,{:.17g}}}", minor)};
         },
         {"torus"}});
    all_sweeps.push_back({"flat",
                          "square coefficient of a quadric that is nearly a plane pair or a parabola",
                          decades(-12, 0, 3),
                          [](const std::string& name, double v) {
                              const bool open = name == "paraboloid";
                              const csg::Quadric made{open ? glm::dvec3(1, v, 1) : glm::dvec3(1, -v, v),
                                                      {0, 0, 0},
                                                      open ? glm::dvec3(0, 1, 0) : glm::dvec3(0),
                                                      -0.3,
                                                      {}};
                              return Case{
                                  .solid = made,
                                  .sdl = open ? fmt::format("quadric{{<1,{:e},1>,<0,0,0>,<0,1,0>,-.3}}", v)
                                              : fmt::format("quadric{{<1,{:e},{:e}>,<0,0,0>,<0,0,0>,-.3}}", -v, v)};
                          },
                          {"paraboloid", "hyperboloid"}});
    return all_sweeps;
}

double band_of(const std::string& solid)
{
    const Form* form = form_of(solid);
    return form ? form->band : 1e-6;
}

double bar_of(const std::string& solid)
{
    if (const Form* form = form_of(solid)) return form->bar;
    if (solid == "torus" || degree_of(solid) == 3 || degree_of(solid) == 4) return 1e-11;
    return degree_of(solid) > 4 ? 1e-8 : 1e-13;
}

}  // namespace numerics
