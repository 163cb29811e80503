#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/ingest/ingest.h"
#include "calib/poses/pose_stage.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/depth/depth_stage.h"

namespace lumi {

/// Which views are kept back, to measure renderings against: they take part in the poses and in
/// nothing else.
struct HoldOutOptions {
    int every = 0;                   ///< Photographs 0, N, 2N ... in order of name. 0: none; >= 2.
    std::vector<std::string> names;  ///< Instead: these, as in the photographs' folder.
    std::string place = {};          ///< Where the configuration names them: "my.toml:7".
};

/// What goes into the package. Of views in use all have depth; those that are left out of the
/// package only lend theirs to others.
struct PackageOptions {
    bool fewest_views = false;  ///< As few as held-out error cannot tell from more.
    int max_views = 0;          ///< 0: no limit.
    double max_mib = 0.0;       ///< Of the finished package; 0: no limit.
    /// What was there for one photograph alone stays in it (transients.h).
    bool keep_transients = false;
};

/// What a package says of how it is to be drawn.
struct DrawingOptions {
    /// Differences in exposure and white balance between neighbours, and what the lens takes from
    /// the corners, are measured and evened out.
    bool even_exposure = true;
    bool fade_beyond_capture = false;  ///< The default of `lumi render` and `lumi view`.
    /// Disparity beyond which a view sees something else (DrawingChoices::occlusion_tolerance_px),
    /// 0.1 to 100; 0: as photographs ask for.
    double occlusion_tolerance_px = 0.0;
    /// How closely depth meshes follow depth maps that tell noise
    /// (Lumigraph::noisy_depth_error_px), 0.1 to 10; 0: as photographs ask for.
    double noisy_depth_error_px = 0.0;
    /// How many views' depths are compared at each pixel, 3 or 4; 0: as photographs ask for.
    int depth_views = 0;
    /// How wide blocks of pixels may be that depth is worked out for, in pixels of the photographs
    /// (DrawingChoices::depth_block_px), 1 to 2; 0: as wide as photographs cannot tell.
    double depth_block_px = 0.0;
    /// Whether `perpixel` draws from other views what none that it asks for depth sees
    /// (DrawingChoices::fills_holes); empty: where photographs ask for it.
    std::optional<bool> fill_holes;
    /// Whether guesses are drawn only where nothing was seen before them
    /// (DrawingChoices::checks_guesses); empty: where photographs ask for it.
    std::optional<bool> check_guesses;
    /// Of the triangles that `adaptive` draws; 0: as photographs ask for.
    double triangle_error_px = 0.0;
    /// Whether it draws what is thinner over them (DrawingChoices::draws_thin); empty: where
    /// photographs ask for it.
    std::optional<bool> draw_thin;
};

/// Everything that one run of the line is told.
struct BuildConfig {
    std::string name;                            ///< Of the package: NAME.lumi.
    std::filesystem::path photographs_or_video;  ///< A folder, or one video file.
    std::filesystem::path imported_poses;        ///< Empty: poses are estimated.
    std::filesystem::path workspace;             ///< Empty: work/NAME below the current folder.
    int threads = 0;                             ///< 0: all cores.
    std::optional<Camera> given_lens;
    std::filesystem::path boards;  ///< Photographs of a calibration board; empty: none.

    IngestOptions ingest;
    PoseOptions poses;
    CameraMeshOptions mesh;
    DepthOptions depth;
    PackageOptions package;
    DrawingOptions drawing;
    HoldOutOptions hold_out;

    std::string resolved_toml;  ///< The configuration with every default filled in.
    std::string movable_toml;   ///< The same with absolute paths: it says the same in any folder.
    /// Canonical text of what each stage was told ("ingest", "poses", "mesh", "depth", "pack").
    std::map<std::string, std::string> stage_parameters;
};

/// Whether a text can be the name of a configuration, which names folders.
[[nodiscard]] bool is_plain_name(const std::string& name);

/// Reads a configuration file; or, given a folder of photographs or a video (plain_capture.h), the
/// configuration that takes it with every default. Throws Error (E-CONFIG-...) naming file, line
/// and key.
[[nodiscard]] BuildConfig load_build_config(const std::filesystem::path& path);

/// The same from an open document; `default_name` stands in for a missing `name`.
[[nodiscard]] BuildConfig read_build_config(const ConfigSection& document,
                                            const std::string& default_name);

}  // namespace lumi
