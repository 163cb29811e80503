#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pipeline/commands/drawing_request.h"

namespace lumi {

/// What `lumi render` is asked for.
struct RenderRequest {
    std::filesystem::path package;
    std::string view;
    std::filesystem::path eye;
    std::string path;
    std::optional<int> frames;
    double video_fps = 30.0;
    double stereo_baseline = 0.0;
    bool all_views = false;
    bool difference = false;
    std::string size;
    DrawingRequest drawing;
    bool reference = false;
    std::string rival;  ///< Empty: one of lumi's own modes.
    std::filesystem::path out;
};

}  // namespace lumi
