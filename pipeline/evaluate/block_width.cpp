#include "pipeline/evaluate/block_width.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/image_metrics.h"

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
double sum_of_psnr_db(KeptBackPhotographs& photographs, const DrawingChoices& drawing,
                      double block_px) {
    double sum_db = 0;
    photographs.visit(drawing, [&](OffscreenRenderer& others, const PicturedEye& kept_back) {
        const ColorImage frame =
            others.draw(finer_eye(kept_back, block_px), {.smooth_silhouettes = false}).color;
        const ColorImage& photograph = kept_back.photograph;
        sum_db += psnr_db(photograph, resized(frame, photograph.width(), photograph.height()));
    });
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

double sufficient_block_px(KeptBackPhotographs& photographs, DrawingChoices drawing,
                           double widest_lose_db, double most_db) {
    const std::size_t asked = photographs.ask("asking photographs how fine depth must be");
    if (asked == 0) return kLeastDepthBlock_px;
    DrawingChoices in_blocks = drawing;
    in_blocks.depth_views = drawing.depth_views = kLeastDepthViews;
    in_blocks.depth_block_px = kMaxDepthBlock_px;
    drawing.depth_block_px = kLeastDepthBlock_px;
    std::array<double, kAsked_px.size()> sums_db{};
    for (std::size_t i = 0; i < kAsked_px.size(); ++i)
        sums_db[i] = sum_of_psnr_db(photographs, drawing, kAsked_px[i]) -
                     sum_of_psnr_db(photographs, in_blocks, kAsked_px[i]);
    std::vector<BlockLoss> by_width;
    for (std::size_t i = 0; i < kAsked_px.size(); ++i)
        by_width.push_back({kAsked_px[i], sums_db[i] / static_cast<double>(asked)});
    by_width.push_back({kMaxDepthBlock_px, widest_lose_db});
    return kStep_px * std::floor(width_that_loses(most_db, by_width) / kStep_px);
}

}  // namespace lumi
