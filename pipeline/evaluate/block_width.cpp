#include "pipeline/evaluate/block_width.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "calib/capture/image_io.h"
#include "pipeline/evaluate/image_metrics.h"
#include "pipeline/evaluate/kept_back_rounds.h"

namespace lumi {
namespace {

/// Of blocks between one pixel and the widest. Narrow to wide.
constexpr std::array<double, 2> kAsked_px{1.25, 1.5};
/// Of pixels: widths are kept in steps of this, rounded down.
constexpr double kStep_px = 0.01;

/// The eye of a frame in which a block is so wide in the picture's pixels.
Eye finer_eye(const PicturedEye& picture, double block_px) {
    const double scale = kDepthBlockSide_px / block_px;
    const Camera& camera = picture.eye.camera;
    return {resized(camera, static_cast<int>(std::lround(scale * camera.width_px)),
                    static_cast<int>(std::lround(scale * camera.height_px))),
            picture.eye.cam_from_world};
}

/// In frames as fine as that, summed over the pictures.
double sum_of_psnr_db(const Lumigraph& lumigraph, const std::vector<PicturedEye>& pictures,
                      double block_px) {
    OffscreenRenderer renderer(lumigraph);
    double sum_db = 0;
    for (const PicturedEye& picture : pictures) {
        const ColorImage frame =
            renderer.draw(finer_eye(picture, block_px), {.smooth_silhouettes = false}).color;
        sum_db += psnr_db(picture.photograph,
                          resized(frame, picture.photograph.width(), picture.photograph.height()));
    }
    return sum_db;
}

}  // namespace

double width_that_loses(double most_db, const std::vector<BlockLoss>& by_width) {
    BlockLoss narrower;
    for (const BlockLoss& wider : by_width) {
        if (wider.loses_db > most_db) {
            const double share =
                (most_db - narrower.loses_db) / (wider.loses_db - narrower.loses_db);
            return narrower.width_px + share * (wider.width_px - narrower.width_px);
        }
        narrower = wider;
    }
    return narrower.width_px;
}

double sufficient_block_px(const Lumigraph& lumigraph, const Capture& capture,
                           const CameraMeshOptions& mesh_options, double widest_lose_db,
                           double most_db, Progress& progress) {
    std::array<double, kAsked_px.size()> sums_db{};
    const std::size_t asked = visit_kept_back(
        lumigraph, capture, mesh_options, "asking photographs how fine depth must be", progress,
        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            others.drawing.depth_views = kLeastDepthViews;
            for (std::size_t i = 0; i < kAsked_px.size(); ++i) {
                progress.throw_if_interrupted();
                others.drawing.depth_block_px = kLeastDepthBlock_px;
                sums_db[i] += sum_of_psnr_db(others, pictures, kAsked_px[i]);
                others.drawing.depth_block_px = kMaxDepthBlock_px;
                sums_db[i] -= sum_of_psnr_db(others, pictures, kAsked_px[i]);
            }
        });
    if (asked == 0) return kLeastDepthBlock_px;
    std::vector<BlockLoss> by_width;
    for (std::size_t i = 0; i < kAsked_px.size(); ++i)
        by_width.push_back({kAsked_px[i], sums_db[i] / static_cast<double>(asked)});
    by_width.push_back({kMaxDepthBlock_px, widest_lose_db});
    return kStep_px * std::floor(width_that_loses(most_db, by_width) / kStep_px);
}

}  // namespace lumi
