#pragma once

#include "pipeline/synth/synthesize.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A textured box on a textured floor before a wall, seen from a grid of 3 x 3 pinhole cameras:
/// every pixel shows a surface, and the box hides parts of floor and wall.
///
/// Columns go from left to right and rows from bottom to top, walked to and fro: view
/// `textured_box_view(column, row)` stands there. Takes well under a second.
struct TexturedBoxOptions {
    int width_px = 160;
    int height_px = 120;
    int points = 400;  ///< Exact scene points with tracks.
};
[[nodiscard]] SceneDescription textured_box_description(const TexturedBoxOptions& options = {});
[[nodiscard]] SyntheticCapture textured_box_scene(const TexturedBoxOptions& options = {});
[[nodiscard]] int textured_box_view(int column, int row);

/// The open camera mesh over the grid of textured_box_scene(), two faces a cell, without a skirt.
[[nodiscard]] CameraMesh textured_box_camera_mesh(const Capture& capture);

/// True depth as a map of full confidence; what shows nothing is infinitely far.
[[nodiscard]] DepthMap exact_depth_map(const FloatImage& depth);

/// A Lumigraph of views with their exact depth; for pinhole cameras.
[[nodiscard]] Lumigraph exact_lumigraph(const SyntheticCapture& scene, CameraMesh mesh);

}  // namespace lumi
