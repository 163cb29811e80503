#pragma once

#include <optional>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Which pixels of a view belong to the scene: 255, and which do not: 0.

/// The colour of a plain background, as of a photograph taken before black cloth: nine tenths of
/// the frame along the border of nearly every view have it, within the noise. Empty when there is
/// none, or when it differs from view to view, or when hardly anything stands before it.
[[nodiscard]] std::optional<Rgb8> plain_background(const DepthScene& scene);

/// The picture without its plain background: what is connected to the border by pixels of this
/// colour.
[[nodiscard]] GrayImage mask_of_background(const ColorImage& picture, Rgb8 background);

/// Whether what the masks of a plain background hide is a surface of the scene all the same, such
/// as a pale wall: points were found and placed on it, a fifth as densely as on the rest or more.
[[nodiscard]] bool holds_the_scene(const std::vector<GrayImage>& masks, const DepthScene& scene);

struct SceneMasks {
    std::vector<GrayImage> of_views;  ///< Empty images where every pixel belongs to the scene.
    std::optional<Rgb8> background;   ///< The plain one that was found.
};

/// The masks of all views: drawn ones where a folder is given, else of a plain background if one
/// is looked for and found, unless it holds the scene.
[[nodiscard]] SceneMasks scene_masks(const DepthScene& scene, const std::filesystem::path& folder,
                                     bool looks_for_background, int threads);

/// Nothing is claimed of what does not belong to the scene. An empty mask changes nothing.
void claim_nothing_beyond(const GrayImage& mask, DepthMap& map);

/// What does not belong to the scene is known to be behind all of it: infinitely far, and certain.
/// What belongs to it and was filled is at least known to stand before that: it gets the least
/// confidence that counts as seen, or the background would show through. Returns the background's
/// share; an empty mask changes nothing.
double separate_background(const GrayImage& mask, DepthMap& map);

}  // namespace lumi
