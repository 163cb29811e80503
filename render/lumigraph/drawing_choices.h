#pragma once

namespace lumi {

/// Two views whose depths agree outvote a third; with four, one may also not know.
inline constexpr int kLeastDepthViews = 3;
inline constexpr int kMaxDepthViews = 4;

/// Depth may be worked out for blocks of so many by so many pixels: a GL draws four pixels at once,
/// and no more.
inline constexpr int kDepthBlockSide_px = 2;
/// How wide such blocks may be, in pixels of the photographs. The narrowest: nobody can tell.
inline constexpr double kLeastDepthBlock_px = 1.0;
inline constexpr double kMaxDepthBlock_px = kDepthBlockSide_px;

/// Disparity by which depths of one surface may differ.
inline constexpr double kAgreeingDisparity_px = 1.5;

/// Of DrawingChoices::occlusion_tolerance_px: the default where photographs were not asked, and its
/// bounds.
inline constexpr double kOcclusionTolerance_px = kAgreeingDisparity_px;
inline constexpr double kLeastOcclusionTolerance_px = 0.1;
inline constexpr double kMostOcclusionTolerance_px = 100.0;

/// Of DrawingChoices::triangle_error_px: the default where photographs were not asked, and its
/// bounds.
inline constexpr double kTriangleError_px = 0.7;
inline constexpr double kLeastTriangleError_px = 0.1;
inline constexpr double kMostTriangleError_px = 10.0;

/// How a Lumigraph is drawn where nobody says otherwise: mostly what its own photographs chose
/// when the package was made.
struct DrawingChoices {
    /// Whether the border of the capture fades (RenderOptions::fade_beyond_capture).
    bool fade_beyond_capture = false;
    /// Disparity beyond which a view sees something else than the point that is drawn
    /// (occlusion.h): the more, the less its depth is to be trusted.
    double occlusion_tolerance_px = kOcclusionTolerance_px;
    /// How many views' depths are compared at each pixel, or as many views as there are.
    int depth_views = kMaxDepthViews;
    /// Per pixel, depth is worked out for blocks of pixels if the frame is so fine that a block is
    /// no wider than this in pixels of the photographs; at kMaxDepthBlock_px in any frame.
    double depth_block_px = kLeastDepthBlock_px;
    /// Whether, per pixel, what none of these views sees is drawn from others
    /// (render/holes/hole_triangles.h): worth its time where much is hidden from them.
    bool fills_holes = false;
    /// Whether, per pixel, a guess on the scene plane, where no depth is known, leaves out views
    /// whose depth, seen or filled, has something kSurelyBefore_px before it; and all but those
    /// that have nothing there, infinitely far, if there are any: worth its time where subjects
    /// stand alone.
    bool checks_guesses = false;
    /// How far from the right place `adaptive` may look up photographs before it splits triangles.
    double triangle_error_px = kTriangleError_px;
    /// Whether it draws what is thinner than its triangles over them (thin_triangles.h): worth its
    /// time where there are bars, cables or leaves.
    bool draws_thin = false;

    bool operator==(const DrawingChoices&) const = default;
};

/// One of these: its name in files, and the least and the most that it may be.
template <class Value>
struct DrawingChoice {
    const char* name;
    Value DrawingChoices::*member;
    Value least;
    Value most;
};

/// Calls `visit` with each of them: of bool, int or double.
template <class Visit>
void for_each_drawing_choice(const Visit& visit) {
    using Choices = DrawingChoices;
    const auto flag = [&](const char* name, bool Choices::*member) {
        visit(DrawingChoice<bool>{name, member, false, true});
    };
    const auto number = [&](const char* name, auto Choices::*member, auto least, auto most) {
        visit(DrawingChoice<decltype(least)>{name, member, least, most});
    };
    flag("fade_beyond_capture", &Choices::fade_beyond_capture);
    number("depth_views", &Choices::depth_views, kLeastDepthViews, kMaxDepthViews);
    number("depth_block_px", &Choices::depth_block_px, kLeastDepthBlock_px, kMaxDepthBlock_px);
    number("occlusion_tolerance_px", &Choices::occlusion_tolerance_px, kLeastOcclusionTolerance_px,
           kMostOcclusionTolerance_px);
    flag("fills_holes", &Choices::fills_holes);
    flag("checks_guesses", &Choices::checks_guesses);
    number("triangle_error_px", &Choices::triangle_error_px, kLeastTriangleError_px,
           kMostTriangleError_px);
    flag("draws_thin", &Choices::draws_thin);
}

}  // namespace lumi
