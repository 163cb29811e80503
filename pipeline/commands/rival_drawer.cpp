#include "pipeline/commands/rival_drawer.h"

#include <memory>
#include <utility>

#include "calib/work/error.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/evaluate/common_pixels.h"
#include "pipeline/evaluate/resampled_pictures.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

void expect_that_draws(ReasonAgainst reason_against, const std::string& rival,
                       const Lumigraph& lumigraph) {
    const std::string reason = reason_against(lumigraph);
    if (reason.empty()) return;
    throw Error(ErrorKind::kUsage, "E-RENDER-RIVAL",
                rival + " cannot be drawn from this package: " + reason,
                "use another --rival, or one of lumi's own modes");
}

Draw plain_draw(const PlainRival& rival, const Lumigraph& lumigraph, bool guess_surroundings) {
    return [&rival, &lumigraph, guess_surroundings](const Eye& eye) {
        Frame frame = rival.draw(lumigraph, eye, depths_for(rival, lumigraph, eye));
        return guess_surroundings ? filled(std::move(frame), surroundings_picture(lumigraph, eye))
                                  : frame;
    };
}

/// What a rival's own pictures are drawn by.
struct ResampledDrawing {
    explicit ResampledDrawing(ResampledPictures resampled)
        : pictures(std::move(resampled)), renderer(pictures.lumigraph) {}

    ResampledPictures pictures;
    OffscreenRenderer renderer;
};

FrameDrawer resampled_drawer(const ResampledRival& rival, const Lumigraph& lumigraph,
                             const RenderOptions& options, Progress& progress) {
    progress.note("resampling for " + rival.name);
    const auto drawing =
        std::make_shared<ResampledDrawing>(resampled_pictures(rival, lumigraph, progress));
    return {[drawing, on_plane = drawing->pictures.on_shared_plane(options)](const Eye& eye) {
                return drawing->renderer.draw(eye, on_plane);
            },
            drawing->renderer.gl_description()};
}

}  // namespace

void add_rival_option(CLI::App& command, std::string& rival) {
    CLI::Option* option = command.add_option(
        "--rival", rival,
        "Instead of a mode of lumi's a method that the paper is compared with: " + rival_names() +
            "; two-plane and spherical from photographs that are resampled, in any --mode "
            "(default: adaptive), the others in plain code; heigl is a --mode");
    std::vector<std::string> unused = triangle_option_names();
    for (const char* name : {"--debug", "--focal-depth", "--aperture", "--supersample", "--jagged",
                             "--fade", "--no-fade", "--reference"})
        unused.emplace_back(name);
    for (const std::string& name : unused) option->excludes(command.get_option(name));
}

RenderOptions rival_options_of(const std::string& rival, const DrawingRequest& request) {
    if (rival_named(rival).plain != nullptr && request.mode)
        throw Error(ErrorKind::kUsage, "E-RENDER-RIVAL",
                    rival + " is drawn in plain code, and knows no --mode", "leave --mode out");
    RenderOptions options;
    options.mode = request.mode ? render_mode_from(*request.mode) : RenderMode::kAdaptive;
    options.guess_surroundings = !request.black_surroundings;
    return options;
}

std::string rival_method(const std::string& rival, const RenderOptions& options) {
    return rival_named(rival).plain != nullptr ? rival : rival + '-' + name_of(options.mode);
}

FrameDrawer rival_drawer(const Lumigraph& lumigraph, const std::string& rival,
                         const RenderOptions& options, Progress& progress) {
    const RivalChoice choice = rival_named(rival);
    if (choice.plain != nullptr) {
        expect_that_draws(choice.plain->reason_against, rival, lumigraph);
        return {plain_draw(*choice.plain, lumigraph, options.guess_surroundings), "plain code"};
    }
    expect_that_draws(choice.resampled->reason_against, rival, lumigraph);
    return resampled_drawer(*choice.resampled, lumigraph, options, progress);
}

}  // namespace lumi
