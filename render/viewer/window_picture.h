#pragma once

#include <Eigen/Core>
#include <optional>

#include "render/renderer/frame_target.h"
#include "render/subdivision/triangle_budget.h"
#include "render/viewer/commands.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/moving_resolution.h"

namespace lumi {

/// All that a drawn frame depends on.
struct DrawnFrame {
    Eye eye;
    RenderOptions options;
    double scale = 0.0;  ///< Share of the window's width.
};

/// The picture in the window, drawn anew where it changes: whole at rest; while the eye moves
/// coarser and, by `adaptive`, with fewer triangles, as ViewerState::frames_per_second asks. Needs
/// the window's context.
class WindowPicture {
 public:
    /// Throws what LumigraphRenderer throws.
    explicit WindowPicture(const Lumigraph& lumigraph);

    /// Is of another Lumigraph from here on. Where this throws, nothing has changed.
    void change_to(const Lumigraph& lumigraph);
    void draw_whole(const ViewerState& state, const Eigen::Vector2i& size_px,
                    FrameStatistics& statistics);
    void draw_moving(const ViewerState& state, const Eigen::Vector2i& size_px,
                     FrameStatistics& statistics);

    /// What was drawn last, if anything was.
    [[nodiscard]] const std::optional<DrawnFrame>& drawn() const { return drawn_; }
    [[nodiscard]] const FrameTarget& target() const { return target_; }
    [[nodiscard]] LumigraphRenderer& renderer() { return renderer_; }

 private:
    /// False where the frame is the one that was drawn last. In a window that is larger than what
    /// the driver draws, the frame is as large as it draws.
    bool draw(const ViewerState& state, double scale, const Eigen::Vector2i& size_px,
              const RenderOptions& options, FrameStatistics& statistics);
    /// Frames of other options, or of another size, cost otherwise.
    void heed_what_costs(const RenderOptions& options, const Eigen::Vector2i& size_px);

    LumigraphRenderer renderer_;
    int most_side_px_;  ///< That the driver draws.
    FrameTarget target_;
    std::optional<DrawnFrame> drawn_;
    MovingResolution resolution_;
    TriangleBudget budget_;
    double frames_per_second_ = 0.0;  ///< That resolution and budget were made for.
    RenderOptions measured_options_;  ///< That the resolution was measured with.
    Eigen::Vector2i measured_size_px_ = Eigen::Vector2i::Zero();
};

}  // namespace lumi
