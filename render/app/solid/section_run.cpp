#include "render/app/solid/section_run.h"

#include "render/app/output/whole_text.h"
#include "render/app/report/json_writer.h"
#include "render/app/solid/body_shapes.h"
#include "render/app/solid/part_file.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>

namespace app {
namespace {

constexpr double kExact = 1e-3;  // of the tolerance: numbers in files
constexpr const char* kAxes = "xyz";

class SectionRun {
public:
    SectionRun(const BodyRequest& bodies, const SectionRequest& request, Cancellation& cancel)
        : bodies_(bodies), request_(request), cancel_(cancel)
    {}

    int run()
    {
        for (const std::string& out : request_.out) check_place(out);
        const BodyScene scene = read_bodies(bodies_, cancel_);
        for (const NamedObject& named : scene.objects) add(named, scene.description);
        if (parts_.empty()) {
            fmt::print(stderr, "whittle: error: the plane {} cuts nothing{}; no file was written\n", plane_text(),
                       scene.objects.empty() ? ": the scene has no objects" : "");
            return kError;
        }
        const double exact = kExact * request_.tolerance;
        for (const std::string& out : request_.out) {
            if (solid::drawing_format_of(out) == solid::DrawingFormat::Dxf)
                put_bytes(out, solid::dxf_text(parts_, exact));
            else
                put_bytes(out, solid::svg_text(parts_, fmt::format("{}, {}", bodies_.settings.input_file, plane_text()),
                                               exact));
            if (!request_.json) fmt::print("{}  {} object{}\n", out, parts_.size(), parts_.size() == 1 ? "" : "s");
        }
        return status_;
    }

private:
    std::string plane_text() const
    {
        return fmt::format("{} = {:g}", kAxes[request_.plane.axis], request_.plane.value);
    }

    void add(const NamedObject& named, const scene::Description& description)
    {
        try {
            const solid::Body body(*named.object, description.global);
            solid::DrawnPart part;
            part.name = named.name;
            color_of(*named.object, part.color);
            if (cut(body, part)) parts_.push_back(std::move(part));
        } catch (const solid::NoBody& why) {
            fmt::print(stderr, "{}: left out: {}\n", named.name, why.what());
        }
    }

    bool cut(const solid::Body& body, solid::DrawnPart& part)
    {
        const auto start = PartClock::now();
        double extent_error = 0.0;
        std::uint64_t rays = 0;
        const csg::Aabb extent = solid::require_extent(body, extent_error, rays);
        const int axis = request_.plane.axis;
        const double value = request_.plane.value, low = extent.lower[axis], high = extent.upper[axis];
        if (value < low - extent_error || value > high + extent_error) {
            fmt::print(stderr, "{}: not cut: it reaches from {} = {:.6g} to {:.6g}\n", part.name, kAxes[axis], low,
                       high);
            return false;
        }
        const solid::CuttingPlane plane = solid::beside_faces(body, extent, request_.plane);
        if (plane.value != value)
            fmt::print(stderr, "{}: note: a face of it lies in {}; drawn is the cut {:.2g} {} it\n", part.name,
                       plane_text(), std::abs(plane.value - value), plane.value > value ? "above" : "below");
        BodySection cut =
            section_within(body, extent, plane,
                           refine_options(request_.tolerance, solid::kContourCells, start, request_.seconds, cancel_));
        part.loops = std::move(cut.loops);
        if (part.loops.empty()) {
            fmt::print(stderr, "{}: not cut: nothing of it lies in {}\n", part.name, plane_text());
            return false;
        }
        const double seconds = std::chrono::duration<double>(PartClock::now() - start).count();
        report(part, cut, seconds);
        return judge(part, cut);
    }

    void report(const solid::DrawnPart& part, const BodySection& cut, double seconds) const
    {
        const solid::RefineFacts& facts = cut.facts;
        const solid::SectionCheck& off = cut.off;
        std::size_t points = 0;
        for (const solid::Loop& loop : part.loops) points += loop.size();
        const double area = solid::area_of(part.loops), length = solid::length_of(part.loops);
        if (request_.json) {
            fmt::print("{{\"object\":{},\"axis\":\"{}\",\"value\":{:.12g},\"area\":{:.12g},\"area_by_rays\":{:.12g},"
                       "\"area_error\":{:.3g},\"length\":{:.12g},\"loops\":{},\"points\":{},\"from_loops\":{:.3g},"
                       "\"from_body\":{:.3g}}}\n",
                       json_quoted(part.name), kAxes[request_.plane.axis], request_.plane.value, area, off.area.value,
                       off.area.error, length, part.loops.size(), points, off.from_loops, off.from_body);
            return;
        }
        fmt::print("{}\n", part.name);
        fmt::print("  loops      {}, points {}; lattice {}, {} rounds, {} triangles of the plane, {:.2f} s\n",
                   part.loops.size(), points, cut.cells, facts.rounds, facts.parts, seconds);
        fmt::print("  area       {:.9g}, by rays {:.9g} +- {:.2g}\n", area, off.area.value, off.area.error);
        fmt::print("  length     {:.9g}\n", length);
        fmt::print("  deviation  of the drawing {:.3g}, of the object {:.3g}, {} places\n", off.from_loops,
                   off.from_body, off.samples);
        if (facts.lost > 0 || facts.unresolved > 0)
            fmt::print("  numerics   {} edges without a crossing, {} places too small to refine\n", facts.lost,
                       facts.unresolved);
    }

    /// Whether the drawing is the body's cut: what is only farther off than it may be is told, and drawn.
    bool judge(const solid::DrawnPart& part, const BodySection& cut)
    {
        const solid::SectionCheck& off = cut.off;
        if (cut.worst() > request_.tolerance) {
            tell_too_far(part.name, "the cut", cut.worst(), request_.tolerance, cut.facts);
            status_ = kError;
            return true;
        }
        const double area = solid::area_of(part.loops);
        const double room = off.area.error + request_.tolerance * solid::length_of(part.loops);
        if (std::abs(area - off.area.value) <= room) return true;
        fmt::print(stderr, "{}: not drawn: its area is {:.9g}, by rays {:.9g} +- {:.2g}\n", part.name, area,
                   off.area.value, off.area.error);
        status_ = kError;
        return false;
    }

    const BodyRequest& bodies_;
    const SectionRequest& request_;
    Cancellation& cancel_;
    std::vector<solid::DrawnPart> parts_;
    int status_ = kSuccess;
};

}  // namespace

solid::CuttingPlane cutting_plane(const std::string& text)
{
    solid::CuttingPlane plane;
    const std::size_t axis = text.empty() ? std::string::npos : std::string_view(kAxes).find(text[0]);
    const char* const end = text.data() + text.size();
    if (axis != std::string::npos && text.size() > 2 && text[1] == ',') {
        plane.axis = static_cast<int>(axis);
        const char* first = text.data() + 2;
        if (*first == '+') ++first;
        const auto [rest, error] = std::from_chars(first, end, plane.value);
        if (error == std::errc() && rest == end && std::isfinite(plane.value)) return plane;
    }
    throw OptionError(fmt::format("--section wants x, y or z and a number, as in y,0.5; found '{}'", text));
}

int draw_section(const BodyRequest& bodies, const SectionRequest& request, Cancellation& cancel)
{
    return SectionRun(bodies, request, cancel).run();
}

}  // namespace app
