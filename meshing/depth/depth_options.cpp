#include <algorithm>
#include <cmath>

#include "calib/work/error.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/depth_stage.h"

namespace lumi {
namespace {

void require(bool holds, const std::string& what) {
    if (holds) return;
    throw Error(ErrorKind::kUsage, "E-DEPTH-OPTION", "depth: " + what,
                "correct the [depth] section of the configuration");
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
    return text;
}

}  // namespace

void validate(const DepthOptions& options) {
    std::vector<std::string> names = depth_model_names();
    names.insert(names.begin(), "auto");
    require(std::find(names.begin(), names.end(), options.model) != names.end(),
            "model: expected one of " + listed(names) + ", found \"" + options.model + "\"");
    require(options.max_width_px >= 16 && options.max_width_px <= 16384,
            "max_width_px: expected 16 to 16384, found " + std::to_string(options.max_width_px));
    require(options.max_neighbours >= 1 && options.max_neighbours <= 32,
            "max_neighbours: expected 1 to 32, found " + std::to_string(options.max_neighbours));
    require(options.max_memory_mib >= 256, "max_memory_mib: expected at least 256, found " +
                                               std::to_string(options.max_memory_mib));
    require(std::isfinite(options.import_png_unit) && options.import_png_unit > 0,
            "import_png_unit: expected a positive length, found " +
                std::to_string(options.import_png_unit));
    require(options.background == "auto" || options.background == "keep",
            "background: expected \"auto\" or \"keep\", found \"" + options.background + "\"");
    const int imports = static_cast<int>(!options.import_folder.empty()) +
                        static_cast<int>(!options.import_mesh.empty()) +
                        static_cast<int>(!options.import_volume.empty());
    require(imports <= 1, "import_folder, import_mesh, import_volume: expected one, found " +
                              std::to_string(imports));
    require(std::isfinite(options.import_volume_threshold),
            "import_volume_threshold: expected a finite number");
}

DepthOptions read_depth_options(const ConfigSection& section) {
    DepthOptions options;
    options.model = section.text("model", options.model);
    options.max_width_px = section.integer("max_width_px", options.max_width_px);
    options.max_neighbours = section.integer("max_neighbours", options.max_neighbours);
    options.max_memory_mib = section.integer("max_memory_mib", options.max_memory_mib);
    options.import_folder = section.path("import_folder");
    options.import_png_unit = section.number("import_png_unit", options.import_png_unit);
    options.import_mesh = section.path("import_mesh");
    options.import_volume = section.path("import_volume");
    options.import_volume_threshold =
        section.number("import_volume_threshold", options.import_volume_threshold);
    options.mask_folder = section.path("masks");
    options.background = section.text("background", options.background);
    validate(options);
    return options;
}

}  // namespace lumi
