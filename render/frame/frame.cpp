#include "render/frame/frame.h"

#include <array>
#include <utility>

#include "render/frame/mode_of_a_paper.h"

namespace lumi {
namespace {

constexpr std::array<std::pair<RenderMode, const char*>, 5> kModeNames{
    {{RenderMode::kLightField, "lightfield"},
     {RenderMode::kPerPixel, "perpixel"},
     {RenderMode::kAdaptive, "adaptive"},
     {RenderMode::kPaper2001, "paper2001"},
     {RenderMode::kHeigl, "heigl"}}};

constexpr std::array<std::pair<DebugPicture, const char*>, 7> kDebugPictureNames{
    {{DebugPicture::kNone, "none"},
     {DebugPicture::kWeights, "weights"},
     {DebugPicture::kFaces, "faces"},
     {DebugPicture::kDepth, "depth"},
     {DebugPicture::kConfidence, "confidence"},
     {DebugPicture::kOcclusion, "occlusion"},
     {DebugPicture::kGrid, "grid"}}};

template <class Names, class Value>
std::string name_in(const Names& names, Value value) {
    for (const auto& [known, name] : names)
        if (known == value) return name;
    return {};
}

template <class Value, std::size_t count>
std::optional<Value> value_in(const std::array<std::pair<Value, const char*>, count>& names,
                              const std::string& wanted) {
    for (const auto& [known, name] : names)
        if (wanted == name) return known;
    return std::nullopt;
}

}  // namespace

std::string name_of(RenderMode mode) { return name_in(kModeNames, mode); }

std::vector<RenderMode> all_render_modes() {
    std::vector<RenderMode> modes;
    for (const auto& [mode, name] : kModeNames) modes.push_back(mode);
    return modes;
}

std::vector<DebugPicture> all_debug_pictures() {
    std::vector<DebugPicture> pictures;
    for (const auto& [picture, name] : kDebugPictureNames) pictures.push_back(picture);
    return pictures;
}

std::optional<RenderMode> render_mode_named(const std::string& name) {
    return value_in(kModeNames, name);
}

std::string name_of(DebugPicture picture) { return name_in(kDebugPictureNames, picture); }

std::optional<DebugPicture> debug_picture_named(const std::string& name) {
    return value_in(kDebugPictureNames, name);
}

RenderOptions possible_options(RenderOptions wanted, bool has_depth) {
    if (!has_depth && wanted.mode != RenderMode::kHeigl) wanted.mode = RenderMode::kLightField;
    return wanted;
}

Frame empty_frame(const Camera& eye_camera) {
    return {ColorImage(eye_camera.width_px, eye_camera.height_px),
            GrayImage(eye_camera.width_px, eye_camera.height_px),
            {}};
}

bool are_surroundings_drawn(const RenderOptions& options) {
    const bool is_picture = options.debug_picture == DebugPicture::kNone ||
                            options.debug_picture == DebugPicture::kGrid;
    return options.guess_surroundings && is_picture && !is_of_a_paper(options.mode) &&
           !options.fade_beyond_capture;
}

}  // namespace lumi
