#include "render/app/solid/mesh_command.h"

#include "render/app/run/stage_options.h"
#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/positive.h"
#include "render/app/output/whole_text.h"
#include "render/app/solid/bodies.h"
#include "render/app/solid/body_shapes.h"
#include "render/app/solid/part_file.h"
#include "render/image/codecs/module_path.h"
#include "render/image/picture_writer.h"
#include "render/solid/files/glb.h"
#include "render/solid/files/three_mf.h"
#include "render/solid/files/write.h"
#include "render/solid/measure/measure.h"
#include "render/solid/mesh/check.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cmath>

namespace app {
namespace {

constexpr const char* kMeshUsage = R"(usage: whittle mesh SCENE -o FILE.stl|.3mf|.obj|.ply|.glb [options]

Each object of a scene as triangles: closed, meeting edge to edge, crossing nowhere. What has no inside or no end (planes) is left out.
How far mesh and object are apart is measured by rays and printed; a mesh that does not close is not written.

  -o FILE              the mesh; 3MF has an object and a colour for each of the scene's
  --tolerance=T        scene units (a unit is a millimetre) that it may be off by; usual: 0.01
  --object=NAME        the object that was declared by this name, wherever it stands in the scene
  --seconds=S          after which an object is not refined any more; usual: 60. It may then be farther off, and that is told
  --cells=N            of the first lattice along the longest side, 4 to 128; usual: 16. Narrower parts may be overlooked

Declare=, +L, Clock= and INI files are as for a render. Exit status: 0 done, 1 nothing could be written or a mesh is farther off than
it may be, 2 cancelled.
)";

constexpr double kUsualSeconds = 60.0;

struct MeshRequest {
    BodyRequest bodies;
    std::string out;
    double tolerance = 0.01;
    int cells = 16;
    double seconds = kUsualSeconds;
};

MeshRequest mesh_request(const std::vector<std::string>& arguments)
{
    MeshRequest request;
    read_default_ini_file(request.bodies.settings);
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string value;
        if (take_value(arguments, i, {"--object"}, value)) request.bodies.object = value;
        else if (take_value(arguments, i, {"-o", "--out"}, value)) request.out = value;
        else if (take_value(arguments, i, {"--tolerance"}, value))
            request.tolerance = whole_positive("--tolerance", value);
        else if (take_value(arguments, i, {"--seconds"}, value)) request.seconds = whole_positive("--seconds", value);
        else if (take_value(arguments, i, {"--cells"}, value)) {
            const double cells = whole_positive("--cells", value, kMostCells);
            if (cells < 4.0 || cells != std::floor(cells))
                throw OptionError(
                    fmt::format("--cells wants a whole number from 4 to {}, found '{}'", kMostCells, value));
            request.cells = static_cast<int>(cells);
        } else others.push_back(arguments[i]);
    }
    apply_command_line(request.bodies.settings, others);
    if (request.bodies.settings.input_file.empty())
        throw OptionError("no scene given: whittle mesh scene.pov -o part.stl, or whittle mesh --help");
    if (request.out.empty())
        throw OptionError("where to? whittle mesh scene.pov -o part.stl (or .3mf, .obj, .ply, .glb)");
    solid::format_of(request.out);
    return request;
}

class MeshRun {
public:
    MeshRun(const MeshRequest& request, Cancellation& cancel) : request_(request), cancel_(cancel) {}

    int run()
    {
        check_place(request_.out);
        const BodyScene scene = read_bodies(request_.bodies, cancel_);
        for (const NamedObject& named : scene.objects) add(named, scene.description);
        if (parts_.empty()) {
            fmt::print(stderr, "whittle: error: no object to write{}\n",
                       scene.objects.empty() ? ": the scene has none" : "");
            return kError;
        }
        switch (solid::format_of(request_.out)) {
        case solid::MeshFormat::Stl: put_bytes(request_.out, solid::stl_bytes(parts_)); break;
        case solid::MeshFormat::Obj: put_bytes(request_.out, solid::obj_text(parts_)); break;
        case solid::MeshFormat::Ply: put_bytes(request_.out, solid::ply_bytes(parts_)); break;
        case solid::MeshFormat::ThreeMf: put_three_mf(); break;
        case solid::MeshFormat::Glb: put_bytes(request_.out, solid::glb_bytes(parts_)); break;
        }
        fmt::print("{}  {} object{}\n", request_.out, parts_.size(), parts_.size() == 1 ? "" : "s");
        return status_;
    }

private:
    void put_three_mf() const
    {
        const auto module = image::find_module(solid::kThreeMfModule);
        if (!module) throw std::runtime_error(image::missing_module(solid::kThreeMfModule));
        image::Replacement file(request_.out);
        solid::write_three_mf(module->string(), file.temporary(), parts_);
        file.put_in_place();
    }

