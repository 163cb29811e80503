#include <algorithm>
#include <cmath>
#include <optional>

#include "calib/work/error.h"
#include "meshing/depth/depth_stage.h"
#include "meshing/depth_models/depth_model.h"

namespace lumi {
namespace {

struct DepthFault {
    std::string option;
    std::string expected;
};

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
    return text;
}

std::optional<DepthFault> first_fault(const DepthOptions& options) {
    std::vector<std::string> names = depth_model_names();
    names.insert(names.begin(), "auto");
    if (std::find(names.begin(), names.end(), options.model) == names.end())
        return DepthFault{"model", "one of " + listed(names)};
    if (options.max_width_px < 16 || options.max_width_px > 16384)
        return DepthFault{"max_width_px", "16 to 16384"};
    if (options.max_neighbours < 1 || options.max_neighbours > 32)
        return DepthFault{"max_neighbours", "1 to 32"};
    if (options.max_memory_mib < 256) return DepthFault{"max_memory_mib", "at least 256"};
    if (!std::isfinite(options.import_png_unit) || options.import_png_unit <= 0)
        return DepthFault{"import_png_unit", "a positive length"};
    if (options.background != "auto" && options.background != "keep")
        return DepthFault{"background", R"("auto" or "keep")"};
    const int imports = static_cast<int>(!options.import_folder.empty()) +
                        static_cast<int>(!options.import_mesh.empty()) +
                        static_cast<int>(!options.import_volume.empty());
    if (imports > 1) {
        return DepthFault{options.import_volume.empty() ? "import_mesh" : "import_volume",
                          "one of import_folder, import_mesh and import_volume"};
    }
    if (!std::isfinite(options.import_volume_threshold))
        return DepthFault{"import_volume_threshold", "a finite number"};
    return std::nullopt;
}

}  // namespace

void validate(const DepthOptions& options) {
    if (const auto fault = first_fault(options)) {
        throw Error(ErrorKind::kUsage, "E-DEPTH-OPTION",
                    "[depth] " + fault->option + ": expected " + fault->expected,
                    "correct this key, or remove it to use the default");
    }
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
    if (const auto fault = first_fault(options)) section.refuse(fault->option, fault->expected);
    return options;
}

}  // namespace lumi
