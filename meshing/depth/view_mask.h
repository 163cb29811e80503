#pragma once

#include <optional>

#include "meshing/depth/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Which pixels of a view belong to the scene: 255, and which do not: 0.

/// The mask drawn for a view: a grey PNG in `folder` with the view's name, its extension replaced
/// by or followed by ".png", of the picture's aspect ratio and any size; a pixel that is darker
/// than half is not part of the scene. Throws Error: E-DEPTH-MASK (no mask for this view),
/// E-DEPTH-MASKSIZE (another aspect ratio).
[[nodiscard]] GrayImage drawn_mask(const DepthView& view, const std::filesystem::path& folder);

/// The colour of a plain background, as of a photograph taken before black cloth: nine tenths of
/// the frame along the border of nearly every view have it, within the noise. Empty when there is
/// none, or when it differs from view to view, or when hardly anything stands before it.
[[nodiscard]] std::optional<Rgb8> plain_background(const DepthScene& scene);

/// The view without its plain background: what is connected to the border by pixels of this colour.
[[nodiscard]] GrayImage mask_of_background(const DepthView& view, Rgb8 background);

/// The masks of all views: drawn ones where a folder is given, else of a plain background if one
/// is looked for and found. Empty images where every pixel belongs to the scene.
[[nodiscard]] std::vector<GrayImage> scene_masks(const DepthScene& scene,
                                                 const std::filesystem::path& folder,
                                                 bool looks_for_background, int threads);

/// Nothing is claimed of what does not belong to the scene. An empty mask changes nothing.
void claim_nothing_beyond(const GrayImage& mask, DepthMap& map);

/// What does not belong to the scene is known to be behind all of it: infinitely far, and certain.
/// What belongs to it and was filled is at least known to stand before that: it gets the least
/// confidence that counts as seen, or the background would show through. Returns the background's
/// share; an empty mask changes nothing.
double separate_background(const GrayImage& mask, DepthMap& map);

}  // namespace lumi
