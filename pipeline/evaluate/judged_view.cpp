#include "pipeline/evaluate/judged_view.h"

#include <algorithm>
#include <utility>

#include "calib/pictures/image_io.h"
#include "calib/work/median.h"
#include "pipeline/evaluate/edge_sharpness.h"
#include "pipeline/evaluate/flip.h"
#include "pipeline/evaluate/gain_fit.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {
namespace {

void score_picture(JudgedView& judged) {
    const ColorImage& photograph = judged.photograph;
    const Frame& frame = judged.rendering;
    ViewScore& score = judged.score;
    score.psnr_db = psnr_db(photograph, frame.color);
    score.psnr_covered_db = psnr_db(photograph, frame.color, frame.coverage);
    score.ssim = structural_similarity(photograph, frame.color);
    score.coverage = covered_share(frame.coverage);
    judged.flip = flip_error_map(photograph, frame.color);
    score.flip = mean_error(judged.flip);
    score.flip_covered = mean_error(judged.flip, frame.coverage);
    score.edge_sharpness = edge_sharpness(photograph, frame.color, frame.coverage);
    if (const auto fit = fit_gain(photograph, frame.color, frame.coverage)) {
        score.psnr_gain_fitted_db = fit->psnr_db;
        score.gain = fit->gain;
    }
    if (judged.subject.empty()) return;
    score.psnr_subject_db = psnr_db(photograph, frame.color, judged.subject);
    score.flip_subject = mean_error(judged.flip, judged.subject);
    score.subject_coverage = covered_share(frame.coverage, judged.subject);
    score.subject_share = covered_share(judged.subject);
}

void score_times(const RepeatedTimes& times, ViewScore& score) {
    const auto [fastest, slowest] = std::minmax_element(times.wall_ms.begin(), times.wall_ms.end());
    score.ms = median_of(times.wall_ms);
    score.fastest_ms = *fastest;
    score.slowest_ms = *slowest;
    score.cpu_ms = median_of(times.cpu_ms);
}

}  // namespace

std::vector<Eye> eyes_of(const PosedPhotographs& held_out) {
    std::vector<Eye> eyes;
    for (const View& view : held_out.capture.views) {
        eyes.push_back({camera_of(held_out.capture, view), view.cam_from_world});
    }
    return eyes;
}

JudgedView judged_view(const PosedPhotographs& held_out, std::size_t index,
                       const Lumigraph& lumigraph, const SubjectMask& subject_mask, Frame rendering,
                       const RepeatedTimes& times) {
    const View& view = held_out.capture.views[index];
    JudgedView judged;
    judged.score.name = view.name;
    const Camera camera = camera_of(held_out.capture, view);
    judged.score.place = place_of_view(lumigraph.mesh, camera, view.cam_from_world);
    judged.photograph = read_color_image(held_out.picture_paths[index]);
    judged.score.width_px = judged.photograph.width();
    judged.score.height_px = judged.photograph.height();
    if (subject_mask) judged.subject = subject_mask(judged.score.name, judged.photograph);
    judged.rendering = std::move(rendering);
    judged.rendering.color =
        darkened_by_lens(std::move(judged.rendering.color), camera, lumigraph.evened_falloff);
    score_picture(judged);
    score_times(times, judged.score);
    return judged;
}

}  // namespace lumi
