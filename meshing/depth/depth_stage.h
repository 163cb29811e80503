#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/config_section.h"
#include "calib/work/progress.h"
#include "meshing/depth/depth_memory.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// How depth is found.
struct DepthOptions {
    std::string model = "sweep";  ///< One of depth_model_names(), or "auto".
    int max_width_px = 800;       ///< Depth maps are at most this wide.
    int max_neighbours = 4;       ///< Views that one view is compared with.
    /// Fewer views are worked on at one time where the process would take more (MiB).
    int max_memory_mib = 2048;
    /// Depth maps made elsewhere (see imported_depth.h), of the straight pictures that depth is
    /// found from, take the place of `model`.
    std::filesystem::path import_folder = {};
    /// The file of each view, where they were not found there by the views' names.
    std::vector<std::filesystem::path> imported_files = {};
    double import_png_unit = 0.001;  ///< World units a level of a 16-bit PNG stands for. > 0.
    /// A triangle mesh of the scene in the world of the poses (PLY, OBJ) takes the place of
    /// `model`.
    std::filesystem::path import_mesh = {};
    /// So does a volume of solid cells there (NRRD, MetaImage; binary_volume.h).
    std::filesystem::path import_volume = {};
    double import_volume_threshold = 0.5;  ///< Cells of at least this value are solid.
    /// One mask a photograph, by its name (drawn_mask.h): black is not part of the scene.
    std::filesystem::path mask_folder = {};
    /// "auto": a plain background around the scene is found and kept out of it; "keep": never.
    std::string background = "auto";
};

void validate(const DepthOptions& options);
[[nodiscard]] DepthOptions read_depth_options(const ConfigSection& section);

/// What speaks for one view's depth.
struct DepthEvidence {
    std::string view_name;
    /// What was used: "sparse_fill" where photographs could not be compared, "imported" for a
    /// folder.
    std::string model;
    double confident_share = 0.0;     ///< Pixels that other views agreed on.
    double background_share = 0.0;    ///< Pixels that are not part of the scene.
    double sparse_residual_px = 0.0;  ///< Median distance to the sparse points, as disparity.
    double cpu_s = 0.0;
};

struct DepthResult {
    std::vector<DepthMap> depth_maps;  ///< One per entry of `view_indices`.
    std::vector<DepthEvidence> evidence;
    std::string choice;         ///< Of "auto": one line, what was chosen and why; else empty.
    double choice_cpu_s = 0.0;  ///< What choosing took, the model and how the fill recedes.
    /// The colour of the plain background that was kept out of the scene, if there was one.
    std::optional<Rgb8> background;
    /// What makes the depth doubtful, in one line; empty when nothing does. Said as a note, too.
    std::string warning;
    DepthMemory memory;  ///< As it was predicted.
};

/// Depth of the listed views, from these views alone: held-out views take no part. The same bytes
/// for any number of threads. What memory it will take is said first (Progress::note). Throws Error
/// (E-DEPTH-MEMORY) when the machine has not so much left,
/// (E-GEOMETRY-UNSEEN) when no view sees anything of an imported mesh or volume, (E-DEPTH-EMPTY)
/// when no imported depth map knows any depth.
[[nodiscard]] DepthResult estimate_depth(const PosedPhotographs& photographs,
                                         const std::vector<int>& view_indices,
                                         const DepthOptions& options, int threads,
                                         Progress& progress);

}  // namespace lumi
