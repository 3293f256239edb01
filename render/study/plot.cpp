#include "render/study/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace study {
namespace {

constexpr std::array kColors{"#0072b2", "#d55e00", "#009e73", "#a5437e", "#56b4e9", "#c49000", "#444444"};
constexpr double kWidth = 860, kHeight = 460, kLeft = 70, kRight = 250, kTop = 16, kBottom = 48;

/// Logarithmic, whole decades at its ends.
struct Scale {
    double from, to;    ///< decades
    double start, end;  ///< pixels
    double operator()(double v) const
    {
        const double at = (std::log10(std::max(v, std::pow(10.0, from))) - from) / (to - from);
        return start + at * (end - start);
    }
};

Scale scale(double low, double high, double start, double end)
{
    constexpr double kSteps = 2.0;  // of a decade: axes end at its halves
    double from = std::floor(kSteps * std::log10(low)) / kSteps, to = std::ceil(kSteps * std::log10(high)) / kSteps;
    if (!(to > from)) to = from + 1.0;
    return {from, to, start, end};
}

std::string ticks(const Scale& x, const Scale& y)
{
    std::string out;
    const auto each = [](const Scale& s, auto&& f) {
        const bool many = s.to - s.from > 6.0;  // decades alone
        for (int decade = static_cast<int>(std::floor(s.from)); decade <= std::ceil(s.to); ++decade)
            for (const int step : {1, 2, 5}) {
                const double value = step * std::pow(10.0, decade), at = std::log10(value);
                if (many && step != 1) continue;
                if (at >= s.from - 1e-9 && at <= s.to + 1e-9) f(value, step == 1);
            }
    };
    each(x, [&](double v, bool whole) {
        out += fmt::format("<line class='{}' x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}'/>",
                           whole ? "decade" : "tick", x(v), x(v), y.end, y.start);
        out += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{:g}</text>", x(v), y.start + 16, v);
    });
    each(y, [&](double v, bool whole) {
        out += fmt::format("<line class='{}' x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}'/>",
                           whole ? "decade" : "tick", x.start, x.end, y(v), y(v));
        out += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{:g}</text>", x.start - 6, y(v) + 4, v);
    });
    return out;
}

/// \param told when pointed at; empty: nothing
std::string mark(const Series& series, double x, double y, const std::string& told)
{
    constexpr double kRadius = 3.6;
    const std::string paint = series.dashed
                                  ? fmt::format("fill='#fff' stroke='{}' stroke-width='1.4'", series.look.color)
                                  : fmt::format("fill='{}'", series.look.color);
    const std::string title = told.empty() ? std::string() : "<title>" + escaped(told) + "</title>";
    const auto polygon = [&](std::initializer_list<std::array<double, 2>> corners) {
        std::string points;
        for (const auto& [u, v] : corners) points += fmt::format("{:.1f},{:.1f} ", x + u * kRadius, y + v * kRadius);
        return fmt::format("<polygon points='{}' {}>{}</polygon>", points, paint, title);
    };
    switch (series.look.mark) {
    case Mark::Square: return polygon({{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}});
    case Mark::Triangle: return polygon({{0, -1.2}, {1.1, .9}, {-1.1, .9}});
    case Mark::Diamond: return polygon({{0, -1.3}, {1.1, 0}, {0, 1.3}, {-1.1, 0}});
    default: return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{}' {}>{}</circle>", x, y, kRadius, paint, title);
    }
}

std::string drawn(const Series& series, const Scale& x, const Scale& y, const std::string& unit)
{
    std::vector<Series::Point> sorted = series.points;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Series::Point& a, const Series::Point& b) { return a.x < b.x; });
    std::string out;
    std::vector<Series::Point> front;  // what is nearer than all that is faster
    for (const Series::Point& p : sorted)
        if (front.empty() || p.y < front.back().y) front.push_back(p);
    if (series.line && front.size() > 1) {
        out += fmt::format("<polyline fill='none' stroke='{}' stroke-width='1.6'{} points='", series.look.color,
                           series.dashed ? " stroke-dasharray='5 4'" : "");
        for (const Series::Point& p : front) out += fmt::format("{:.1f},{:.1f} ", x(p.x), y(p.y));
        out += "'/>";
    }
    for (const Series::Point& p : sorted)
        out += mark(series, x(p.x), y(p.y), fmt::format("{}: {:.3g} {}, {:.3g}", p.name, p.x, unit, p.y));
    return out;
}

}  // namespace

Look look(std::size_t color, Mark mark) { return {kColors[color % kColors.size()], mark}; }

Look look(std::size_t i)
{
    return look(i, static_cast<Mark>(i / kColors.size() % static_cast<std::size_t>(Mark::Count)));
}

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '&') out += "&amp;";
        else if (c == '"') out += "&quot;";
        else if (c == '\'') out += "&#39;";
        else out += c;
    }
    return out;
}

std::string plot(const std::vector<Series>& series, const Axes& axes)
{
    double low_x = std::numeric_limits<double>::infinity(), high_x = 0.0, low_y = low_x, high_y = 0.0;
    for (const Series& one : series)
        for (const Series::Point& p : one.points) {
            low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
            if (p.y > 0.0) low_y = std::min(low_y, p.y);
            high_y = std::max(high_y, p.y);
        }
    if (!(high_x > 0.0)) return "<p>No points.</p>";
    if (!(high_y > 0.0)) low_y = 0.1, high_y = 1.0;
    if (axes.floor > 0.0) low_y = std::min(low_y, axes.floor);
    const Scale x = scale(low_x, high_x, kLeft, kWidth - kRight), y = scale(low_y, high_y, kHeight - kBottom, kTop);
    std::string out = fmt::format("<svg viewBox='0 0 {:g} {:g}' width='{:g}' height='{:g}' role='img'>", kWidth,
                                  kHeight, kWidth, kHeight);
    if (axes.floor > 0.0)
        out += fmt::format(
            "<rect class='floor' x='{:.1f}' width='{:.1f}' y='{:.1f}' height='{:.1f}'><title>the truth itself "
            "is not surer than this: {:.3g}</title></rect>",
            x.start, x.end - x.start, y(axes.floor), y.start - y(axes.floor), axes.floor);
    out += ticks(x, y);
    if (axes.wanted > 0.0 && std::log10(axes.wanted) > y.from && std::log10(axes.wanted) < y.to)
        out += fmt::format("<line class='wanted' x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}'/>", x.start, x.end,
                           y(axes.wanted), y(axes.wanted));
    for (const Series& one : series) out += drawn(one, x, y, axes.unit);
    double at = kTop + 8;
    for (const Series& one : series) {
        out +=
            fmt::format("<line x1='{0:.1f}' x2='{1:.1f}' y1='{2:.1f}' y2='{2:.1f}' stroke='{3}' stroke-width='2'{4}/>",
                        x.end + 14, x.end + 32, at, one.look.color, one.dashed ? " stroke-dasharray='5 4'" : "");
        out += mark(one, x.end + 23, at, {});
        out += fmt::format("<text x='{:.1f}' y='{:.1f}'>{}</text>", x.end + 38, at + 4, escaped(one.name));
        at += 18;
    }
    out += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>", 0.5 * (x.start + x.end),
                       kHeight - 10, escaped(axes.x));
    out += fmt::format("<text transform='translate(16 {:.1f}) rotate(-90)' text-anchor='middle'>{}</text>",
                       0.5 * (y.start + y.end), escaped(axes.y));
    return out + "</svg>\n";
}

}  // namespace study
