#include "meshing/fusion/surface_points.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "meshing/fusion/surface_grid.h"
#include "meshing/surface/depth_map.h"
#include "meshing/warp/parallax.h"
#include "meshing/warp/pixel_in_picture.h"
#include "meshing/warp/round_trip.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxNeighbours = 8;
constexpr double kMinCosine = 0.17;  // A slant of 80 degrees.

/// The camera of a view's depth map.
Camera depth_camera(const PicturedView& view) {
    const FloatImage& inverse_depth = view.depth->inverse_depth;
    return resized(view.camera, inverse_depth.width(), inverse_depth.height());
}

struct Neighbour {
    const DepthMap* depth = nullptr;
    RoundTrip trip;         ///< From the view whose neighbour it is.
    double distance = 0.0;  ///< Between the cameras, world units.
};

/// Of those that have parallax.
std::vector<Neighbour> nearest_neighbours(const std::vector<PicturedView>& views,
                                          std::size_t index) {
    const Eigen::Vector3d centre = centre_in_world(views[index].cam_from_world);
    const auto distance = [&](std::size_t other) {
        return (centre_in_world(views[other].cam_from_world) - centre).norm();
    };
    std::vector<std::size_t> others(views.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    std::erase_if(others, [&](std::size_t other) {
        return other == index || views[other].depth->inverse_depth.empty();
    });
    std::stable_sort(others.begin(), others.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    others.resize(std::min(others.size(), 2 * kMaxNeighbours));
    std::vector<double> distances;
    for (const std::size_t other : others) distances.push_back(distance(other));
    std::vector<Neighbour> neighbours;
    const Camera own = depth_camera(views[index]);
    for (const std::size_t k : with_parallax(distances, kMaxNeighbours)) {
        const std::size_t other = others[k];
        const Camera camera = depth_camera(views[other]);
        neighbours.push_back(
            {views[other].depth,
             round_trip({own, views[index].cam_from_world}, {camera, views[other].cam_from_world}),
             distances[k]});
    }
    return neighbours;
}

enum class Vote { kNone, kAgrees, kSeesThrough };

struct Answer {
    Vote vote = Vote::kNone;
    double inverse_depth = 0.0;  ///< By the neighbour, as the asking view would see it.
};

Answer answer_of(const Neighbour& neighbour, const Eigen::Vector2d& pixel, double inverse_depth) {
    const auto there = neighbour.trip.there.at(pixel, inverse_depth);
    const GrayImage& confidence = neighbour.depth->confidence;
    const auto place = pixel_in_picture(there, confidence.width(), confidence.height());
    if (!place || !was_seen(confidence(place->x(), place->y()))) return {};
    const auto found = static_cast<double>(neighbour.depth->inverse_depth(place->x(), place->y()));
    const auto returned = neighbour.trip.returned(pixel, there->pixel, found);
    constexpr double kTolerancePx = 1.0;
    if (returned && returned->error_px <= kTolerancePx) {
        return {Vote::kAgrees, returned->inverse_depth};
    }
    return {found < there->inverse_depth ? Vote::kSeesThrough : Vote::kNone, 0.0};
}

/// Takes the samples of one view.
class ViewSampler {
 public:
    ViewSampler(const PicturedView& view, const std::vector<Neighbour>& neighbours,
                int min_agreeing)
        : view_(view),
          camera_(depth_camera(view)),
          world_from_cam_(inverse(view.cam_from_world)),
          neighbours_(neighbours),
          min_agreeing_(min_agreeing) {}

    [[nodiscard]] int height() const { return camera_.height_px; }

    void sample_row(int y, std::vector<SurfaceSample>& samples, std::uint64_t& confident) const {
        const DepthMap& map = *view_.depth;
        for (int x = 0; x < camera_.width_px; ++x) {
            if (map.confidence(x, y) < kConfirmedByOne || map.inverse_depth(x, y) <= 0) continue;
            ++confident;
            const auto inverse_depth =
                agreed({x + 0.5, y + 0.5}, static_cast<double>(map.inverse_depth(x, y)));
            if (!inverse_depth) continue;
            if (const auto sample = sample_at(x, y, *inverse_depth)) samples.push_back(*sample);
        }
    }

 private:
    /// What the view and those that agree with it say on average; empty where too few agree.
    [[nodiscard]] std::optional<double> agreed(const Eigen::Vector2d& pixel,
                                               double inverse_depth) const {
        int agreeing = 0;
        int seeing_through = 0;
        double sum = inverse_depth;
        for (const Neighbour& neighbour : neighbours_) {
            const Answer answer = answer_of(neighbour, pixel, inverse_depth);
            if (answer.vote == Vote::kSeesThrough) ++seeing_through;
            if (answer.vote != Vote::kAgrees) continue;
            ++agreeing;
            sum += answer.inverse_depth;
        }
        if (agreeing < min_agreeing_ || agreeing <= seeing_through) return std::nullopt;
        return sum / (agreeing + 1);
    }

    [[nodiscard]] Eigen::Vector3d in_cam(int x, int y, double inverse_depth) const {
        const Eigen::Vector3d ray = unproject(camera_, {x + 0.5, y + 0.5});
        return ray / (ray.z() * inverse_depth);
    }
    [[nodiscard]] Eigen::Vector3d in_cam(int x, int y) const {
        return in_cam(x, y, static_cast<double>(view_.depth->inverse_depth(x, y)));
    }

    [[nodiscard]] std::optional<SurfaceSample> sample_at(int x, int y, double agreed) const {
        if (x == 0 || y == 0 || x + 1 == camera_.width_px || y + 1 == camera_.height_px) {
            return std::nullopt;
        }
        const FloatImage& inverse_depth = view_.depth->inverse_depth;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (inverse_depth(x + dx, y + dy) <= 0) return std::nullopt;
        }
        const Eigen::Vector3d here = in_cam(x, y, agreed);
        Eigen::Vector3d normal =
            (in_cam(x, y + 1) - in_cam(x, y - 1)).cross(in_cam(x + 1, y) - in_cam(x - 1, y));
        normal.normalize();
        const double cosine = -normal.dot(here.normalized());
        if (!(cosine >= kMinCosine)) return std::nullopt;
        const ColorImage& photograph = *view_.photograph;
        const auto photo_x = static_cast<int>((x + 0.5) * photograph.width() / camera_.width_px);
        const auto photo_y = static_cast<int>((y + 0.5) * photograph.height() / camera_.height_px);
        return SurfaceSample{world_from_cam_ * here, world_from_cam_.rotation * normal,
                             photograph(photo_x, photo_y), cosine};
    }

    const PicturedView& view_;
    Camera camera_;
    Rigid3 world_from_cam_;
    const std::vector<Neighbour>& neighbours_;
    int min_agreeing_;
};

/// Of each view; of one without depth none.
std::vector<std::vector<Neighbour>> neighbours_of_all(const std::vector<PicturedView>& views) {
    std::vector<std::vector<Neighbour>> neighbours(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].depth->inverse_depth.empty()) neighbours[i] = nearest_neighbours(views, i);
    }
    return neighbours;
}