    void add(const NamedObject& named, const scene::Description& description)
    {
        try {
            const solid::Body body(*named.object, description.global);
            solid::FilePart part;
            part.name = named.name;
            color_of(*named.object, part.color);
            if (!make(body, part)) return;
            part.colors = colors_at(*named.object, description, part.mesh.vertices);
            parts_.push_back(std::move(part));
        } catch (const solid::NoBody& why) {
            fmt::print(stderr, "{}: left out: {}\n", named.name, why.what());
        }
    }

    bool make(const solid::Body& body, solid::FilePart& part)
    {
        const auto start = PartClock::now();
        double extent_error = 0.0;
        std::uint64_t rays = 0;
        const csg::Aabb extent = solid::require_extent(body, extent_error, rays);
        BodyMesh made = mesh_within(
            body, extent, refine_options(request_.tolerance, request_.cells, start, request_.seconds, cancel_));
        part.mesh = std::move(made.mesh);
        const solid::MeshCheck found = solid::check(part.mesh);
        solid::MeasureOptions measuring;
        measuring.precision = 1e-3;
        measuring.most_rays = 4'000'000;
        measuring.cancel = &cancel_.requested;
        const solid::Measures measures = solid::measure_within(body, extent, extent_error, measuring);
        const double seconds = std::chrono::duration<double>(PartClock::now() - start).count();
        report(part, made, found, measures, seconds);
        if (!found.good()) {
            fmt::print(stderr, "{}: not written: {}\n", part.name, found.complaint());
            status_ = kError;
            return false;
        }
        const double room = measures.volume.error + request_.tolerance * found.surface;
        if (std::abs(found.volume - measures.volume.value) > room) {
            fmt::print(stderr, "{}: not written: its volume is {:.9g}, by rays {:.9g} +- {:.2g}\n", part.name,
                       found.volume, measures.volume.value, measures.volume.error);
            status_ = kError;
            return false;
        }
        if (made.worst() > request_.tolerance) {
            tell_too_far(part.name, "it", made.worst(), request_.tolerance, made.facts);
            status_ = kError;
        }
        return true;
    }

    static void report(const solid::FilePart& part, const BodyMesh& made, const solid::MeshCheck& found,
                       const solid::Measures& measures, double seconds)
    {
        const solid::MeshFacts& facts = made.facts;
        const solid::Deviation& off = made.off;
        fmt::print("{}\n", part.name);
        fmt::print("  triangles  {}, vertices {}, parts {}; lattice {}, {} rounds, {} tetrahedra, {:.2f} s\n",
                   part.mesh.triangles.size(), part.mesh.vertices.size(), found.parts, made.cells, facts.rounds,
                   facts.parts, seconds);
        fmt::print("  made       {}\n",
                   facts.remeshed ? "anew on the surface, from few tetrahedra"
                                  : "of tetrahedra alone: made anew it would be slow, or it crossed itself or was off");
        fmt::print("  check      {}\n", found.good()
                                            ? "closed, two triangles on each edge, one ring about each vertex, "
                                              "all outward"
                                            : found.complaint());
        fmt::print("  volume     {:.9g}, by rays {:.9g} +- {:.2g}\n", found.volume, measures.volume.value,
                   measures.volume.error);
        fmt::print("  surface    {:.9g}, by rays {:.9g} +- {:.2g}\n", found.surface, measures.surface.value,
                   measures.surface.error);
        fmt::print("  deviation  of the mesh {:.3g} (rms {:.2g}), of the object {:.3g} (rms {:.2g}), {} places\n",
                   off.from_mesh, off.from_mesh_rms, off.from_body, off.from_body_rms, off.samples);
        if (facts.lost > 0 || facts.unresolved > 0)
            fmt::print("  numerics   {} edges without a crossing, {} places too small to refine\n", facts.lost,
                       facts.unresolved);
    }

    const MeshRequest& request_;
    Cancellation& cancel_;
    std::vector<solid::FilePart> parts_;
    int status_ = kSuccess;
};

}  // namespace

std::string mesh_help() { return kMeshUsage; }

int mesh_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    const MeshRequest request = mesh_request(arguments);
    cancel.heeded = true;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads_of(request.bodies.settings)));
    try {
        return MeshRun(request, cancel).run();
    } catch (...) {
        return tell_thrown();
    }
}

}  // namespace app
