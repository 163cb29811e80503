#include "pipeline/stages/straightened_depth.h"

#include <algorithm>
#include <string>
#include <vector>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth_models/imported_depth.h"
#include "pipeline/stages/straightened_raster.h"
#include "pipeline/stages/used_views.h"

namespace lumi {

namespace fs = std::filesystem;

fs::path straighten_depth(const ImportedDepthMaps& imported, const Capture& pinholes,
                          const fs::path& poses_folder, const fs::path& folder, int threads,
                          Progress& progress) {
    const Capture lenses = read_colmap_model(poses_folder / "sparse");
    if (std::all_of(lenses.cameras.begin(), lenses.cameras.end(), is_pinhole))
        return imported.folder;
    const std::vector<std::string> names = view_names(pinholes);
    progress.begin("straightening depth maps", names.size());
    parallel_for(static_cast<int>(names.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        const Camera& lens = camera_of_view(lenses, names[index]);
        const FloatImage depth = read_imported_depth(
            imported_depth_file(names, index, imported.folder), lens, imported.png_unit);
        write_float_tiff(folder / (names[index] + ".tiff"),
                         straightened(depth, lens, camera_of(pinholes, pinholes.views[index])));
        progress.advance();
    });
    return folder;
}

}  // namespace lumi