void require_agreement(int min_agreeing, const std::vector<std::vector<Neighbour>>& neighbours) {
    std::size_t most = 1;
    for (const std::vector<Neighbour>& some : neighbours) most = std::max(most, some.size());
    if (static_cast<std::size_t>(min_agreeing) <= most) return;
    throw Error(ErrorKind::kUsage, "E-FUSE-OPTION",
                "agreeing views: " + std::to_string(min_agreeing) +
                    " others were to see the same surface, but no view has more than " +
                    std::to_string(most) + " that are asked",
                "ask for at most as many");
}

std::vector<Acuity> acuities_of(const std::vector<PicturedView>& views,
                                const std::vector<std::vector<Neighbour>>& neighbours) {
    std::vector<Acuity> acuities;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (neighbours[i].empty()) continue;
        acuities.push_back({centre_in_world(views[i].cam_from_world),
                            focal_length_px(depth_camera(views[i])).x(),
                            neighbours[i].back().distance});
    }
    return acuities;
}

std::vector<SurfaceSample> samples_of_view(const ViewSampler& sampler, int threads,
                                           std::uint64_t& confident) {
    std::vector<std::vector<SurfaceSample>> rows(static_cast<std::size_t>(sampler.height()));
    std::vector<std::uint64_t> counts(rows.size());
    parallel_for(sampler.height(), threads, [&](int y) {
        sampler.sample_row(y, rows[static_cast<std::size_t>(y)],
                           counts[static_cast<std::size_t>(y)]);
    });
    confident += std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::vector<SurfaceSample> samples;
    for (const auto& row : rows) samples.insert(samples.end(), row.begin(), row.end());
    return samples;
}

}  // namespace

SurfacePoints surface_points(const std::vector<PicturedView>& views,
                             const SurfacePointOptions& options, int threads, Progress& progress) {
    constexpr double kCoarser = 2.0;  // Cells come in powers of two.
    const std::vector<std::vector<Neighbour>> neighbours = neighbours_of_all(views);
    require_agreement(options.min_agreeing_views, neighbours);
    const std::vector<Acuity> acuities = acuities_of(views, neighbours);
    for (SurfacePoints result{{}, 0, 0, options.spacing_px};; result.spacing_px *= kCoarser) {
        SurfaceGrid grid(acuities, result.spacing_px);
        result.confident_pixels = 0;
        result.agreeing_pixels = 0;
        progress.begin("points of the surface", views.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            progress.throw_if_interrupted();
            progress.advance();
            if (views[i].depth->inverse_depth.empty()) continue;
            const ViewSampler sampler(views[i], neighbours[i], options.min_agreeing_views);
            const std::vector<SurfaceSample> samples =
                samples_of_view(sampler, threads, result.confident_pixels);
            result.agreeing_pixels += samples.size();
            for (const SurfaceSample& sample : samples) grid.add(sample);
            if (grid.size() > 2 * static_cast<std::size_t>(options.max_points)) break;
        }
        if (grid.size() > 2 * static_cast<std::size_t>(options.max_points)) continue;
        result.points = grid.points();
        if (result.points.size() <= static_cast<std::size_t>(options.max_points)) return result;
    }
}

}  // namespace lumi
