#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/focus.h"
#include "pipeline/commands/frame_drawer.h"
#include "pipeline/commands/frame_files.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/render_request.h"
#include "pipeline/commands/requested_frames.h"
#include "pipeline/commands/rival_drawer.h"
#include "pipeline/commands/video_file.h"
#include "render/lumigraph/package.h"
#include "render/viewer/black_picture.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kEyeFileHelp =
    "From an eye in a JSON file, as the window writes beside a screenshot: "
    R"({"camera": {"model": "PINHOLE", "width_px": 640, "height_px": 480, "parameters": )"
    R"([fx, fy, cx, cy]}, "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": )"
    R"([0, 0, 0]}}, pixels from the top-left corner, +x right, +y down, +z forward; and, )"
    R"(where the command line says nothing else, "mode", "debug_picture", )"
    R"("correct_occlusion", "fade_beyond_capture", "guess_surroundings", "as_taken" (bool))";

/// Of a picture that would tell nothing.
void say_why_black(const RenderRequest& request, const Lumigraph& lumigraph, RenderOptions options,
                   const CommandContext& context) {
    options.focal_plane.depth = request.drawing.focal_depth;
    if (const std::string why = why_black(lumigraph, options); !why.empty())
        context.say(why + "\n");
}

void run_render(const RenderRequest& request, const CommandContext& context) {
    if (!request.path.empty()) {
        check_path_out(request.out);
        if (names_video(request.out)) check_video_programs(request.out, *context.progress);
    }
    if (request.all_views) check_frames_folder(request.out);
    if (request.path.empty() && !request.all_views) check_picture_out(request.out);
    EyeFile at;
    if (!request.eye.empty()) at = read_eye_file(request.eye);
    RenderOptions options = request.rival.empty()
                                ? render_options_of(request.drawing, at.drawn)
                                : rival_options_of(request.rival, request.drawing);
    const Lumigraph lumigraph =
        read_package(request.package, {}, exposures_of(request.drawing, at.drawn));
    keep_free_memory();
    if (request.rival.empty()) {
        options.fade_beyond_capture =
            fade_of(request.drawing, at.drawn).value_or(lumigraph.drawing.fade_beyond_capture);
        check_focus(request.drawing, at.drawn, possible_options(options, lumigraph.has_depth()));
        options.focal_plane = focal_plane_of(request.drawing, request.package, lumigraph);
        say_why_black(request, lumigraph, options, context);
    }
    const FrameDrawer drawer =
        request.rival.empty()
            ? frame_drawer(lumigraph, options, request.drawing.aperture, request.reference)
            : rival_drawer(lumigraph, request.rival, options, *context.progress);

    Json frames = draw_requested(request, at.eye, options, lumigraph, drawer.draw, context);
    if (!context.json) return;
    context.print_result(
        Json{{request.rival.empty() ? "mode" : "rival", method_of(request, options)},
             {"renderer", drawer.renderer},
             {"frames", std::move(frames)}});
}

}  // namespace

void add_render_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "render", "Frames from a package to PNG files or a video, without a window",
        "lumi render work/fountain/fountain.lumi --view 0005.jpg --out frame.png\n"
        "         lumi render work/fountain/fountain.lumi --view 0005.jpg --difference --out "
        "error.png\n"
        "         lumi render work/fountain/fountain.lumi --path views --out tour.mp4");
    const auto request = std::make_shared<RenderRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    CLI::Option_group* where = command.add_option_group("where from", "Exactly one of");
    where->add_option("--view", request->view,
                      "From where this photograph was taken; also one that was held out, where the "
                      "package lies in its workspace");
    CLI::Option* eye = where->add_option("--eye", request->eye, kEyeFileHelp);
    where->add_flag("--all-views", request->all_views,
                    "From every photograph's place; --out names a folder, for PHOTOGRAPH.MODE.png "
                    "of each (what is no ASCII letter, digit or - becomes _), or with "
                    ".difference, .stereo or the debug picture after the mode");
    CLI::Option* path = where->add_option(
        "--path", request->path,
        "Along a path that the window recorded (a JSON file), or on a smooth way through all "
        "photographs' places in their order (the word views); --out names a folder or an .mp4 "
        "file");
    where->require_option(1);
    command
        .add_option("--frames", request->frames,
                    "Of the path `views` (default: two thirds of a second from each photograph to "
                    "the next, four seconds at least)")
        ->check(CLI::Range(2, 100000))
        ->needs(path);
    command
        .add_option("--video-fps", request->video_fps,
                    "Frames a second of a video, and along a recorded path")
        ->check(number_from_to(1.0, 240.0))
        ->capture_default_str()
        ->needs(path);
    CLI::Option* stereo =
        command
            .add_option(
                "--stereo", request->stereo_baseline,
                "A pair side by side, left eye first, this far apart in world units (a thirtieth "
                "of the near depth that `lumi inspect` names is usual). Both eyes see the "
                "middle of the scene's plane at one place: what stands before it comes out "
                "of the screen")
            ->check(positive_number());
    add_drawing_options(command, request->drawing);
    CLI::Option* size = command.add_option(
        "--size", request->size,
        "Such as 1280x720 (default: the photograph's); the whole picture fits into "
        "it, and more where its shape differs");
    command
        .add_flag("--difference", request->difference,
                  "Instead of the picture how far it is from the photograph that was taken there, "
                  "four times as bright, and its PSNR")
        ->excludes(eye, path, stereo, command.get_option("--debug"), size);
    command.add_flag("--reference", request->reference, "By the plain-code renderer; slow")
        ->excludes(command.get_option("--aperture"));
    add_rival_option(command, request->rival);
    command
        .add_option("--out", request->out,
                    "PNG file; folder with --all-views; folder or .mp4 file with --path. Frames "
                    "of an earlier run give way, and nothing else that lies in a folder")
        ->required();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_render(*request, context); };
    });
}

}  // namespace lumi
