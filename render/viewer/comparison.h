#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/gl/object_name.h"
#include "render/gl/texture.h"
#include "render/renderer/frame_target.h"
#include "render/viewer/commands.h"

namespace lumi {

/// Part of the window's picture and what is shown there instead.
struct PictureOverlay {
    unsigned texture = 0;
    Eigen::Vector2d low_px = Eigen::Vector2d::Zero();   ///< Top left, in pixels of the picture.
    Eigen::Vector2d high_px = Eigen::Vector2d::Zero();  ///< Bottom right.
    /// What of the texture is seen there, in shares of it.
    Eigen::Vector2d texture_low = Eigen::Vector2d::Zero();
    Eigen::Vector2d texture_high = Eigen::Vector2d::Ones();
    double share = 1.0;    ///< So much of its width, from the left.
    std::string likeness;  ///< Of the photograph and what is drawn in its place, in words.
};

/// Where the picture of `eye` lies in a frame that it was fitted to (fitted_to), and what of it
/// where the frame shows it enlarged.
[[nodiscard]] PictureOverlay fitted_overlay(const Eye& eye, int width_px, int height_px,
                                            const Enlargement& enlargement = {});

/// Photographs that the Lumigraph was made without, beside what is drawn of it in their place.
/// Needs the window's context.
class Comparison {
 public:
    explicit Comparison(std::vector<HeldOutView> views, LikenessWords likeness_words = {})
        : views_(std::move(views)), likeness_words_(std::move(likeness_words)) {}

    [[nodiscard]] const std::vector<HeldOutView>& views() const { return views_; }

    /// What lies over a frame of this size, as the state wishes; empty where nothing is compared or
    /// the eye has left the photograph's place. Difference and likeness are those of a whole
    /// picture of the photograph's size, drawn where what is compared changes.
    [[nodiscard]] std::optional<PictureOverlay> over_frame(const ViewerState& state, int width_px,
                                                           int height_px,
                                                           LumigraphRenderer& renderer);

 private:
    /// What texture and likeness were made of.
    struct Shown {
        int index = -1;
        bool is_difference = false;
        RenderOptions options;

        bool operator==(const Shown&) const = default;
    };

    std::vector<HeldOutView> views_;
    LikenessWords likeness_words_;
    FrameTarget target_;
    ObjectName<delete_texture> texture_;
    Shown shown_;
    std::string likeness_;
};

}  // namespace lumi
