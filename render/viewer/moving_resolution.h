#pragma once

namespace lumi {

/// Chooses how coarsely frames are drawn while the eye moves, so that moving stays smooth where
/// drawing is slow; at rest frames are whole.
class MovingResolution {
 public:
    /// How many frames a second are kept; 0 or less: kFramesPerSecond.
    explicit MovingResolution(double frames_per_second = 0.0);

    /// What a frame cost that was drawn at `scale` (its share of the window's width) while the eye
    /// moved.
    void measured(double scale, double frame_ms);
    /// What a frame cost that was drawn otherwise, as those of an eye at rest are: believed until a
    /// frame of a moving eye is measured.
    void guessed(double scale, double frame_ms);
    /// Frames are of another kind from here on: what is known of those before is a guess.
    void begin_anew() { is_measured_ = false; }
    /// The scale for the next frame while the eye moves: 1, or a coarser one that is quick enough.
    [[nodiscard]] double scale_while_moving() const;

    static constexpr double kFramesPerSecond = 30.0;
    static constexpr double kCoarsest = 0.25;

 private:
    double target_ms_;
    double whole_frame_ms_ = 0.0;  ///< Estimated, for scale 1.
    bool is_measured_ = false;     ///< And not guessed.
};

}  // namespace lumi
