#include "render/modes/depth_view_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "render/modes/scene_plane.h"

namespace lumi {
namespace {

constexpr int kGridSteps = 17;
/// At this angle between view and eye a view is worth half.
constexpr double kHalfWorth_rad = 0.1;
/// What one more view is worth where others see the same: two must agree, more are spare. No more
/// than that is a view worth for what may stand before the scene plane.
constexpr double kWorthOfNext = 0.1;
/// A view that is worth less by no more than this share might be the best of an eye close by.
constexpr double kNearlyAsMuch = 0.05;
/// Sets for less of the picture than this are left out.
constexpr double kLeastShare = 1e-3;

/// A point that the eye may see, as (direction, inverse depth) in its frame: X = direction / q.
struct Sample {
    Eigen::Vector3d direction_in_world;
    double inverse_depth = 0.0;
    double worth = 1.0;  ///< To a view that sees it from the eye's direction, the first to do so.
};

std::vector<Sample> samples_seen_by(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const double near_end = inverse_depth_range(lumigraph).y();
    std::vector<Sample> samples;
    for (int row = 0; row < kGridSteps; ++row) {
        for (int column = 0; column < kGridSteps; ++column) {
            const Eigen::Vector2d pixel(column * eye.camera.width_px / (kGridSteps - 1.0),
                                        row * eye.camera.height_px / (kGridSteps - 1.0));
            const Eigen::Vector3d direction_in_world =
                eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
            const double on_plane = std::max(0.0, plane.dot(pixel.homogeneous()));
            samples.push_back({direction_in_world, on_plane});
            samples.push_back({direction_in_world, std::max(on_plane, near_end), kWorthOfNext});
        }
    }
    return samples;
}

/// How a view sees the samples, one number a sample.
struct Sight {
    /// 1 within the photograph, 0 outside; from one to the other over the distance of two samples.
    std::vector<double> inside;
    std::vector<double> closeness;  ///< The same, the less the larger the angle to the eye.
};

double inside_share(const Camera& camera, const Eigen::Vector2d& pixel) {
    const double to_border_px =
        std::min({pixel.x(), pixel.y(), camera.width_px - pixel.x(), camera.height_px - pixel.y()});
    const double sample_px = std::min(camera.width_px, camera.height_px) / (kGridSteps - 1.0);
    return std::clamp(0.5 + 4 * to_border_px / sample_px, 0.0, 1.0);
}

Sight sight_of(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
               const std::vector<Sample>& samples) {
    const Eigen::Vector3d eye_from_view = centre_in_world(view.cam_from_world) - eye_in_world;
    Sight sight;
    for (const Sample& sample : samples) {
        const Eigen::Vector3d from_view =
            sample.direction_in_world - sample.inverse_depth * eye_from_view;
        const auto pixel = project(view.camera, view.cam_from_world.rotation * from_view);
        const double inside = pixel ? inside_share(view.camera, *pixel) : 0.0;
        const double angle = std::atan2(from_view.cross(sample.direction_in_world).norm(),
                                        from_view.dot(sample.direction_in_world));
        sight.inside.push_back(inside);
        sight.closeness.push_back(inside * kHalfWorth_rad / (kHalfWorth_rad + angle));
    }
    return sight;
}

/// Takes views one by one.
class Choice {
 public:
    Choice(const Lumigraph& lumigraph, const Eye& eye, int max_views, double nearly)
        : max_views_(max_views), nearly_(nearly) {
        const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
        const std::vector<Sample> samples = samples_seen_by(lumigraph, eye);
        for (const LumigraphView& view : lumigraph.views)
            sights_.push_back(sight_of(view, eye_in_world, samples));
        for (const Sample& sample : samples) worth_.push_back(sample.worth);
    }

    [[nodiscard]] std::vector<DepthViewSet> sets() {
        complete({{}, 1.0}, worth_);
        return std::move(sets_);
    }

 private:
    struct Candidate {
        int view = -1;
        double gain = 0.0;
    };

