#include "calib/lens_files/lens_readers.h"
#include "calib/work/config_section.h"

namespace lumi {

Camera read_lens_toml(const std::filesystem::path& path) {
    const ConfigSection section = ConfigSection::from_file(path);
    Camera lens;
    const auto model = lens_model_named(section.text("model", "PINHOLE"));
    if (!model) section.refuse("model", "one of COLMAP's lens models, such as \"SIMPLE_RADIAL\"");
    lens.model = *model;
    lens.width_px = section.integer("width_px", 0);
    lens.height_px = section.integer("height_px", 0);
    lens.parameters = section.numbers("parameters", {});
    section.expect_all_keys_known();

    if (lens.width_px <= 0) section.refuse("width_px", "the width the lens was calibrated for");
    if (lens.height_px <= 0) section.refuse("height_px", "the height the lens was calibrated for");
    if (lens.parameters.size() != parameter_count(lens.model)) {
        section.refuse("parameters", std::to_string(parameter_count(lens.model)) + " numbers for " +
                                         std::string(name_of(lens.model)));
    }
    validate(lens, path.string());
    return lens;
}

}  // namespace lumi
