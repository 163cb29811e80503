#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What an eye would see; empty where nobody knows.
using TruePicture = std::function<ColorImage(const Eye&)>;

/// Two frames between which a picture changes all at once.
struct Jump {
    std::size_t frame = 0;  ///< The second of the pair on the path.
    /// What is left of the change between two frames when the way between them is halved again and
    /// again, each time the half that changes more: 0 when the picture is continuous. Steps of
    /// 1/255, mean over the picture.
    double change = 0.0;
    double pixel_share = 0.0;  ///< Of the pixels that still change by more than kSeen_steps.
    ColorImage before{};
    ColorImage after{};
};
inline constexpr int kSeen_steps = 8;

/// How one mode, or the scene itself, changes along a path. All in steps of 1/255.
struct FlickerFigures {
    std::string mode;
    std::vector<double> changes;  ///< Mean absolute change from each frame to the next.
    /// Mean absolute difference between the change and the true change (methods: 5.3).
    std::optional<double> flicker;
    std::optional<double> worst_flicker;  ///< Of one pair of frames.
    Jump jump;                            ///< The largest of those looked for.
};

/// Draws a path in every mode and looks closer where a picture changes more than before and after.
/// The truth, where known, comes last.
[[nodiscard]] std::vector<FlickerFigures> benchmark_flicker(const Lumigraph& lumigraph,
                                                            const std::vector<Eye>& path,
                                                            const TruePicture& truth,
                                                            Progress& progress);

}  // namespace lumi
