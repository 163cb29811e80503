#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/config_section.h"
#include "calib/work/progress.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// How depth is found.
struct DepthOptions {
    std::string model = "sweep";  ///< "sparse" or "sweep".
    int max_width_px = 800;       ///< Depth maps are at most this wide.
    int max_neighbours = 4;       ///< Views that one view is compared with.
    /// Depth maps made elsewhere (float TIFF, see imported_depth.h) take the place of `model`.
    std::filesystem::path import_folder = {};
};

void validate(const DepthOptions& options);
[[nodiscard]] DepthOptions read_depth_options(const ConfigSection& section);

/// What speaks for one view's depth.
struct DepthEvidence {
    std::string view_name;
    /// What was used: "sparse" also where the sweep was impossible, "imported" for a folder.
    std::string model;
    double confident_share = 0.0;     ///< Pixels that other views agreed on.
    double sparse_residual_px = 0.0;  ///< Median distance to the sparse points, as disparity.
    double cpu_s = 0.0;
};

struct DepthResult {
    std::vector<DepthMap> depth_maps;  ///< One per entry of `view_indices`.
    std::vector<DepthEvidence> evidence;
};

/// Depth of the listed views, from these views alone: held-out views take no part. The same bytes
/// for any number of threads. Memory is bounded by the views in flight.
[[nodiscard]] DepthResult estimate_depth(const PosedPhotographs& photographs,
                                         const std::vector<int>& view_indices,
                                         const DepthOptions& options, int threads,
                                         Progress& progress);

}  // namespace lumi
