#include "render/viewer/opened_package.h"

#include <utility>

namespace lumi {

OpenedPackage opened_alone(const std::filesystem::path& package, Exposures exposures) {
    Lumigraph lumigraph = read_package(package, {}, exposures);
    const bool fades = lumigraph.drawing.fade_beyond_capture;
    return {std::move(lumigraph), fades};
}

}  // namespace lumi
