#include "pipeline/commands/drawing_request.h"

#include "calib/work/error.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/render_mode_argument.h"
#include "render/frame/mode_of_a_paper.h"

namespace lumi {
namespace {

/// That the mode does what is asked of it.
void check_heeded(const DrawingRequest& request, RenderMode mode) {
    const auto refuse = [&](const std::string& what, const std::string& modes) {
        throw Error(ErrorKind::kUsage, "E-RENDER-OPTION", name_of(mode) + " " + what,
                    "leave it out, or use --mode " + modes);
    };
    if (request.fade && is_of_a_paper(mode))
        refuse("draws what its paper says, and knows no --fade",
               "perpixel, adaptive or lightfield");
    if (request.jagged && mode != RenderMode::kPerPixel)
        refuse("never takes four samples of depth, and needs no --jagged", "perpixel");
}

void add_focus_options(CLI::App& command, DrawingRequest& request) {
    CLI::Option* focal_depth =
        command
            .add_option(
                "--focal-depth", request.focal_depth,
                "lightfield and heigl: distance of the plane that is sharp, world units; depth is "
                "not looked at then")
            ->check(positive_number());
    command
        .add_option("--focal-view", request.focal_view,
                    "The plane stands fixed before this photograph's camera, instead of moving "
                    "with the eye")
        ->needs(focal_depth);
    command
        .add_option(
            "--aperture", request.aperture,
            "lightfield: diameter of a lens that is as wide as several cameras stand apart, "
            "world units; what lies off the plane blurs, and what stands before it is seen "
            "through; plain code")
        ->check(positive_number());
}

}  // namespace

void add_drawing_options(CLI::App& command, DrawingRequest& request) {
    const std::string usual = " (default: what the file of --eye says, else ";
    command.add_option("--mode", request.mode,
                       render_mode_names() + "; paper2001 and heigl leave shells of close-ups out" +
                           usual + std::string(name_of(RenderOptions{}.mode)) + ")");
    command.add_option(
        "--debug", request.debug,
        debug_picture_names() + usual + std::string(name_of(RenderOptions{}.debug_picture)) + ")");
    add_focus_options(command, request);
    add_triangle_options(command, request.triangles);
    CLI::Option* aperture = command.get_option("--aperture");
    aperture->excludes(command.get_option("--debug"));
    CLI::Option* supersample =
        command
            .add_flag("--supersample", request.supersample,
                      "Four samples a pixel: smooth edges, about four times the work")
            ->excludes(aperture);
    command
        .add_flag("--jagged", request.jagged,
                  "One sample a pixel also where depth is as fine as the frame: silhouettes in "
                  "steps, less work (perpixel)")
        ->excludes(supersample);
    CLI::Option* fade =
        command
            .add_flag("--fade", request.fade,
                      "Fade to black what lies beyond the capture instead of guessing (perpixel, "
                      "adaptive, lightfield)")
            ->excludes(aperture);
    command
        .add_flag("--no-fade", request.no_fade,
                  "Do not, though the package was built with [render] fade_beyond_capture")
        ->excludes(fade);
    command.add_flag("--black-surroundings", request.black_surroundings,
                     "Leave black what no photograph shows instead of going on with the colours "
                     "next to it");
    command.add_flag("--as-taken", request.as_taken,
                     "Leave differences in exposure and white balance between photographs, and "
                     "corners that the lens darkens, as they are");
}

RenderOptions render_options_of(const DrawingRequest& request, const DrawnAlike& eye_file) {
    RenderOptions options;
    options.mode =
        request.mode ? render_mode_from(*request.mode) : eye_file.mode.value_or(options.mode);
    options.debug_picture = request.debug ? debug_picture_from(*request.debug)
                                          : eye_file.debug_picture.value_or(options.debug_picture);
    options.correct_occlusion = eye_file.correct_occlusion.value_or(options.correct_occlusion);
    options.supersample = request.supersample;
    options.smooth_silhouettes = !request.jagged;
    options.guess_surroundings = !request.black_surroundings &&
                                 eye_file.guess_surroundings.value_or(options.guess_surroundings);
    check_heeded(request, options.mode);
    apply(request.triangles, options);
    return options;
}

std::optional<bool> fade_of(const DrawingRequest& request, const DrawnAlike& eye_file) {
    if (request.fade) return true;
    if (request.no_fade) return false;
    return eye_file.fade_beyond_capture;
}

Exposures exposures_of(const DrawingRequest& request, const DrawnAlike& eye_file) {
    return request.as_taken || eye_file.as_taken.value_or(false) ? Exposures::kAsTaken
                                                                 : Exposures::kEvened;
}

}  // namespace lumi
