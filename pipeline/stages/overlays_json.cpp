#include "pipeline/stages/overlays_json.h"

#include "calib/ingest/overlay_removal.h"

namespace lumi {

nlohmann::ordered_json overlays_json(const std::vector<RemovedOverlay>& overlays) {
    auto list = nlohmann::ordered_json::array();
    for (const RemovedOverlay& overlay : overlays) {
        const ImageRectangle& picture = overlay.picture;
        list.push_back(
            {{"what", text_of(overlay)},
             {"photographs", overlay.photographs},
             {"size_px", {overlay.width_px, overlay.height_px}},
             {"picture_px", {picture.left, picture.top, picture.width_px, picture.height_px}},
             {"share", overlay.share},
             {"mask", overlay.mask_path.filename().string()}});
    }
    return list;
}

}  // namespace lumi
