#include "render/lumigraph/package_memory.h"

#include <unistd.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Bytes that end at the largest number instead of beginning anew.
class Sum {
 public:
    Sum& add(std::uint64_t count, std::uint64_t bytes_of_each = 1) {
        std::uint64_t bytes = 0;
        if (__builtin_mul_overflow(count, bytes_of_each, &bytes) ||
            __builtin_add_overflow(bytes_, bytes, &bytes_))
            bytes_ = UINT64_MAX;
        return *this;
    }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
    std::uint64_t bytes_ = 0;
};

std::uint64_t unsigned_of(int count) { return static_cast<std::uint64_t>(std::max(0, count)); }

std::uint64_t pixels_of(int width_px, int height_px) {
    return unsigned_of(width_px) * unsigned_of(height_px);
}

void add_what_stays(const ManifestView& view, Sum& sum) {
    sum.add(pixels_of(view.camera.width_px, view.camera.height_px), sizeof(Rgb8));
    if (!view.depth) return;
    sum.add(pixels_of(view.depth->width_px, view.depth->height_px),
            sizeof(float) + sizeof(std::uint8_t));
    if (!view.depth->mesh) return;
    const CodedDepthMeshHeader& mesh = view.depth->mesh->header;
    sum.add(unsigned_of(mesh.vertices), sizeof(Eigen::Vector3f));
    for (const int triangles : mesh.triangles)
        sum.add(unsigned_of(triangles), 3 * sizeof(std::uint32_t));
}

/// What a view is decoded from: its photograph's file all the time, beside it files and steps of
/// its depth, and then file and code of its triangles.
std::uint64_t bytes_while_decoding(const ManifestView& view) {
    const std::uint64_t photograph = view.photograph.bytes;
    if (!view.depth) return photograph;
    const ManifestDepth& depth = *view.depth;
    Sum of_depth;
    of_depth.add(photograph).add(depth.inverse_depth.bytes).add(depth.confidence.bytes);
    of_depth.add(pixels_of(depth.width_px, depth.height_px), sizeof(std::uint16_t));
    if (!depth.mesh) return of_depth.bytes();
    Sum of_mesh;
    of_mesh.add(photograph).add(depth.mesh->file.bytes).add(depth.mesh->code_bytes);
    return std::max(of_depth.bytes(), of_mesh.bytes());
}

void expect_few_enough_pixels(int width_px, int height_px, const fs::path& picture) {
    if (pixels_of(width_px, height_px) <= kMaxPixelsPerPicture) return;
    throw Error(ErrorKind::kResources, "E-PACKAGE-BUDGET",
                picture.string() + ": " + std::to_string(width_px) + "x" +
                    std::to_string(height_px) + " pixels, at most " +
                    std::to_string(kMaxPixelsPerPicture) + " are read",
                "build the package from smaller photographs: [capture] max_width_px");
}

std::string gib_text(std::uint64_t bytes) {
    constexpr double kGib = std::uint64_t{1} << 30;
    return formatted("%.2f", static_cast<double>(bytes) / kGib);
}

}  // namespace

std::uint64_t most_memory_of_packages() {
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long page_bytes = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_bytes <= 0) return kLeastMemoryOfPackages;
    return std::max(kLeastMemoryOfPackages, Sum()
                                                .add(static_cast<std::uint64_t>(pages),
                                                     static_cast<std::uint64_t>(page_bytes))
                                                .bytes());
}

std::uint64_t memory_to_read(const Manifest& manifest, int threads) {
    Sum sum;
    std::vector<std::uint64_t> for_a_while;
    for (const PackageFile* file : {&manifest.camera_mesh, &manifest.points, &manifest.config})
        for_a_while.push_back(file->bytes);
    for (const ManifestView& view : manifest.views) {
        add_what_stays(view, sum);
        for_a_while.push_back(bytes_while_decoding(view));
    }
    std::sort(for_a_while.begin(), for_a_while.end(), std::greater<>());
    for_a_while.resize(std::min(for_a_while.size(), static_cast<std::size_t>(threads)));
    for (const std::uint64_t bytes : for_a_while) sum.add(bytes);
    return sum.bytes();
}

void expect_readable(const Manifest& manifest, const fs::path& folder,
                     const PackageLimits& limits) {
    for (const ManifestView& view : manifest.views) {
        expect_few_enough_pixels(view.camera.width_px, view.camera.height_px,
                                 folder / view.photograph.path);
        if (view.depth)
            expect_few_enough_pixels(view.depth->width_px, view.depth->height_px,
                                     folder / view.depth->inverse_depth.path);
    }
    const std::uint64_t bytes = memory_to_read(manifest, resolve_threads(0));
    if (bytes <= limits.max_decoded_bytes) return;
    throw Error(ErrorKind::kResources, "E-PACKAGE-BUDGET",
                folder.string() + ": reading it takes " + gib_text(bytes) +
                    " GiB of memory, expected at most " + gib_text(limits.max_decoded_bytes),
                "build it of fewer views or smaller photographs ([package] max_views, [capture] "
                "max_width_px), or open it on a machine with more memory");
}

}  // namespace lumi
