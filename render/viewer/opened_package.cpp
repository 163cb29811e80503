#include "render/viewer/opened_package.h"

#include <system_error>
#include <utility>

#include "render/lumigraph/manifest.h"

namespace lumi {

std::filesystem::path package_meant_by(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    if (path.filename() == kManifestName) return path.parent_path();
    std::error_code status;
    if (fs::exists(path / kManifestName, status)) return path;
    fs::path only;
    for (fs::directory_iterator entry(path, status), end; !status && entry != end;
         entry.increment(status)) {
        const fs::path& inside = entry->path();
        std::error_code ignored;
        if (inside.extension() != ".lumi" || !fs::exists(inside / kManifestName, ignored)) continue;
        if (!only.empty()) return path;
        only = inside;
    }
    return only.empty() ? path : only;
}

OpenedPackage opened_alone(const std::filesystem::path& package, Exposures exposures) {
    Lumigraph lumigraph = read_package(package, {}, exposures);
    const bool fades = lumigraph.drawing.fade_beyond_capture;
    return {std::move(lumigraph), fades};
}

}  // namespace lumi
