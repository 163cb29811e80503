#include <filesystem>

#include "calib/capture/image_io.h"
#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/surface/mesh_io.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/quantised_depth.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& code, const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, code, path.string() + ": " + what,
                "the package is damaged; copy or build it again");
}

/// The file's place on disk, after making sure that it is a plain file reached without a link and
/// that its length and checksum are those of the manifest.
fs::path checked_file(const fs::path& root, const PackageFile& file) {
    fs::path path = root;
    for (const fs::path& part : fs::path(file.path)) {
        path /= part;
        if (fs::is_symlink(fs::symlink_status(path))) {
            refuse("E-PACKAGE-PATH", path, "is a link; packages hold plain files");
        }
    }
    if (!fs::is_regular_file(path)) refuse("E-PACKAGE-FILE", path, "is missing");
    if (fs::file_size(path) != file.bytes) {
        refuse("E-PACKAGE-FILE", path,
               "is " + std::to_string(fs::file_size(path)) + " bytes long, expected " +
                   std::to_string(file.bytes));
    }
    if (sha256_hex_of_file(path) != file.sha256) {
        refuse("E-PACKAGE-CHECKSUM", path, "is not the file that was written");
    }
    return path;
}

/// Counts decoded bytes before anything is decoded.
class DecodingBudget {
 public:
    explicit DecodingBudget(std::uint64_t bytes) : left_(bytes) {}

    void spend(int width_px, int height_px, std::uint64_t bytes_per_pixel, const fs::path& path) {
        const std::uint64_t bytes = static_cast<std::uint64_t>(width_px) *
                                    static_cast<std::uint64_t>(height_px) * bytes_per_pixel;
        if (bytes > left_) {
            throw Error(ErrorKind::kResources, "E-PACKAGE-BUDGET",
                        path.string() + ": decoding it would exceed the memory that is allowed",
                        "use a smaller package, or raise the limit");
        }
        left_ -= bytes;
    }

 private:
    std::uint64_t left_;
};

/// The picture's header must state the size that the manifest states, before it is decoded.
void expect_size(const fs::path& path, int width_px, int height_px) {
    const ImageSize size = read_image_size(path);
    if (size.width_px == width_px && size.height_px == height_px) return;
    refuse("E-PACKAGE-SIZE", path,
           "is " + std::to_string(size.width_px) + "x" + std::to_string(size.height_px) +
               ", expected " + std::to_string(width_px) + "x" + std::to_string(height_px));
}

DepthMap read_depth(const fs::path& root, const ManifestView& entry) {
    const fs::path steps = checked_file(root, entry.inverse_depth);
    const fs::path confidence = checked_file(root, entry.confidence);
    expect_size(steps, entry.depth_width_px, entry.depth_height_px);
    expect_size(confidence, entry.depth_width_px, entry.depth_height_px);
    DepthMap depth;
    depth.inverse_depth =
        dequantise({read_gray16_png(steps), entry.min_inverse_depth, entry.max_inverse_depth});
    depth.confidence = read_gray_png(confidence);
    return depth;
}

LumigraphView read_view(const fs::path& root, const ManifestView& entry) {
    LumigraphView view;
    view.name = entry.name;
    view.camera = entry.camera;
    view.cam_from_world = entry.cam_from_world;
    view.exif_orientation = entry.exif_orientation;
    const fs::path photograph = checked_file(root, entry.photograph);
    expect_size(photograph, entry.camera.width_px, entry.camera.height_px);
    view.photograph = read_color_image(photograph);
    if (entry.has_depth) view.depth = read_depth(root, entry);
    return view;
}

void spend_on_all_views(const Manifest& manifest, const fs::path& root, DecodingBudget& budget) {
    constexpr std::uint64_t kColorBytes = sizeof(Rgb8);
    constexpr std::uint64_t kDepthBytes = sizeof(float) + 1;
    for (const ManifestView& view : manifest.views) {
        budget.spend(view.camera.width_px, view.camera.height_px, kColorBytes,
                     root / view.photograph.path);
        budget.spend(view.depth_width_px, view.depth_height_px, kDepthBytes,
                     root / view.inverse_depth.path);
    }
}

}  // namespace

Lumigraph read_package(const fs::path& folder, const PackageLimits& limits) {
    const fs::path manifest_path = folder / "lumigraph.json";
    if (!fs::is_regular_file(fs::symlink_status(manifest_path))) {
        refuse("E-PACKAGE-MANIFEST", manifest_path, "is missing: this folder is not a package");
    }
    const Manifest manifest =
        parse_manifest(read_whole_text(manifest_path, limits.max_manifest_bytes),
                       limits.max_json_depth, limits.max_views);
    DecodingBudget budget(limits.max_decoded_bytes);
    spend_on_all_views(manifest, folder, budget);

    Lumigraph lumigraph;
    lumigraph.name = manifest.name;
    lumigraph.near_depth = manifest.near_depth;
    lumigraph.far_depth = manifest.far_depth;
    lumigraph.mesh = read_camera_mesh_ply(checked_file(folder, manifest.camera_mesh));
    validate(lumigraph.mesh, static_cast<int>(manifest.views.size()), folder.string());
    for (const ManifestView& entry : manifest.views) {
        lumigraph.views.push_back(read_view(folder, entry));
    }
    return lumigraph;
}

}  // namespace lumi
