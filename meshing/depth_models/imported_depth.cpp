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

fs::path depth_file_of(const DepthView& view, const fs::path& folder) {
    const fs::path whole_name = folder / view.name;
    const fs::path stem = fs::path(whole_name).replace_extension();
    for (const std::string& ending : depth_file_endings()) {
        for (const std::string& written : {ending, upper_case(ending)}) {
            for (fs::path file : {stem, whole_name}) {
                file += written;
                if (fs::is_regular_file(file)) return file;
            }
        }
    }
    throw Error(
        ErrorKind::kBadInput, "E-DEPTH-MISSING",
        folder.string() + ": no depth map for view " + view.name,
        "name depth maps like their photographs, with .tiff, .exr, .pfm or .png as extension");
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

}  // namespace

DepthMap imported_depth(const DepthView& view, const fs::path& folder, double png_unit) {
    const fs::path path = depth_file_of(view, folder);
    const FloatImage depth = read_depth_file(path, png_unit);
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    check_size(depth, view.camera, path);
    DepthMap map{FloatImage(width, height), GrayImage(width, height)};
    for (int y = 0; y < height; ++y) {
        const auto source_y = static_cast<int>((y + 0.5) * depth.height() / height);
        for (int x = 0; x < width; ++x) {
            const auto source_x = static_cast<int>((x + 0.5) * depth.width() / width);
            const float z = depth(source_x, source_y);
            if (z < 0) {
                throw Error(ErrorKind::kBadInput, "E-DEPTH-VALUE",
                            path.string() + ": negative depth at pixel " +
                                std::to_string(source_x) + ", " + std::to_string(source_y),
                            "depth is positive along the viewing direction; 0 means unknown");
            }
            const float inverse_depth = 1.0F / z;
            if (!std::isfinite(inverse_depth)) continue;  // Unknown: z is 0, tiny or NaN.
            map.inverse_depth(x, y) = inverse_depth;
            map.confidence(x, y) = 255;
        }
    }
    return map;
}

}  // namespace lumi
