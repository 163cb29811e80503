#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "calib/work/process_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/frame_files.h"
#include "pipeline/commands/frame_size.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/psnr_text.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/evaluate/held_out_beside.h"
#include "pipeline/evaluate/image_metrics.h"
#include "pipeline/plan/planned_views.h"
#include "render/lumigraph/even_exposure.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/black_picture.h"
#include "render/viewer/recent_packages.h"
#include "render/viewer/screenshot.h"
#include "render/viewer/window.h"

namespace lumi {
namespace {

struct ViewRequest {
    std::filesystem::path package;
    std::string view;
    std::filesystem::path eye;
    std::filesystem::path path;
    std::string mode = "perpixel";
    std::string debug = "none";
    std::string size;
    std::filesystem::path screenshot;
    bool fade = false;
    double frames_per_second = 0.0;
    bool no_fade = false;
    bool black_surroundings = false;
    bool as_taken = false;
    int planned = 0;
};

bool has_photograph(const Lumigraph& lumigraph, const std::string& name) {
    return index_of_name(names_of_views(lumigraph), name).has_value();
}

void add_message(OpenedPackage& opened, const std::string& message) {
    opened.message += (opened.message.empty() ? "" : "; ") + message;
}

/// As `lumi render --difference` tells it: with what the lens took from both.
LikenessWords psnr_words(double light_falloff) {
    return [light_falloff](const Frame& drawn, const HeldOutView& view) {
        const auto darkened = [&](const ColorImage& picture) {
            return darkened_by_lens(picture, view.eye.camera, light_falloff);
        };
        const ColorImage frame = darkened(drawn.color);
        const ColorImage photograph = darkened(view.photograph);
        return psnr_text(psnr_db(frame, photograph), psnr_db(frame, photograph, drawn.coverage),
                         covered_share(drawn.coverage));
    };
}

/// How the window opens packages: as the request says, with what lies beside them. What there is
/// to compare with may be missing: a window without is better than none.
PackageLoader loader_of(const ViewRequest& request) {
    return [request](const std::filesystem::path& package, Exposures exposures) {
        OpenedPackage opened = opened_alone(package, exposures);
        opened.fade_beyond_capture =
            request.fade || (opened.fade_beyond_capture && !request.no_fade);
        try {
            opened.planned = planned_views_beside(package);
        } catch (const Error& error) {
            add_message(opened, "no planned photographs: " + std::string(error.what()));
        }
        const bool is_name_known =
            request.view.empty() || has_photograph(opened.lumigraph, request.view);
        if (!request.screenshot.empty() && is_name_known) return opened;
        try {
            const double falloff = opened.lumigraph.evened_falloff;
            opened.held_out = held_out_views_beside(package, falloff);
            opened.likeness_words = psnr_words(falloff);
        } catch (const Error& error) {
            add_message(opened, "nothing to compare with: " + std::string(error.what()));
        }
        return opened;
    };
}

/// Where the window begins; empty: at a photograph.
std::vector<TimedEye> first_eyes(const ViewRequest& request) {
    if (!request.eye.empty()) return {{0.0, read_eye_file(request.eye).eye}};
    if (!request.path.empty()) return read_path_file(request.path, kUsualEyesPerSecond);
    return {};
}

WindowOptions window_options_of(const ViewRequest& request, const CommandContext& context) {
    WindowOptions options;
    options.view_name = request.view;
    options.render.mode = render_mode_from(request.mode);
    options.render.debug_picture = debug_picture_from(request.debug);
    options.render.guess_surroundings = !request.black_surroundings;
    options.frames_per_second = request.frames_per_second;
    options.planned_index = request.planned - 1;
    options.load = loader_of(request);
    options.eyes = first_eyes(request);
    options.read_eyes = read_eyes_of_window;
    options.exposures = request.as_taken ? Exposures::kAsTaken : Exposures::kEvened;
    options.screenshot_path = request.screenshot;
    if (!request.size.empty()) {
        const FrameSize size = frame_size_from(request.size);
        options.width_px = size.width_px;
        options.height_px = size.height_px;
    }
    if (request.screenshot.empty()) {
        options.package = request.package;
        options.recent_file = recent_packages_file();
        options.progress = context.progress.get();
    }
    return options;
}

/// A plan that is asked for must be whole: of the package that the window begins with.
void check_planned(const ViewRequest& request) {
    if (request.planned == 0) return;
    const std::size_t planned = planned_views_beside(request.package).size();
    if (request.planned <= static_cast<int>(planned)) return;
    throw Error(ErrorKind::kUsage, "E-VIEW-PLAN",
                "photograph " + std::to_string(request.planned) + " of a plan was asked for, of " +
                    std::to_string(planned) + " that are planned",
                "run `lumi plan` on the workspace first");
}

/// One that was held out is no photograph of the package.
void check_view(const ViewRequest& request, const OpenedPackage& opened) {
    if (request.view.empty() || has_photograph(opened.lumigraph, request.view)) return;
    std::vector<std::string> held_out;
    for (const HeldOutView& view : opened.held_out) held_out.push_back(view.name);
    if (!index_of_name(held_out, request.view)) return;  // The window lists names.
    throw Error(ErrorKind::kUsage, "E-VIEW-NAME",
                "'" + printable(request.view) + "' was held out from this package",
                "`lumi render` draws from its place, too; this package has: " +
                    listed_names(names_of_views(opened.lumigraph)));
}

void run_view(const ViewRequest& request, const CommandContext& context) {
    if (!request.screenshot.empty()) {
        check_picture_out(request.screenshot, "--screenshot");
        check_screenshot_out(request.screenshot);
    }
    const WindowOptions options = window_options_of(request, context);
    OpenedPackage opened = options.load(request.package, options.exposures);
    check_planned(request);
    check_view(request, opened);
    if (!opened.message.empty()) context.say(opened.message + "\n");
    if (const std::string why = why_black(opened.lumigraph, options.render); !why.empty())
        context.say(why + "\n");
    keep_free_memory();
    run_window(std::move(opened), options);
    if (request.screenshot.empty()) return;
    if (context.json) {
        context.print_result(nlohmann::ordered_json{{"screenshot", request.screenshot.string()}});
    } else {
        context.print_result(request.screenshot.string() + "\n");
    }
}

}  // namespace

void add_view_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(app, "view", "A window onto a package; H shows its keys",
                                    "lumi view work/fountain/fountain.lumi");
    const auto request = std::make_shared<ViewRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    CLI::Option* view =
        command.add_option("--view", request->view, "Begin where this photograph was taken");
    CLI::Option* eye =
        command
            .add_option("--eye", request->eye,
                        "Begin at an eye in a JSON file, as the window writes it beside a "
                        "screenshot; also by dropping the screenshot on the window")
            ->excludes(view);
    CLI::Option* path = command
                            .add_option("--path", request->path,
                                        "Replay a path that a window recorded (a JSON file); also "
                                        "by dropping it on the window, and again by P")
                            ->excludes(view, eye);
    command.add_option("--mode", request->mode, "As in lumi render")->capture_default_str();
    command.add_option("--debug", request->debug, "As in lumi render")->capture_default_str();
    command.add_option("--size", request->size,
                       "Such as 1280x720 (default: the photograph's, where it holds the panel)");
    CLI::Option* fade = command.add_flag(
        "--fade", request->fade,
        "Fade to black what lies beyond the capture instead of guessing (perpixel, "
        "adaptive, lightfield)");
    command
        .add_flag("--no-fade", request->no_fade,
                  "Do not, though the package was built with [render] fade_beyond_capture")
        ->excludes(fade);
    command.add_flag("--black-surroundings", request->black_surroundings,
                     "Leave black what no photograph shows instead of going on with the colours "
                     "next to it");
    command.add_flag("--as-taken", request->as_taken,
                     "Leave differences in exposure and white balance between photographs, and "
                     "corners that the lens darkens, as they are");
    command
        .add_option("--fps", request->frames_per_second,
                    "While the eye moves, keep so many frames a second by coarser frames and, in "
                    "adaptive, fewer triangles (default: 30, by coarser frames alone)")
        ->check(positive_number());
    command
        .add_option("--planned", request->planned,
                    "Begin where this photograph of `lumi plan` would be taken: 1, 2, ...")
        ->check(CLI::Range(1, 100))
        ->excludes(eye, path);
    command
        .add_option("--screenshot", request->screenshot,
                    "Write one frame to this PNG file, its eye beside it, and end")
        ->excludes(path);
    command.callback([request, &context] {
        context.chosen = [request, &context] {
            request->package = package_meant_by(request->package);
            run_view(*request, context);
        };
    });
}

}  // namespace lumi
