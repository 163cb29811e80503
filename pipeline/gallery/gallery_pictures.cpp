#include "pipeline/gallery/gallery_pictures.h"

#include <algorithm>
#include <array>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/paste.h"
#include "render/paths/path_through_views.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

constexpr int kGapPx = 4;
constexpr int kPanelWidthPx = 700;
constexpr int kColumns = 2;

}  // namespace

ColorImage fitted_to(const ColorImage& picture, int max_width_px) {
    if (picture.width() <= max_width_px) return picture;
    return resized(picture, max_width_px,
                   std::max(1, picture.height() * max_width_px / picture.width()));
}

Eye eye_between_photographs(const Lumigraph& lumigraph, int width_px, int height_px) {
    const int views = static_cast<int>(lumigraph.views.size());
    // An eye at each photograph, and one halfway to the next.
    const std::vector<Eye> path =
        path_through_views(lumigraph, std::max(3, 2 * views - 1), width_px, height_px);
    const int before = std::max(0, (views - 2) / 2);
    return path[static_cast<std::size_t>(2 * before + 1)];
}

ColorImage methods_picture(const Lumigraph& lumigraph) {
    const Camera& camera = lumigraph.views.front().camera;
    const int height = kPanelWidthPx * camera.height_px / camera.width_px;
    const Eye eye = eye_between_photographs(lumigraph, kPanelWidthPx, height);
    const std::array<RenderOptions, 6> panels{
        {{.mode = RenderMode::kLightField},
         {.mode = RenderMode::kPerPixel, .correct_occlusion = false},
         {.mode = RenderMode::kPerPixel},
         {.mode = RenderMode::kPerPixel, .debug_picture = DebugPicture::kWeights},
         {.mode = RenderMode::kPerPixel, .debug_picture = DebugPicture::kDepth},
         {.mode = RenderMode::kAdaptive, .debug_picture = DebugPicture::kGrid}}};
    constexpr int kRows = static_cast<int>(panels.size()) / kColumns;
    OffscreenRenderer renderer(lumigraph);
    ColorImage canvas(kColumns * (kPanelWidthPx + kGapPx) - kGapPx,
                      kRows * (height + kGapPx) - kGapPx, {255, 255, 255});
    for (int i = 0; i < kColumns * kRows; ++i) {
        const Frame frame = renderer.draw(eye, panels[static_cast<std::size_t>(i)]);
        paste(canvas, frame.color, i % kColumns * (kPanelWidthPx + kGapPx),
              i / kColumns * (height + kGapPx));
    }
    return canvas;
}

}  // namespace lumi
