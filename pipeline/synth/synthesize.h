#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/capture/image.h"
#include "calib/work/progress.h"
#include "pipeline/synth/scene_description.h"

namespace lumi {

/// A capture whose truth is known, in memory.
struct SyntheticCapture {
    Capture capture;  ///< Exact; one camera, views IMG_0001.png ..., points with true tracks.
    std::vector<ColorImage> photographs;  ///< One per view.
    std::vector<FloatImage> depths;       ///< z at the centres of the pixels; 0: nothing there.
};

/// The capture alone: cameras, poses, and points whose colours are still black. Throws Error
/// (E-SYNTH-INSIDE) when a camera stands inside a body.
[[nodiscard]] Capture exact_capture(const SceneDescription& description);

/// Takes all photographs of a scene. The same bytes for any number of threads.
[[nodiscard]] SyntheticCapture synthesize(const SceneDescription& description, int threads,
                                          Progress& progress);

/// The same into files, one photograph in memory for each thread: FOLDER/photos/NAME.png, and in
/// FOLDER/truth `sparse/` (a COLMAP text model), `depth/NAME.tiff` (float z; 0: nothing there) and
/// `scene.toml`. Throws Error (E-FILE-WRITE, E-SYNTH-INSIDE; E-SYNTH-FOLDER when photographs that
/// are not of this scene lie there).
void synthesize_into(const std::filesystem::path& folder, const SceneDescription& description,
                     int threads, Progress& progress);

}  // namespace lumi
