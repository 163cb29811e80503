#include "pipeline/evaluate/pictured_eye.h"

#include <algorithm>
#include <cmath>

#include "calib/pictures/image_io.h"
#include "calib/work/stopwatch.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {

KeptBackViews keep_back(const Lumigraph& lumigraph, int every, int first) {
    KeptBackViews kept;
    for (int i = 0; i < static_cast<int>(lumigraph.views.size()); ++i) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(i)];
        if (i % every == first) {
            kept.pictures.push_back({{view.camera, view.cam_from_world},
                                     evened_photograph(view, lumigraph.light_falloff)});
        } else {
            kept.others.push_back(i);
        }
    }
    return kept;
}

PicturedEye no_larger_than(PicturedEye picture, int max_px) {
    const Camera& camera = picture.eye.camera;
    const double scale = max_px / static_cast<double>(std::max(camera.width_px, camera.height_px));
    if (scale >= 1) return picture;
    const int width_px = std::max(1, static_cast<int>(std::lround(scale * camera.width_px)));
    const int height_px = std::max(1, static_cast<int>(std::lround(scale * camera.height_px)));
    return {{resized(camera, width_px, height_px), picture.eye.cam_from_world},
            resized(picture.photograph, width_px, height_px),
            picture.falloff};
}

void draw_picture(OffscreenRenderer& renderer, const PicturedEye& picture,
                  const RenderOptions& options, DrawnPictures& drawn) {
    const Stopwatch stopwatch;
    Frame frame = renderer.draw(picture.eye, options);
    drawn.frame_ms.push_back(1000.0 * stopwatch.elapsed().wall_s);
    drawn.losses_db.push_back(
        -psnr_db(picture.photograph,
                 darkened_by_lens(std::move(frame.color), picture.eye.camera, picture.falloff)));
    drawn.triangles.push_back(static_cast<double>(frame.statistics.triangles));
}

DrawnPictures draw_pictures(OffscreenRenderer& renderer, const std::vector<PicturedEye>& pictures,
                            const RenderOptions& options) {
    DrawnPictures drawn;
    for (const PicturedEye& picture : pictures) draw_picture(renderer, picture, options, drawn);
    return drawn;
}

DrawnPictures draw_pictures(const Lumigraph& lumigraph, const std::vector<PicturedEye>& pictures) {
    OffscreenRenderer renderer(lumigraph);
    // Programs are compiled for the first frame, which would be timed with it.
    if (!pictures.empty()) static_cast<void>(renderer.draw(pictures.front().eye, {}));
    return draw_pictures(renderer, pictures, {});
}

}  // namespace lumi
