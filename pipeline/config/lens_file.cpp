#include "pipeline/config/lens_file.h"

#include <sstream>

#include "calib/work/config_section.h"

namespace lumi {

Camera read_lens_file(const std::filesystem::path& path) {
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

std::string lens_parameters_text(const std::optional<Camera>& lens) {
    if (!lens) return {};
    std::ostringstream text;
    text << name_of(lens->model) << ' ' << lens->width_px << ' ' << lens->height_px
         << std::hexfloat;
    for (const double parameter : lens->parameters) text << ' ' << parameter;
    return text.str();
}

}  // namespace lumi
