#include "render/subdivision/adaptive_subdivision.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "calib/work/parallel_for.h"
#include "render/depth_search/relaxation_search.h"
#include "render/subdivision/adaptive_part.h"
#include "render/subdivision/coarse_triangles.h"

namespace lumi {
namespace {

/// What the edges that parts share cost is hardly noticed, and there are enough parts for all
/// cores to be busy. The same number on every machine, so that all draw the same triangles.
constexpr std::size_t kMostParts = 16;
constexpr std::size_t kFewestOfPart = 8;

/// Triangles that are cut at outlines need not be as small as those that could but follow them.
constexpr double kCutEdges = 2.0;

/// What an edge's middle is off grows with the square of its length: where larger errors are
/// allowed than usual, shorter edges than these bring nothing.
double shortest_edge_px(double usual_px, double error_px) {
    return usual_px * std::sqrt(std::max(1.0, error_px / kTriangleError_px));
}

}  // namespace

AdaptiveSubdivisionOptions subdivision_options(const Lumigraph& lumigraph,
                                               const RenderOptions& options) {
    const double error_px = options.triangle_error_ratio * lumigraph.drawing.triangle_error_px;
    const double samples = samples_along_pixel(options);
    return {
        .max_error_px = error_px,
        .min_edge_px = samples * shortest_edge_px(kCutEdges * options.min_triangle_px, error_px),
        .max_edge_px = samples * options.max_triangle_px,
        .max_triangles = options.max_triangles};
}

/// The polygons of one picture in parts, each of which is subdivided on one thread.
class AdaptiveSubdivider::Parts {
 public:
    void begin(const std::vector<FacePolygon>& polygons, const DepthSearch& search,
               const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
               AdaptiveSubdivisionOptions options, const OutlineCells& outlines) {
        if (!search.has_depth()) options.counts.guess_ratio = 1.0;
        samplers_.clear();
        for (const FacePolygon& polygon : polygons)
            samplers_.emplace_back(polygon, search, scene_plane, sampling);
        const CoarseTriangles coarse = coarse_triangles(polygons, options.max_edge_px);
        const std::size_t count = coarse.triangles.size();
        used_ = std::clamp<std::size_t>(count / kFewestOfPart, 1, kMostParts);
        parts_.resize(std::max(parts_.size(), used_));
        for_each([&](std::size_t i) {
            parts_[i].begin(coarse, i * count / used_, (i + 1) * count / used_, samplers_, outlines,
                            options);
        });
    }

    /// The number of triangles with errors relaxed so much; nothing, and what was found before
    /// stays, where they are more than `most`. To be called for lesser and lesser relaxations once
    /// it gave a number.
    [[nodiscard]] std::optional<std::size_t> subdivide(float relaxation, std::size_t most) {
        std::atomic<std::size_t> count = 0;
        for_each([&](std::size_t i) { parts_[i].subdivide(relaxation, most, count); });
        if (count > most) return std::nullopt;
        for (std::size_t i = 0; i < used_; ++i) parts_[i].keep();
        return count;
    }

    /// The triangles that were found last, and the vertices that they name. To be called once.
    [[nodiscard]] BlendTriangles triangles() {
        for_each([&](std::size_t i) { parts_[i].leave_out_hidden(); });
        std::size_t count = 0;
        for (std::size_t i = 0; i < used_; ++i) count += parts_[i].count();
        BlendTriangles drawn;
        drawn.indices.reserve(3 * count);
        drawn.vertices.reserve(count);  // Neighbours share them: half would mostly do.
        for (std::size_t i = 0; i < used_; ++i) parts_[i].append_to(drawn);
        return drawn;
    }

 private:
    template <class Body>
    void for_each(const Body& body) {
        parallel_for(static_cast<int>(used_), 0, [&](int i) { body(static_cast<std::size_t>(i)); });
    }

    std::vector<PatchSampler> samplers_;  ///< One a polygon.
    std::vector<AdaptivePart> parts_;
    std::size_t used_ = 0;  ///< The first ones; the others keep their memory.
};

AdaptiveSubdivider::AdaptiveSubdivider() : parts_(std::make_unique<Parts>()) {}
AdaptiveSubdivider::~AdaptiveSubdivider() = default;
AdaptiveSubdivider::AdaptiveSubdivider(AdaptiveSubdivider&&) noexcept = default;
AdaptiveSubdivider& AdaptiveSubdivider::operator=(AdaptiveSubdivider&&) noexcept = default;

AdaptiveSubdivision AdaptiveSubdivider::subdivide(const std::vector<FacePolygon>& polygons,
                                                  const DepthSearch& search,
                                                  const Eigen::Vector3d& scene_plane,
                                                  const PatchSampler::Options& sampling,
                                                  const AdaptiveSubdivisionOptions& options,
                                                  const OutlineCells& outlines) {
    parts_->begin(polygons, search, scene_plane, sampling, options, outlines);
    AdaptiveSubdivision result;
    result.relaxation =
        least_relaxation(options.max_triangles, [&](double relaxation, std::size_t most) {
            return parts_->subdivide(static_cast<float>(relaxation), most);
        });
    result.triangles = parts_->triangles();
    return result;
}

AdaptiveSubdivision adaptive_subdivision(const std::vector<FacePolygon>& polygons,
                                         const DepthSearch& search,
                                         const Eigen::Vector3d& scene_plane,
                                         const PatchSampler::Options& sampling,
                                         const AdaptiveSubdivisionOptions& options) {
    return AdaptiveSubdivider().subdivide(polygons, search, scene_plane, sampling, options);
}

}  // namespace lumi
