#include "pipeline/commands/requested_frames.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_folder.h"
#include "pipeline/commands/eye_path.h"
#include "pipeline/commands/frame_files.h"
#include "pipeline/commands/known_photographs.h"
#include "pipeline/commands/psnr_text.h"
#include "pipeline/commands/rival_drawer.h"
#include "pipeline/commands/stereo_pair.h"
#include "pipeline/commands/video_file.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/difference_picture.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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
    std::string kind = method_of(request, options);
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
        film_path(request.path, request.frames, request.size, lumigraph, request.video_fps);
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

}  // namespace

std::string method_of(const RenderRequest& request, const RenderOptions& options) {
    return request.rival.empty() ? name_of(options.mode) : rival_method(request.rival, options);
}

Json draw_requested(const RenderRequest& request, const Eye& eye, const RenderOptions& options,
                    const Lumigraph& lumigraph, const Draw& draw, const CommandContext& context) {
    if (!request.path.empty()) return draw_path(request, lumigraph, draw, context);
    return draw_jobs(request, lumigraph, jobs_of(request, eye, options, lumigraph), draw, context);
}

}  // namespace lumi
