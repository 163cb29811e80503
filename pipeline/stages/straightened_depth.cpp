#include "pipeline/stages/straightened_depth.h"

#include <algorithm>
#include <string>
#include <vector>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth_models/imported_depth.h"
#include "meshing/surface/file_ending.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/straightened_raster.h"
#include "pipeline/stages/used_views.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// COLMAP finds dense depth in pictures that it straightened before.
void expect_of_bent_picture(const fs::path& file) {
    if (lower_case_ending(file) != ".bin") return;
    throw Error(ErrorKind::kBadInput, "E-DEPTH-UNDISTORTED",
                file.string() +
                    ": COLMAP's dense maps are of its undistorted pictures, not of "
                    "photographs as their lens bent them",
                "give COLMAP's undistorted pictures as photographs, with their model as [capture] "
                "import");
}

}  // namespace

std::vector<fs::path> straighten_depth(const ImportedDepthMaps& imported, const Capture& pinholes,
                                       const fs::path& poses_folder, const fs::path& folder,
                                       int threads, Progress& progress) {
    const std::vector<std::string> names = view_names(pinholes);
    std::vector<fs::path> files = imported_depth_files(names, imported.folder);
    const Capture lenses = read_colmap_model(poses_folder / "sparse");
    if (std::all_of(lenses.cameras.begin(), lenses.cameras.end(), is_pinhole)) return files;
    const std::vector<std::string> stems = file_stems_of_views(names);
    progress.note("depth: imported maps are straightened as their photographs are");
    progress.begin("straightening depth maps", names.size());
    parallel_for(static_cast<int>(names.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        const Camera& lens = camera_of_view(lenses, names[index]);
        if (!is_pinhole(lens)) expect_of_bent_picture(files[index]);
        const FloatImage depth = read_imported_depth(files[index], lens, imported.png_unit);
        files[index] = folder / (stems[index] + ".tiff");
        write_float_tiff(files[index],
                         straightened(depth, lens, camera_of(pinholes, pinholes.views[index])));
        progress.advance();
    });
    return files;
}

}  // namespace lumi
