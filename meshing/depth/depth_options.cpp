#include "calib/work/error.h"
#include "meshing/depth/depth_stage.h"

namespace lumi {
namespace {

void require(bool holds, const std::string& what) {
    if (holds) return;
    throw Error(ErrorKind::kUsage, "E-DEPTH-OPTION", "depth: " + what,
                "correct the [depth] section of the configuration");
}

}  // namespace

void validate(const DepthOptions& options) {
    require(options.model == "sparse" || options.model == "sweep",
            "model: expected \"sparse\" or \"sweep\", found \"" + options.model + "\"");
    require(options.max_width_px >= 16 && options.max_width_px <= 16384,
            "max_width_px: expected 16 to 16384, found " + std::to_string(options.max_width_px));
    require(options.max_neighbours >= 1 && options.max_neighbours <= 32,
            "max_neighbours: expected 1 to 32, found " + std::to_string(options.max_neighbours));
}

DepthOptions read_depth_options(const ConfigSection& section) {
    DepthOptions options;
    options.model = section.text("model", options.model);
    options.max_width_px = section.integer("max_width_px", options.max_width_px);
    options.max_neighbours = section.integer("max_neighbours", options.max_neighbours);
    options.import_folder = section.path("import_folder");
    validate(options);
    return options;
}

}  // namespace lumi
