#pragma once

namespace lumi {

/// Chooses how coarsely frames are drawn while the eye moves, so that moving stays smooth where
/// drawing is slow; at rest frames are whole.
class MovingResolution {
 public:
    /// What a frame cost that was drawn at `scale` (its share of the window's width).
    void measured(double scale, double frame_ms);
    /// The scale for the next frame while the eye moves: 1, or a coarser one that keeps
    /// kTargetFrame_ms.
    [[nodiscard]] double scale_while_moving() const;

    static constexpr double kTargetFrame_ms = 33.0;
    static constexpr double kCoarsest = 0.25;

 private:
    double whole_frame_ms_ = 0.0;  ///< Estimated, for scale 1.
};

}  // namespace lumi
