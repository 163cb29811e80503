#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/drawing_request.h"
#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/eye_path.h"
#include "pipeline/commands/focus.h"
#include "pipeline/commands/frame_drawer.h"
#include "pipeline/commands/frame_files.h"
#include "pipeline/commands/known_photographs.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/psnr_text.h"
#include "pipeline/commands/stereo_pair.h"
#include "pipeline/commands/video_file.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"
#include "render/lumigraph/package.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/black_picture.h"
#include "render/viewer/difference_picture.h"

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

struct RenderRequest {
    fs::path package;
    std::string view;
    fs::path eye;
    std::string path;
    int frames = 120;
    double video_fps = 30.0;
    double stereo_baseline = 0.0;
    bool all_views = false;
    bool difference = false;
    std::string size;
    DrawingRequest drawing;
    bool reference = false;
    fs::path out;
};

/// A frame to draw, the file it goes to, and what was photographed there.
struct Job {
    Eye eye;
    fs::path out;
    ColorImage photograph{};
    bool is_drawn_from_it = false;  ///< The photograph is in the package.
    double falloff = 0.0;           ///< Of the lens, in the photograph and not in the frame.
};

Job job_at(const LumigraphView& view, const fs::path& out) {
    return {eye_at(view), out, turned_upright(view.photograph, view.exif_orientation), true};
}

/// A photograph of the package, or one that was held out from it.
Job job_at_view(const RenderRequest& request, const Lumigraph& lumigraph) {
    KnownPhotograph at = photograph_named(request.view, request.package, lumigraph);
    return {at.eye, request.out, std::move(at.photograph), at.is_of_package,
            at.is_of_package ? 0.0 : lumigraph.evened_falloff};
}

/// What the files of frames are named after, so that those of one kind replace no others.
std::string kind_of_frames(const RenderRequest& request, const RenderOptions& options) {
    std::string kind = name_of(options.mode);
    if (options.debug_picture != DebugPicture::kNone) kind += '.' + name_of(options.debug_picture);
    if (request.difference) kind += ".difference";
    if (request.stereo_baseline > 0.0) kind += ".stereo";
    return kind;
}

bool is_any_there(const std::vector<fs::path>& files) {
    return std::any_of(files.begin(), files.end(), [](const fs::path& file) {
        std::error_code status;
        return fs::exists(file, status);
    });
}

std::vector<Job> jobs_of(const RenderRequest& request, const Eye& eye, const RenderOptions& options,
                         const Lumigraph& lumigraph) {
    if (!request.eye.empty()) return {{eye, request.out}};
    if (!request.all_views) return {job_at_view(request, lumigraph)};
    const KnownPhotographs known = known_photographs(request.package, lumigraph);
    const std::vector<fs::path> frames = frames_of_views(
        request.out, names_of_views(lumigraph), kind_of_frames(request, options), known.names);
    // Then nothing tells that what stands there is no photograph that was held out.
    if (known.failure && is_any_there(frames)) throw Error(*known.failure);
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < frames.size(); ++i)
        jobs.push_back(job_at(lumigraph.views[i], frames[i]));
    return jobs;
}

/// Draws how far the frame is from the photograph.
Json draw_difference(const Job& job, const Draw& draw) {
    const Stopwatch stopwatch;
    Frame frame = draw(job.eye);
    frame.color = darkened_by_lens(std::move(frame.color), job.eye.camera, job.falloff);
    const double ms = 1000.0 * stopwatch.elapsed().wall_s;
    write_png(job.out, difference_picture(frame.color, job.photograph));
    Json result{{"file", job.out.string()},
                {"ms", ms},
                {"psnr_db", psnr_db(frame.color, job.photograph)},
                {"psnr_covered_db", nullptr},
                {"is_held_out", !job.is_drawn_from_it},
                {"coverage", covered_share(frame.coverage)}};
    if (const auto covered = psnr_db(frame.color, job.photograph, frame.coverage))
        result["psnr_covered_db"] = *covered;
    return result;
}

