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

/// The first file there whose name is one of these with one of the endings of depth maps, by
/// endings before names; else empty.
fs::path file_named(const std::vector<fs::path>& without_ending) {
    for (const std::string& ending : depth_file_endings()) {
        for (const std::string& written : {ending, upper_case(ending)}) {
            for (fs::path file : without_ending) {
                file += written;
                std::error_code status;  // Names may be too long for a file system.
                if (fs::is_regular_file(file, status)) return file;
            }
        }
    }
    return {};
}

fs::path stem_of(const std::string& name) { return fs::path(name).replace_extension(); }

/// Of other views, those that have the same stem.
std::vector<std::string> names_of_same_stem(const std::vector<std::string>& names,
                                            std::size_t index) {
    std::vector<std::string> same;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i != index && stem_of(names[i]) == stem_of(names[index])) same.push_back(names[i]);
    }
    return same;
}

/// The file of a view whose stem others have, too: by its whole name, or where they have files of
/// that kind.
fs::path file_beside_others(const std::string& name, const std::vector<std::string>& others,
                            const fs::path& folder) {
    if (fs::path own = file_named({folder / name}); !own.empty()) return own;
    const fs::path by_stem = folder / stem_of(name);
    fs::path file = file_named({by_stem});
    if (file.empty()) return file;
    for (const std::string& other : others) {
        if (!file_named({folder / other}).empty()) continue;
        throw Error(ErrorKind::kBadInput, "E-DEPTH-SHARED",
                    file.string() + " may be the depth map of " + name + " or of " + other,
                    "name depth maps like " + name + file.string().substr(by_stem.string().size()));
    }
    return file;
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
    const std::string& name = names[index];
    const std::vector<std::string> others = names_of_same_stem(names, index);
    fs::path file = others.empty() ? file_named({folder / stem_of(name), folder / name})
                                   : file_beside_others(name, others, folder);
    if (!file.empty()) return file;
    throw Error(ErrorKind::kBadInput, "E-DEPTH-MISSING",
                folder.string() + ": no depth map for view " + name,
                "name depth maps like their photographs, with .tiff, .tif, .exr, .pfm, .png, "
                ".geometric.bin or .photometric.bin as extension");
}

std::vector<fs::path> imported_depth_files(const std::vector<std::string>& names,
                                           const fs::path& folder) {
    std::vector<fs::path> files;
    for (std::size_t i = 0; i < names.size(); ++i)
        files.push_back(imported_depth_file(names, i, folder));
    return files;
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
            map.confidence(x, y) = kKnown;
        }
    }
    return map;
}

}  // namespace lumi
