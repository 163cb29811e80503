#include "pipeline/config/lens_file.h"

#include <sstream>

namespace lumi {

std::string lens_parameters_text(const std::optional<Camera>& lens) {
    if (!lens) return {};
    std::ostringstream text;
    text << name_of(lens->model) << ' ' << lens->width_px << ' ' << lens->height_px
         << std::hexfloat;
    for (const double parameter : lens->parameters) text << ' ' << parameter;
    return text.str();
}

}  // namespace lumi
