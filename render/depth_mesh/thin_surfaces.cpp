#include "render/depth_mesh/thin_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "render/depth_mesh/mesh_decimation.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

/// Of the longer side of the depth map: in a picture of so many pixels triangles are half as long
/// at the shortest, and what is wider is found by some of their corners.
constexpr double kWidestShare = 1.0 / 48;
/// What stands out less may be noise.
constexpr double kLeastOut_px = 16.0;
/// What stands out half as far, and touches that, is of the same thing.
constexpr double kLeastOfThing_px = 0.5 * kLeastOut_px;
/// How far triangles may be from the surface, and their ends from its own, as a share of the longer
/// side of the picture: nobody looks so closely at what is thin, an eighth of the widest.
constexpr double kCoarseShare = kWidestShare / 8;

using Mask = cv::Mat_<std::uint8_t>;

/// Of things, those that are at least so long and that were surely seen somewhere.
Mask long_things(const Mask& things, const Mask& surely, int length) {
    cv::Mat_<int> thing_of;
    cv::Mat_<int> boxes;
    cv::Mat centroids;
    const int count = cv::connectedComponentsWithStats(things, thing_of, boxes, centroids);
    std::vector<char> is_kept(static_cast<std::size_t>(count), 0);
    const auto kept = [&](int thing) -> char& { return is_kept[static_cast<std::size_t>(thing)]; };
    for (int y = 0; y < things.rows; ++y)
        for (int x = 0; x < things.cols; ++x)
            if (surely(y, x) != 0) kept(thing_of(y, x)) = 1;
    for (int thing = 0; thing < count; ++thing)
        if (std::max(boxes(thing, cv::CC_STAT_WIDTH), boxes(thing, cv::CC_STAT_HEIGHT)) < length)
            kept(thing) = 0;
    kept(0) = 0;  // What stands out nowhere.
    Mask mask(things.size());
    for (int y = 0; y < things.rows; ++y)
        for (int x = 0; x < things.cols; ++x) mask(y, x) = kept(thing_of(y, x)) != 0 ? 1 : 0;
    return mask;
}

/// OpenCV has no pictures that cannot be written to; these are not.
template <class Pixel>
cv::Mat_<Pixel> mat_of(const Image<Pixel>& image) {
    return {image.height(), image.width(), const_cast<Pixel*>(image.pixels().data())};
}

/// What stands out of a depth map: where it is thin, and how far, in pixels.
struct Relief {
    Mask thin;
    cv::Mat_<float> height_px;
};

Relief relief_of(const DepthMap& depth, double disparity_px) {
    const cv::Mat_<float> inverse_depth = mat_of(depth.inverse_depth);
    const int longer = std::max(inverse_depth.cols, inverse_depth.rows);
    const int widest = std::max(3, static_cast<int>(kWidestShare * longer) | 1);
    Relief relief;
    cv::morphologyEx(inverse_depth, relief.height_px, cv::MORPH_TOPHAT,
                     cv::getStructuringElement(cv::MORPH_RECT, {widest, widest}), {-1, -1}, 1,
                     cv::BORDER_REPLICATE);
    relief.height_px *= disparity_px;
    Mask things;
    Mask surely;
    cv::compare(relief.height_px, kLeastOfThing_px, things, cv::CMP_GE);
    cv::compare(relief.height_px, kLeastOut_px, surely, cv::CMP_GE);
    surely.setTo(0, mat_of(depth.confidence) == 0);
    relief.thin = long_things(things, surely, widest);
    return relief;
}

/// The vertices of a depth mesh that lie on what is thin.
class ThinVertices {
 public:
    ThinVertices(const LumigraphView& view, double disparity_px)
        : relief_(relief_of(view.depth, disparity_px)),
          inverse_depth_(view.depth.inverse_depth),
          samples_per_px_(
              static_cast<float>(inverse_depth_.width()) / static_cast<float>(view.camera.width_px),
              static_cast<float>(inverse_depth_.height()) /
                  static_cast<float>(view.camera.height_px)),
          least_height_(static_cast<float>(0.5 * kLeastOfThing_px / disparity_px)),
          disparity_px_(static_cast<float>(disparity_px)) {}

    [[nodiscard]] bool are_none() const { return cv::countNonZero(relief_.thin) == 0; }

    /// Vertices lie on the edges between samples: one next to it has to be thin, and the vertex
    /// before what is around that.
    [[nodiscard]] bool contain(const Eigen::Vector3f& vertex) const {
        const Eigen::Vector2f sample = vertex.head<2>().cwiseProduct(samples_per_px_);
        const cv::Rect around =
            cv::Rect(static_cast<int>(sample.x()) - 1, static_cast<int>(sample.y()) - 1, 3, 3) &
            cv::Rect({0, 0}, relief_.thin.size());
        for (int y = around.y; y < around.y + around.height; ++y)
            for (int x = around.x; x < around.x + around.width; ++x)
                if (relief_.thin(y, x) != 0 && vertex.z() > ground_at(x, y) + least_height_)
                    return true;
        return false;
    }

 private:
    /// Inverse depth without what stands out.
    [[nodiscard]] float ground_at(int x, int y) const {
        return inverse_depth_(x, y) - relief_.height_px(y, x) / disparity_px_;
    }

    Relief relief_;
    const FloatImage& inverse_depth_;
    Eigen::Vector2f samples_per_px_;
    float least_height_;
    float disparity_px_;
};

/// The seen triangles that have such a vertex.
DepthMesh part_with(const ThinVertices& vertices, const DepthMesh& mesh) {
    DepthMesh part;
    part.vertices = mesh.vertices;
    const auto seen = mesh.indices.begin() + static_cast<std::ptrdiff_t>(mesh.kind_begin[0]);
    const auto end = mesh.indices.begin() + static_cast<std::ptrdiff_t>(mesh.kind_begin[1]);
    for (auto corner = seen; corner != end; corner += 3)
        if (std::any_of(corner, corner + 3, [&](std::uint32_t index) {
                return vertices.contain(mesh.vertices[index]);
            }))
            part.indices.insert(part.indices.end(), corner, corner + 3);
    std::fill(part.kind_begin.begin() + 1, part.kind_begin.end(), part.indices.size());
    return part;
}

}  // namespace

ThinSurfaces thin_surfaces(const LumigraphView& view, double disparity_px,
                           const DepthMeshOptions& options) {
    if (!view.has_depth()) return {};
    const ThinVertices thin(view, disparity_px);
    if (thin.are_none()) return {};
    const double coarse_px = kCoarseShare * std::max(view.camera.width_px, view.camera.height_px);
    DepthMesh part = decimated(part_with(thin, *depth_mesh_of(view, disparity_px, options)),
                               disparity_px, {.max_error_px = coarse_px, .max_tear_px = coarse_px});
    return {std::move(part.vertices), std::move(part.indices)};
}

}  // namespace lumi
