#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// The capture that the rooms beyond `calib` work on: every camera is a pinhole
/// (LensModel::kPinhole), and each view's photograph is a picture file of exactly its camera's
/// size, free of lens distortion.
struct PosedPhotographs {
    Capture capture;
    std::vector<std::filesystem::path> picture_paths;  ///< One per view, in the order of the views.
};

/// A photograph that was left out, and why.
struct LeftOut {
    std::string name;
    std::string code;    ///< Stable, such as "E-INGEST-TRUNCATED".
    std::string reason;  ///< In the words of a photographer.
};

}  // namespace lumi