/// What is said of a frame that was written.
std::string frame_text(const Json& frame) {
    std::string text = frame.at("file").get<std::string>();
    if (frame.contains("psnr_db")) {
        std::optional<double> covered_db;
        if (const Json& covered = frame.at("psnr_covered_db"); !covered.is_null())
            covered_db = covered.get<double>();
        text += "  " + psnr_text(frame.at("psnr_db").get<double>(), covered_db,
                                 frame.at("coverage").get<double>());
        if (!frame.at("is_held_out").get<bool>())
            text += "; it is drawn from this photograph: hold it out to measure";
    }
    return text + "\n";
}

Json draw_to_file(const Job& job, const RenderRequest& request, const Lumigraph& lumigraph,
                  const Draw& draw) {
    const Eye eye = eye_of_size(job.eye, request.size);
    const Stopwatch stopwatch;
    const ColorImage picture = picture_of(lumigraph, eye, request.stereo_baseline, draw);
    const double ms = 1000.0 * stopwatch.elapsed().wall_s;
    write_png(job.out, picture);
    return Json{{"file", job.out.string()}, {"ms", ms}};
}

/// Draws a path into a folder of numbered frames or into a video (write_video); either whole or not
/// at all.
Json draw_path(const RenderRequest& request, const Lumigraph& lumigraph, const Draw& draw,
               const CommandContext& context) {
    const std::vector<Eye> path =
        eye_path(request.path, request.frames, request.size, lumigraph, request.video_fps);
    const bool is_video = names_video(request.out);
    WholeFolder folder(is_video ? frames_folder_of_video(request.out) : request.out);
    // It may lie among the photographs, and frames are none.
    mark_as_made_by_lumi(folder.staging());
    Json frames = Json::array();
    context.progress->begin("drawing", path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        context.progress->throw_if_interrupted();
        Json frame = draw_to_file({path[i], folder.staging() / sequence_frame_name(i)}, request,
                                  lumigraph, draw);
        frame["file"] = (request.out / sequence_frame_name(i)).string();
        if (is_video) frame.erase("file");
        frames.push_back(std::move(frame));
        context.progress->advance();
    }
    if (is_video) {
        write_video(folder, path.size(), request.video_fps, request.out, *context.progress);
    } else {
        folder.put_in_place();
    }
    if (!context.json) context.print_result(request.out.string() + "\n");
    return frames;
}

Json draw_jobs(const RenderRequest& request, const Lumigraph& lumigraph,
               const std::vector<Job>& jobs, const Draw& draw, const CommandContext& context) {
    Json frames = Json::array();
    context.progress->begin("drawing", jobs.size());
    for (const Job& job : jobs) {
        context.progress->throw_if_interrupted();
        frames.push_back(request.difference ? draw_difference(job, draw)
                                            : draw_to_file(job, request, lumigraph, draw));
        context.progress->advance();
        if (!context.json) context.print_result(frame_text(frames.back()));
    }
    return frames;
}

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
    RenderOptions options = render_options_of(request.drawing, at.drawn);
    const Lumigraph lumigraph =
        read_package(request.package, {}, exposures_of(request.drawing, at.drawn));
    keep_free_memory();
    options.fade_beyond_capture =
        fade_of(request.drawing, at.drawn).value_or(lumigraph.drawing.fade_beyond_capture);
    check_focus(request.drawing, at.drawn, possible_options(options, lumigraph.has_depth()));
    options.focal_plane = focal_plane_of(request.drawing, request.package, lumigraph);
    say_why_black(request, lumigraph, options, context);
    const FrameDrawer drawer =
        frame_drawer(lumigraph, options, request.drawing.aperture, request.reference);

    Json frames = request.path.empty()
                      ? draw_jobs(request, lumigraph, jobs_of(request, at.eye, options, lumigraph),
                                  drawer.draw, context)
                      : draw_path(request, lumigraph, drawer.draw, context);
    if (!context.json) return;
    context.print_result(Json{{"mode", name_of(options.mode)},
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
                    "of each, or with .difference, .stereo or the debug picture after the mode");
    CLI::Option* path = where->add_option(
        "--path", request->path,
        "Along a path that the window recorded (a JSON file), or from photograph to "
        "photograph (the word views); --out names a folder or an .mp4 file");
    where->require_option(1);
    command.add_option("--frames", request->frames, "Of the path `views`")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str()
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
