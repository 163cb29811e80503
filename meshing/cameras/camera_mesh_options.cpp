#include <algorithm>
#include <array>

#include "calib/work/error.h"
#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {
namespace {

constexpr std::array<const char*, 4> kConstructions{"auto", "closed", "open", "line"};
constexpr const char* kExpected = R"("auto", "closed", "open" or "line")";

bool is_known(const std::string& construction) {
    return std::find(kConstructions.begin(), kConstructions.end(), construction) !=
           kConstructions.end();
}

}  // namespace

void validate(const CameraMeshOptions& options) {
    if (is_known(options.construction)) return;
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                "[mesh] construction is \"" + options.construction + "\"",
                std::string("expected ") + kExpected);
}

CameraMeshOptions read_camera_mesh_options(const ConfigSection& section) {
    CameraMeshOptions options;
    options.construction = section.text("construction", options.construction);
    if (!is_known(options.construction)) section.refuse("construction", kExpected);
    return options;
}

}  // namespace lumi
