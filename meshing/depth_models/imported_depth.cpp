#include "meshing/depth_models/imported_depth.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "calib/work/error.h"
#include "meshing/depth_models/depth_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// The first file there whose name is this with one of the endings of depth maps; else empty.
fs::path file_named(const fs::path& without_ending) {
    for (const std::string& ending : depth_file_endings()) {
        for (const std::string& written : {ending, upper_case(ending)}) {
            fs::path file = without_ending;
            file += written;
            if (fs::is_regular_file(file)) return file;
        }
    }
    return {};
}

fs::path stem_of(const std::string& name) { return fs::path(name).replace_extension(); }

/// Other views that have the same stem must have files of their own.
void require_own_stem(const std::vector<std::string>& names, std::size_t index,
                      const fs::path& folder, const fs::path& file) {
    const fs::path stem = stem_of(names[index]);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i == index || stem_of(names[i]) != stem) continue;
        if (!file_named(folder / names[i]).empty()) continue;
        throw Error(
            ErrorKind::kBadInput, "E-DEPTH-SHARED",
            file.string() + " may be the depth map of " + names[index] + " or of " + names[i],
            "name depth maps like " + names[index] + file.extension().string());
    }
}

void check_size(const FloatImage& depth, const Camera& camera, const fs::path& path) {
    const double stretch = static_cast<double>(depth.width()) * camera.height_px /
                           (static_cast<double>(depth.height()) * camera.width_px);
    // Rounding of the smaller side to whole pixels.
    const double tolerance =
        1.0 / std::min({depth.width(), depth.height(), camera.width_px, camera.height_px});
    if (std::abs(stretch - 1) <= tolerance) return;
    throw Error(ErrorKind::kBadInput, "E-DEPTH-SIZE",
                path.string() + ": " + std::to_string(depth.width()) + "x" +
                    std::to_string(depth.height()) + " has not the shape of its photograph",
                "export depth maps of the whole photograph, without borders");
}

void require_depths(const FloatImage& depth, const fs::path& path) {
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (!(depth(x, y) < 0)) continue;
            throw Error(ErrorKind::kBadInput, "E-DEPTH-VALUE",
                        path.string() + ": negative depth at pixel " + std::to_string(x) + ", " +
                            std::to_string(y),
                        "depth is positive along the viewing direction; 0 means unknown");
        }
    }
}

}  // namespace

fs::path imported_depth_file(const std::vector<std::string>& names, std::size_t index,
                             const fs::path& folder) {
    fs::path file = file_named(folder / names[index]);
    if (!file.empty()) return file;
    file = file_named(folder / stem_of(names[index]));
    if (file.empty()) {
        throw Error(ErrorKind::kBadInput, "E-DEPTH-MISSING",
                    folder.string() + ": no depth map for view " + names[index],
                    "name depth maps like their photographs, with .tiff, .tif, .exr, .pfm, .png, "
                    ".geometric.bin or .photometric.bin as extension");
    }
    require_own_stem(names, index, folder, file);
    return file;
}

FloatImage read_imported_depth(const fs::path& file, const Camera& camera, double png_unit) {
    FloatImage depth = read_depth_file(file, png_unit);
    check_size(depth, camera, file);
    require_depths(depth, file);
    return depth;
}

DepthMap imported_depth(const DepthView& view, const fs::path& file, double png_unit) {
    const FloatImage depth = read_imported_depth(file, view.camera, png_unit);
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    DepthMap map{FloatImage(width, height), GrayImage(width, height)};
    for (int y = 0; y < height; ++y) {
        const auto source_y = static_cast<int>((y + 0.5) * depth.height() / height);
        for (int x = 0; x < width; ++x) {
            const auto source_x = static_cast<int>((x + 0.5) * depth.width() / width);
            const float inverse_depth = 1.0F / depth(source_x, source_y);
            if (!std::isfinite(inverse_depth)) continue;  // Unknown: z is 0, tiny or NaN.
            map.inverse_depth(x, y) = inverse_depth;
            map.confidence(x, y) = 255;
        }
    }
    return map;
}

}  // namespace lumi
