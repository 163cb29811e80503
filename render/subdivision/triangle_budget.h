#pragma once

#include <cstddef>

#include "render/frame/frame.h"

namespace lumi {

/// Chooses by how much the errors of `adaptive` are relaxed so that frames take no longer than they
/// may, after time-critical Lumigraph rendering (Sloan, Cohen, Gortler 1997): what a frame costs
/// without triangles and what each adds is learned from the frames that were drawn.
///
/// Errors are relaxed, and triangles not only counted, because a coarser subdivision also looks at
/// less of the scene. Triangles that take less than a tenth of what the frame takes without them
/// are never given away: where that is not enough they would not help.
class TriangleBudget {
 public:
    /// How many frames a second are wanted; 0 or less: any, nothing is relaxed.
    explicit TriangleBudget(double frames_per_second = 0.0);

    /// Learns from a frame that was drawn with `within(...)`.
    void measured(std::size_t triangles, double frame_ms);
    /// The options with the errors that the next frame affords; without a limit the same options.
    [[nodiscard]] RenderOptions within(RenderOptions options) const;
    /// The factor by which errors are relaxed: 1 to kMostRelaxation.
    [[nodiscard]] double relaxation() const { return relaxation_; }

    static constexpr double kMostRelaxation = 64.0;

 private:
    void learn_cost();

    double target_ms_ = 0.0;
    double relaxation_ = 1.0;
    double affordable_ = 0.0;  ///< Triangles; 0: not known.
    double ms_each_ = 0.0;     ///< Time a triangle, from frames that differed in them; 0: none did.
    // Sums over the frames, those long ago counting little: a line is fitted through them.
    double frames_ = 0.0;
    double triangles_ = 0.0;
    double ms_ = 0.0;
    double triangles_squared_ = 0.0;
    double triangles_ms_ = 0.0;
};

}  // namespace lumi
