#include <algorithm>
#include <array>

#include "calib/work/error.h"
#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {
namespace {

constexpr std::array<const char*, 5> kConstructions{"auto", "closed", "open", "line", "nearest"};
constexpr const char* kExpected = R"("auto", "closed", "open", "line" or "nearest")";

constexpr std::array<const char*, 2> kShapes{"star", "convex"};
constexpr const char* kExpectedShape = R"("star" or "convex")";

template <std::size_t count>
bool is_known(const std::array<const char*, count>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void refuse(const std::string& key, const std::string& value, const std::string& expected) {
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE", "[mesh] " + key + " is \"" + value + "\"",
                "expected " + expected);
}

}  // namespace

void validate(const CameraMeshOptions& options) {
    if (!is_known(kConstructions, options.construction)) {
        refuse("construction", options.construction, kExpected);
    }
    if (!is_known(kShapes, options.shape)) refuse("shape", options.shape, kExpectedShape);
}

CameraMeshOptions read_camera_mesh_options(const ConfigSection& section) {
    CameraMeshOptions options;
    options.construction = section.text("construction", options.construction);
    options.shape = section.text("shape", options.shape);
    options.repair = section.boolean("repair", options.repair);
    options.shells = section.boolean("shells", options.shells);
    if (!is_known(kConstructions, options.construction)) section.refuse("construction", kExpected);
    if (!is_known(kShapes, options.shape)) section.refuse("shape", kExpectedShape);
    return options;
}

}  // namespace lumi
