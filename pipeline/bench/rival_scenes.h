#pragma once

#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/synth/scene.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A picture that is known without being photographed, and where the surfaces end in it.
struct TrueFrame {
    Eye eye;
    ColorImage picture;
    FloatImage depth;  ///< z; 0: nothing there.
    GrayImage shown;   ///< 255: some photograph shows what is there; 0: none does.
};

/// A Lumigraph of a synthetic scene with exact poses and depth, and what a package of it would
/// have: depth meshes, and how its own photographs choose that it is drawn.
struct RivalCapture {
    std::string name;
    std::string paper;
    std::vector<std::size_t> paper_triangles;  ///< At which the paper reports frames a second.
    Lumigraph lumigraph;
    std::vector<TrueFrame> held_out;
    /// Each of these places twice, a tenth of the way towards the scene and as far away from it:
    /// where photographs stand, a method is judged only for eyes on the surface of the cameras.
    std::vector<TrueFrame> off_cameras;
    std::vector<TrueFrame> path;  ///< Even steps between two places that are held out.
};

struct RivalCaptureOptions {
    int size_px = 256;
    int held_out = 8;
    int path_frames = 24;
};

/// Scenes after the paper's figures 7 (33 hand-held photographs), 8 (169) and 9 (107, all around):
/// the demo's cat, from three paths.
[[nodiscard]] std::vector<std::string> rival_scene_names();
[[nodiscard]] RivalCapture rival_capture(const std::string& name,
                                         const RivalCaptureOptions& options, Progress& progress);

/// What a camera would photograph anywhere in one of the scenes.
[[nodiscard]] ColorImage true_picture(const std::string& name, const RivalCaptureOptions& options,
                                      const Eye& eye);

}  // namespace lumi
