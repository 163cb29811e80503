#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/capture/image_io.h"
#include "calib/work/error.h"
#include "calib/work/stopwatch.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/frame_size.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/stages/file_stems.h"
#include "render/lumigraph/package.h"
#include "render/modes/offscreen_renderer.h"
#include "render/reference/reference_renderer.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct RenderRequest {
    fs::path package;
    std::string view;
    fs::path eye;
    bool all_views = false;
    std::string mode = "perpixel";
    std::string debug = "none";
    std::string size;
    bool supersample = false;
    double focal_depth = 0.0;
    bool reference = false;
    fs::path out;
};

/// A frame to draw and the file it goes to.
struct Job {
    Eye eye;
    fs::path out;
};

Eye eye_of(const LumigraphView& view) { return {view.camera, view.cam_from_world}; }

const LumigraphView& view_named(const Lumigraph& lumigraph, const std::string& name) {
    const auto view =
        std::find_if(lumigraph.views.begin(), lumigraph.views.end(),
                     [&](const LumigraphView& candidate) { return candidate.name == name; });
    if (view == lumigraph.views.end()) {
        throw Error(ErrorKind::kUsage, "E-RENDER-VIEW", "the package has no view named " + name,
                    "`lumi inspect PACKAGE` lists the views");
    }
    return *view;
}

std::vector<Job> jobs_of(const RenderRequest& request, const Lumigraph& lumigraph) {
    if (!request.eye.empty()) return {{read_eye_file(request.eye), request.out}};
    if (!request.all_views) return {{eye_of(view_named(lumigraph, request.view)), request.out}};
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    const std::vector<std::string> stems = file_stems_of_views(names);
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < names.size(); ++i) {
        jobs.push_back({eye_of(lumigraph.views[i]), request.out / (stems[i] + ".png")});
    }
    return jobs;
}

Camera camera_of_size(const Camera& camera, const std::string& size) {
    if (size.empty()) return camera;
    const FrameSize frame_size = frame_size_from(size);
    return resized(camera, frame_size.width_px, frame_size.height_px);
}

using Draw = std::function<Frame(const Eye&)>;

Json draw_to_file(const Job& job, const std::string& size, const Draw& draw) {
    const Eye eye{camera_of_size(job.eye.camera, size), job.eye.cam_from_world};
    const Stopwatch stopwatch;
    const Frame frame = draw(eye);
    const double ms = 1000.0 * stopwatch.elapsed().wall_s;
    write_png(job.out, frame.color);
    return Json{{"file", job.out.string()}, {"ms", ms}};
}

void run_render(const RenderRequest& request, const CommandContext& context) {
    const RenderOptions options{.mode = render_mode_from(request.mode),
                                .debug_picture = debug_picture_from(request.debug),
                                .focal_depth = request.focal_depth,
                                .supersample = request.supersample};
    const Lumigraph lumigraph = read_package(request.package);
    const std::vector<Job> jobs = jobs_of(request, lumigraph);
    std::unique_ptr<OffscreenRenderer> renderer;
    if (!request.reference) renderer = std::make_unique<OffscreenRenderer>(lumigraph);
    const Draw draw = [&](const Eye& eye) {
        return renderer ? renderer->draw(eye, options) : draw_reference(lumigraph, eye, options);
    };

    Json frames = Json::array();
    context.progress->begin("drawing", jobs.size());
    for (const Job& job : jobs) {
        context.progress->throw_if_interrupted();
        frames.push_back(draw_to_file(job, request.size, draw));
        context.progress->advance();
        if (!context.json) context.print_result(job.out.string() + "\n");
    }
    if (!context.json) return;
    context.print_result(Json{{"mode", request.mode},
                              {"renderer", renderer ? renderer->gl_description() : "reference"},
                              {"frames", std::move(frames)}});
}

}  // namespace

void add_render_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "render", "Frames from a package to PNG files, without a window",
                    "lumi render work/fountain/fountain.lumi --view 0005.jpg --out frame.png");
    const auto request = std::make_shared<RenderRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    CLI::Option_group* where = command.add_option_group("where from", "Exactly one of");
    where->add_option("--view", request->view, "From where this photograph was taken");
    where->add_option("--eye", request->eye, "From an eye described in a JSON file");
    where->add_flag("--all-views", request->all_views,
                    "From every photograph's place; --out names a folder");
    where->require_option(1);
    command.add_option("--mode", request->mode, render_mode_names())->capture_default_str();
    command.add_option("--debug", request->debug, debug_picture_names())->capture_default_str();
    command.add_option("--size", request->size, "Such as 1280x720 (default: the photograph's)");
    command
        .add_option("--focal-depth", request->focal_depth,
                    "For modes without depth: distance of the plane that is sharp, world units")
        ->check(CLI::PositiveNumber);
    command.add_flag("--supersample", request->supersample,
                     "Four samples a pixel: smooth edges, about four times the work");
    command.add_flag("--reference", request->reference, "By the plain-code renderer; slow");
    command.add_option("--out", request->out, "PNG file, or folder with --all-views")->required();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_render(*request, context); };
    });
}

}  // namespace lumi
