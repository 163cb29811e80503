#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How much `perpixel` does to know depth: how many views' depths are compared
/// (DrawingChoices::depth_views), in how wide blocks of pixels (DrawingChoices::depth_block_px),
/// whether what none of them sees is drawn from others (DrawingChoices::fills_holes), whether
/// guesses are checked (DrawingChoices::checks_guesses), and why.
struct DepthEffort {
    int views = kMaxDepthViews;
    double block_px = kLeastDepthBlock_px;
    bool fills_holes = false;
    bool checks_guesses = false;
    int pictures = 0;  ///< That were asked; 0: nobody was.
    /// What one view fewer than the most loses at them, in the mean; negative where it gains.
    double fewer_views_lose_db = 0.0;
    double standard_error_db = 0.0;  ///< Of that.
    double blocks_lose_db = 0.0;     ///< The same for blocks of kMaxDepthBlock_px.
    double holes_lose_db = 0.0;      ///< The same, of so many views, for holes that are not filled.
    /// How much more of their pictures eyes know for it, in the mean, that look from nearer and
    /// from farther than photographs, as a share; 0 where photographs alone decided.
    double moved_know_more = 0.0;
    double guesses_lose_db = 0.0;  ///< The same for guesses that are not checked, of the
                                   ///< most views, with holes filled.
};

/// How closely depth meshes follow depth maps that tell noise (Lumigraph::noisy_depth_error_px),
/// and why.
struct DepthMeshEffort {
    double noisy_error_px = kNoisyDepthError_px;
    int pictures = 0;                ///< That were asked; 0: nobody was.
    double coarsest_lose_db = 0.0;   ///< At them, in the mean, the coarsest beside the finest.
    double standard_error_db = 0.0;  ///< Of that.
    double loses_db = 0.0;           ///< What was chosen, beside the finest.
};

/// From how far on a view that sees something else is not blended
/// (DrawingChoices::occlusion_tolerance_px), and why.
struct OcclusionEffort {
    double tolerance_px = kOcclusionTolerance_px;
    int pictures = 0;                ///< That were asked; 0: nobody was.
    double beside_px = 0.0;          ///< Another tolerance, to compare with.
    double gains_db = 0.0;           ///< At them, in the mean, beside that one.
    double standard_error_db = 0.0;  ///< Of that.
};

/// How far the triangles of `adaptive` may err (DrawingChoices::triangle_error_px), whether what is
/// thinner is drawn over them (DrawingChoices::draws_thin), and why.
struct TriangleEffort {
    double error_px = kTriangleError_px;
    int pictures = 0;        ///< That were asked; 0: nobody was.
    double loses_db = 0.0;   ///< At them, in the mean, beside the best of the errors asked.
    double triangles = 0.0;  ///< Drawn, in the mean; 0 where the error was given.
    bool draws_thin = false;
    double thin_gains_db = 0.0;           ///< At them, in the mean; 0 where nothing is thin.
    double thin_standard_error_db = 0.0;  ///< Of that.
};

/// All that photographs choose of how they are drawn, in this order.
struct DrawingEfforts {
    OcclusionEffort occlusion;
    DepthEffort depth;
    TriangleEffort triangles;
};

/// Takes over into `drawing` what was chosen.
void choose(const OcclusionEffort& effort, DrawingChoices& drawing);
void choose(const DepthEffort& effort, DrawingChoices& drawing);
void choose(const TriangleEffort& effort, DrawingChoices& drawing);
void choose(const DrawingEfforts& efforts, DrawingChoices& drawing);

/// Where depth is worked out, for people: "each block of 2 by 2 pixels".
[[nodiscard]] std::string text_of_depth_blocks(double block_px);

/// For the journal of a build: what was chosen, and what was measured for it. Empty where nobody
/// was asked.
[[nodiscard]] std::string text_of(const DepthEffort& effort);
[[nodiscard]] std::string text_of(const DepthMeshEffort& effort);
[[nodiscard]] std::string text_of(const OcclusionEffort& effort);
[[nodiscard]] std::string text_of(const TriangleEffort& effort);

[[nodiscard]] nlohmann::ordered_json json_of(const DepthEffort& effort);
[[nodiscard]] nlohmann::ordered_json json_of(const DepthMeshEffort& effort);
[[nodiscard]] nlohmann::ordered_json json_of(const OcclusionEffort& effort);
[[nodiscard]] nlohmann::ordered_json json_of(const TriangleEffort& effort);

}  // namespace lumi