    /// The best views to take next, the very best first. The first view may see nothing.
    [[nodiscard]] std::array<Candidate, 2> next(const std::vector<int>& chosen,
                                                const std::vector<double>& worth) const {
        std::array<Candidate, 2> best;
        if (chosen.empty()) best[0].gain = best[1].gain = -1.0;
        for (int i = 0; i < static_cast<int>(sights_.size()); ++i) {
            if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
            const std::vector<double>& closeness = sights_[static_cast<std::size_t>(i)].closeness;
            const double gain =
                std::inner_product(closeness.begin(), closeness.end(), worth.begin(), 0.0);
            if (gain > best[0].gain) {
                best[1] = std::exchange(best[0], {i, gain});
            } else if (gain > best[1].gain) {
                best[1] = {i, gain};
            }
        }
        return best;
    }

    /// Half for the second best where it is as good; 0 where it is clearly worse.
    [[nodiscard]] double share_of_second(const std::array<Candidate, 2>& best) const {
        if (best[1].view < 0 || best[0].gain <= 0 || nearly_ <= 0) return 0.0;
        const double worse = 1 - best[1].gain / best[0].gain;
        return std::max(0.0, 0.5 * (1 - worse / nearly_));
    }

    void complete(const DepthViewSet& set, const std::vector<double>& worth) {
        if (static_cast<int>(set.view_indices.size()) == max_views_) return add(set);
        const std::array<Candidate, 2> best = next(set.view_indices, worth);
        if (best[0].view < 0) return add(set);
        const double second = share_of_second(best);
        complete_with(best[0].view, 1 - second, set, worth);
        if (second * set.share > kLeastShare) complete_with(best[1].view, second, set, worth);
    }

    void complete_with(int view, double share, DepthViewSet set, std::vector<double> worth) {
        set.view_indices.push_back(view);
        set.share *= share;
        const std::vector<double>& inside = sights_[static_cast<std::size_t>(view)].inside;
        for (std::size_t s = 0; s < worth.size(); ++s)
            worth[s] *= 1 - (1 - kWorthOfNext) * inside[s];
        complete(set, worth);
    }

    void add(const DepthViewSet& set) {
        for (DepthViewSet& known : sets_) {
            if (known.view_indices != set.view_indices) continue;
            known.share += set.share;
            return;
        }
        sets_.push_back(set);
    }

    int max_views_;
    double nearly_;
    std::vector<Sight> sights_;
    std::vector<double> worth_;
    std::vector<DepthViewSet> sets_;
};

}  // namespace

std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye, int max_views) {
    return Choice(lumigraph, eye, max_views, 0.0).sets().front().view_indices;
}

std::vector<DepthViewSet> depth_view_sets(const Lumigraph& lumigraph, const Eye& eye,
                                          int max_views) {
    std::vector<DepthViewSet> sets = Choice(lumigraph, eye, max_views, kNearlyAsMuch).sets();
    std::sort(sets.begin(), sets.end(),
              [](const DepthViewSet& a, const DepthViewSet& b) { return a.share > b.share; });
    sets.resize(std::min(sets.size(), static_cast<std::size_t>(kMaxDepthViewSets)));
    double sum = 0;
    for (const DepthViewSet& set : sets) sum += set.share;
    for (DepthViewSet& set : sets) set.share /= sum;
    std::sort(sets.begin(), sets.end(), [](const DepthViewSet& a, const DepthViewSet& b) {
        return a.view_indices < b.view_indices;
    });
    return sets;
}

double agreeing_inverse_depth(const std::vector<ViewGeometry>& geometries,
                              const std::vector<DepthViewSet>& sets, double tolerance_px) {
    double mean = 0;
    for (const DepthViewSet& set : sets)
        mean += set.share * agreeing_inverse_depth(geometries, set.view_indices, tolerance_px);
    return mean;
}

std::size_t set_at(const std::vector<DepthViewSet>& sets, int column, int row) {
    const std::uint32_t number = 3242174889U * static_cast<std::uint32_t>(column) +
                                 2447445414U * static_cast<std::uint32_t>(row);
    const auto place = static_cast<float>(number >> 8) / 16777216.0F;
    double end = 0;
    for (std::size_t i = 0; i + 1 < sets.size(); ++i) {
        end += sets[i].share;
        if (place < static_cast<float>(end)) return i;
    }
    return sets.size() - 1;
}

}  // namespace lumi
