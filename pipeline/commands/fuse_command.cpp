#include <CLI/CLI.hpp>

#include <limits>
#include <nlohmann/json.hpp>

#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "meshing/fusion/fused_mesh.h"
#include "meshing/geometry/triangle_mesh_writing.h"
#include "meshing/surface/file_ending.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/text/number_text.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct FuseRequest {
    fs::path package;
    fs::path out;
    SurfacePointOptions options;
};

void run_fuse(const FuseRequest& request, const CommandContext& context) {
    if (lower_case_ending(request.out) != ".ply") {
        throw Error(ErrorKind::kUsage, "E-FUSE-OUT",
                    request.out.string() + ": meshes are written as PLY files",
                    "let --out end in .ply");
    }
    validate(request.options);
    require_writable_file(request.out);
    const Lumigraph lumigraph = read_package(request.package);
    const Stopwatch stopwatch;
    const FusedMesh fused =
        fused_mesh(pictured_views(lumigraph), request.options, context.threads, *context.progress);
    write_triangle_mesh_ply(request.out, fused.mesh);
    const double cpu_s = stopwatch.elapsed().cpu_s;
    const double agreeing_share =
        static_cast<double>(fused.agreeing_pixels) / static_cast<double>(fused.confident_pixels);
    if (context.json) {
        context.print_result(Json{{"mesh", request.out.string()},
                                  {"vertices", fused.mesh.vertices.size()},
                                  {"faces", fused.mesh.faces.size()},
                                  {"agreeing_share", agreeing_share},
                                  {"spacing_px", fused.spacing_px},
                                  {"cpu_s", cpu_s}});
        return;
    }
    context.print_result(request.out.string() + ": " + std::to_string(fused.mesh.vertices.size()) +
                         " vertices, " + std::to_string(fused.mesh.faces.size()) +
                         " triangles, a point every " + number_text(fused.spacing_px, 1) + " px; " +
                         number_text(100.0 * agreeing_share, 1) +
                         " % of the confident pixels agree with other views; " +
                         number_text(cpu_s, 1) + " CPU seconds\n");
}

}  // namespace

void add_fuse_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "fuse", "One mesh of the scene, with colours, from the depth of all views (PLY)",
        "lumi fuse work/demo/demo.lumi --out demo.ply");
    const auto request = std::make_shared<FuseRequest>();
    command.add_option("PACKAGE", request->package, "A package with depth")->required();
    command.add_option("--out,-o", request->out, "The PLY file to write")->required();
    command
        .add_option("--spacing", request->options.spacing_px,
                    "Pixels of the nearest camera that are averaged to one point")
        ->check(number_from_to(1.0, 1000.0))
        ->capture_default_str();
    command
        .add_option("--max-points", request->options.max_points,
                    "Points are spaced wider where there would be more")
        ->check(CLI::Range(1000, std::numeric_limits<int>::max()))
        ->capture_default_str();
    command
        .add_option("--agreeing", request->options.min_agreeing_views,
                    "Other views that must see the same surface")
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_fuse(*request, context); };
    });
}

}  // namespace lumi
