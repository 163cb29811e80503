#pragma once

#include <Eigen/Core>

namespace lumi {

/// How a picture is shown enlarged within its frame.
struct Enlargement {
    double times = 1.0;  ///< At least 1.
    /// Where the picture's top left is, in shares of the frame: -(times - 1) to 0.
    Eigen::Vector2d corner = Eigen::Vector2d::Zero();

    /// Where a place of the picture that is not enlarged lies in the frame.
    [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector2d& place_px,
                                        const Eigen::Vector2d& frame_px) const {
        return times * place_px + corner.cwiseProduct(frame_px);
    }
};

/// By a quarter for each step (> 0), or back; the place under the cursor (in shares of the frame)
/// stays as long as the picture fills the frame.
[[nodiscard]] Enlargement enlarged_about(const Enlargement& from,
                                         const Eigen::Vector2d& cursor_share, double steps);

}  // namespace lumi
