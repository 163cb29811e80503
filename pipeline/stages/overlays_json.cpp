#include "pipeline/stages/overlays_json.h"

#include <utility>

#include "calib/ingest/overlay_removal.h"

namespace lumi {

using Json = nlohmann::ordered_json;

Json overlays_json(const std::vector<RemovedOverlay>& overlays) {
    Json list = Json::array();
    for (const RemovedOverlay& overlay : overlays) {
        const ImageRectangle& picture = overlay.picture;
        Json entry{{"what", text_of(overlay)},
                   {"photographs", overlay.photographs},
                   {"size_px", {overlay.width_px, overlay.height_px}},
                   {"picture_px", {picture.left, picture.top, picture.width_px, picture.height_px}},
                   {"share", overlay.share}};
        if (!overlay.mask_path.empty()) entry["mask"] = overlay.mask_path.filename().string();
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace lumi
