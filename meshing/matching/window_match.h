#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "calib/capture/image.h"
#include "calib/capture/inverse_depth_warp.h"
#include "meshing/matching/patch_matching.h"

namespace lumi {

/// How well a small window around a pixel fits other views when the surface there is a plane of any
/// slant: the inner loop of PatchMatch.

/// A plane in inverse depth, which is affine in the picture.
struct PixelPlane {
    float inverse_depth = 0.0F;  ///< At the pixel.
    float right = 0.0F;          ///< What one pixel to the right adds.
    float down = 0.0F;           ///< What one pixel down adds.

    /// The same plane as seen from another pixel.
    [[nodiscard]] PixelPlane at(int dx, int dy) const {
        return {inverse_depth + right * static_cast<float>(dx) + down * static_cast<float>(dy),
                right, down};
    }
};

/// The window: 4 x 4 pixels with gaps between, 7 x 7 pixels in all.
constexpr std::size_t kWindowSamples = 16;
constexpr int kWindowRadius = 3;

/// A window of the view, ready for comparison.
struct ReferenceWindow {
    std::array<float, kWindowSamples> weights{};  ///< Sum 1.
    /// Grey values less their weighted mean, times their weights, over their weighted deviation.
    std::array<float, kWindowSamples> normalised{};
    bool has_texture = false;  ///< The deviation is above the noise of a sensor.
};

/// Samples weigh less the more they differ from the pixel in grey (bilateral weights, Yoon and
/// Kweon 2006), so that a window at a silhouette asks the pixel's own side.
[[nodiscard]] ReferenceWindow reference_window(const GrayImage& gray, int x, int y);

/// Another view, ready to be compared with.
struct ComparedView {
    std::array<float, 9> homography{};  ///< By rows; InverseDepthWarp in single precision.
    std::array<float, 3> epipole{};
    PackedPicture picture;
};
[[nodiscard]] ComparedView compared_view(const InverseDepthWarp& warp, const GrayImage& gray);

/// 1 - weighted correlation of the window around pixel (x, y) with each view, 0 to 2, into `costs`;
/// kWindowUnseen where the pixel lies outside of that view.
constexpr float kWindowUnseen = 4.0F;
void window_costs(const ReferenceWindow& window, const std::vector<ComparedView>& views, int x,
                  int y, const PixelPlane& plane, float* costs);

}  // namespace lumi
