#include "meshing/depth/held_out_photograph.h"

#include <algorithm>

#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth/finished_depth.h"
#include "meshing/depth/photograph_loss.h"
#include "meshing/depth/subject.h"
#include "meshing/depth_scene/views_far_apart.h"

namespace lumi {
namespace {

Eigen::Vector3d centre_of(const DepthScene& scene, int view) {
    return centre_in_world(scene.views[static_cast<std::size_t>(view)].cam_from_world);
}

/// 0 where a view's neighbours stand evenly around it, 1 where all stand to one side.
double one_sidedness(const DepthScene& scene, int view) {
    const std::vector<int>& neighbours = scene.views[static_cast<std::size_t>(view)].neighbours;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int j : neighbours) {
        const Eigen::Vector3d way = centre_of(scene, j) - centre_of(scene, view);
        if (way.norm() > 0) sum += way.normalized();
    }
    return sum.norm() / static_cast<double>(neighbours.size());
}

GrayImage halved(const GrayImage& mask, int width, int height) {
    if (mask.empty()) return mask;
    GrayImage half(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) half(x, y) = mask(2 * x, 2 * y);
    }
    return half;
}

/// The view at the size of the trial.
DepthView at_trial_size(const DepthView& view) {
    constexpr int kMinHalfWidth = 300;  // Of less, too little would remain to match.
    const int width = view.camera.width_px / 2;
    const int height = view.camera.height_px / 2;
    if (width < kMinHalfWidth) return view;
    DepthView half = view;
    half.camera = resized(view.camera, width, height);
    half.photograph = resized(view.photograph, width, height);
    const Eigen::Vector2d scale(1.0 * width / view.camera.width_px,
                                1.0 * height / view.camera.height_px);
    for (SparsePoint& point : half.points) point.pixel = scale.cwiseProduct(point.pixel);
    half.disparity_px_per_inverse_depth *= scale.x();
    return half;
}

}  // namespace

std::vector<int> photographs_to_keep_back(const DepthScene& scene) {
    constexpr std::size_t kManyViews = 32;
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.neighbours.size() > 1 && view.disparity_px_per_inverse_depth > 0) {
            candidates.push_back(static_cast<int>(i));
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [&](int a, int b) {
        return one_sidedness(scene, a) < one_sidedness(scene, b);
    });
    candidates.resize((candidates.size() + 1) / 2);
    return views_far_apart(scene, candidates, scene.views.size() < kManyViews ? 3 : 4);
}

HeldOutPhotograph::HeldOutPhotograph(const DepthScene& scene, const std::vector<GrayImage>& masks,
                                     int kept_back)
    : source_(scene), source_masks_(masks), kept_back_(kept_back) {
    for (const int j : scene.views[static_cast<std::size_t>(kept_back)].neighbours) add(j);
    predictors_ = static_cast<int>(members_.size());
    for (int i = 0; i < predictors_; ++i) link(static_cast<std::size_t>(i));
}

std::vector<double> HeldOutPhotograph::loss(const std::string& model, int threads,
                                            const Progress& progress) {
    const std::unique_ptr<DepthModel> rung = depth_model_named(model);
    const std::vector<DepthMap> maps =
        finished(refined(*rung, first_estimates(*rung, threads, progress), threads, progress),
                 threads, progress);
    std::vector<PredictingView> views;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        views.push_back({&scene_.views[i], &maps[i].inverse_depth});
    }
    return photograph_loss(views,
                           at_trial_size(source_.views[static_cast<std::size_t>(kept_back_)]));
}

void HeldOutPhotograph::add(int view) {
    if (std::find(members_.begin(), members_.end(), view) != members_.end()) return;
    members_.push_back(view);
    scene_.views.push_back(at_trial_size(source_.views[static_cast<std::size_t>(view)]));
    scene_.views.back().neighbours.clear();
    const Camera& camera = scene_.views.back().camera;
    const GrayImage& mask = source_masks_[static_cast<std::size_t>(view)];
    masks_.push_back(
        mask.width() == camera.width_px ? mask : halved(mask, camera.width_px, camera.height_px));
}

/// A predictor keeps its neighbours; another predictor takes the place of the photograph kept back,
/// so that no rung has fewer views to compare, and predictors can confirm each other.
void HeldOutPhotograph::link(std::size_t member) {
    std::vector<int> others = source_.views[static_cast<std::size_t>(members_[member])].neighbours;
    const std::size_t wanted = others.size();
    std::erase(others, kept_back_);
    const auto is_other = [&](int view) {
        return std::find(others.begin(), others.end(), view) != others.end();
    };
    const auto predictors_end = members_.begin() + predictors_;
    bool has_predictor = std::any_of(members_.begin(), predictors_end, is_other);
    for (std::size_t i = 0; i < static_cast<std::size_t>(predictors_); ++i) {
        if (others.size() >= wanted && has_predictor) break;
        if (i == member || is_other(members_[i])) continue;
        others.push_back(members_[i]);
        has_predictor = true;
    }
    for (const int j : others) {
        add(j);
        const auto found = std::find(members_.begin(), members_.end(), j);
        scene_.views[member].neighbours.push_back(static_cast<int>(found - members_.begin()));
    }
}

const std::vector<DepthEstimate>& HeldOutPhotograph::first_estimates(const DepthModel& model,
                                                                     int threads,
                                                                     const Progress& progress) {
    std::vector<DepthEstimate>& estimates = first_estimates_[model.begins_as()];
    if (!estimates.empty()) return estimates;
    const Subject subject(scene_, masks_);
    std::vector<DepthEstimate> found(scene_.views.size());
    parallel_for(predictors_, threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        found[index] = model.estimate(scene_, i);
        subject.leave_claims_within(i, found[index]);
    });
    estimates = std::move(found);
    return estimates;
}

/// What has an estimate is made better; the rest of the views has said nothing.
std::vector<DepthEstimate> HeldOutPhotograph::refined(const DepthModel& model,
                                                      std::vector<DepthEstimate> estimates,
                                                      int threads, const Progress& progress) const {
    const Subject subject(scene_, masks_);
    for (int round = 0; round < model.refinements(); ++round) {
        const std::vector<DepthEstimate> before = estimates;
        parallel_for(predictors_, threads, [&](int i) {
            progress.throw_if_interrupted();
            const auto index = static_cast<std::size_t>(i);
            estimates[index] = model.refine(scene_, before, i);
            subject.leave_claims_within(i, estimates[index]);
        });
    }
    return estimates;
}

std::vector<DepthMap> HeldOutPhotograph::finished(const std::vector<DepthEstimate>& estimates,
                                                  int threads, const Progress& progress) const {
    std::vector<DepthMap> confirmed(scene_.views.size());  // Of the rest nothing is known.
    parallel_for(predictors_, threads, [&](int i) {
        progress.throw_if_interrupted();
        confirmed[static_cast<std::size_t>(i)] = confirmed_depth(scene_, estimates, i);
    });
    std::vector<DepthMap> maps(confirmed.begin(), confirmed.begin() + predictors_);
    const Subject subject(scene_, masks_);
    parallel_for(predictors_, threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        if (!estimates[index].is_complete)
            fill_unknown_depth(scene_, confirmed, i, 0.0, maps[index]);
        subject.separate_from_background(i, estimates[index], maps[index]);
    });
    return maps;
}

}  // namespace lumi
