#include "calib/mapping/model_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "calib/adjust/camera_blocks.h"
#include "calib/adjust/gauge.h"
#include "calib/adjust/longest_tracks.h"
#include "calib/adjust/quiet_solver.h"
#include "calib/adjust/reprojection_cost.h"
#include "calib/adjust/stop_on_interrupt.h"
#include "calib/lens/lens_form.h"

namespace lumi {
namespace {

/// The photographs and points that an adjustment moves.
struct Moving {
    std::vector<char> photographs;
    std::vector<std::size_t> tracks;  ///< Ascending.
    bool lenses = false;
};

template <class Body>
void for_each_inlier(const GrowingTrack& track, const Body& body) {
    for (std::size_t element = 0; element < track.elements.size(); ++element) {
        if (track.is_inlier[element] != 0) body(track.elements[element]);
    }
}

/// Of `tracks`, the longest, so many that each photograph has as many as asked (or all it has).
std::vector<std::size_t> strongest(const GrowingModel& model,
                                   const std::vector<std::size_t>& tracks,
                                   int points_a_photograph) {
    std::vector<std::vector<int>> photographs_of_track(tracks.size());
    for (std::size_t index = 0; index < tracks.size(); ++index) {
        for_each_inlier(model.tracks[tracks[index]], [&](const TrackElement& seen) {
            photographs_of_track[index].push_back(seen.photograph);
        });
    }
    std::vector<std::size_t> chosen;
    for (const std::size_t index :
         longest_tracks(photographs_of_track, model.pixels.size(), points_a_photograph)) {
        chosen.push_back(tracks[index]);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

void hold_lens(ceres::Problem& problem, double* lens, const Camera& camera, bool refine) {
    if (!refine) {
        problem.SetParameterBlockConstant(lens);
        return;
    }
    problem.SetManifold(lens,
                        new ceres::SubsetManifold(static_cast<int>(camera.parameters.size()),
                                                  with_principal_point_held(camera.model).held));
}

class Adjustment {
 public:
    Adjustment(GrowingModel& model, const Moving& moving, const ModelAdjustmentOptions& options)
        : model_(model),
          moving_(moving),
          cameras_(model.cam_from_world, model.cameras),
          loss_(options.robust_scale_px),
          problem_(problem_options()),
          order_(std::make_shared<ceres::ParameterBlockOrdering>()) {
        for (const std::size_t track : moving.tracks) add_track(model.tracks[track]);
        for (std::size_t photograph = 0; photograph < model.pixels.size(); ++photograph) {
            hold_pose(photograph);
        }
        for (std::size_t camera = 0; camera < model.cameras.size(); ++camera) {
            double* const lens = cameras_.lens(camera);
            if (!problem_.HasParameterBlock(lens)) continue;
            hold_lens(problem_, lens, model.cameras[camera], moving.lenses);
            order_->AddElementToGroup(lens, 2);
        }
    }

    void hold_gauge() { lumi::hold_gauge(problem_, model_.cam_from_world, cameras_); }

    void solve(int max_iterations, const Progress& progress) {
        if (problem_.NumResidualBlocks() == 0) return;
        StopOnInterrupt stop(progress);
        const auto photographs =
            std::count(moving_.photographs.begin(), moving_.photographs.end(), char{1});
        constexpr std::ptrdiff_t kDenseUpToPhotographs = 40;
        ceres::Solver::Options solver = quiet_solver_options();
        solver.linear_solver_type =
            photographs <= kDenseUpToPhotographs ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
        solver.linear_solver_ordering = order_;
        solver.max_num_iterations = max_iterations;
        solver.function_tolerance = 1e-4;
        solver.callbacks = {&stop};
        ceres::Solver::Summary summary;
        ceres::Solve(solver, &problem_, &summary);
        progress.throw_if_interrupted();
        if (!summary.IsSolutionUsable()) return;
        cameras_.copy_lenses_to(model_.cameras);
        for (std::size_t index = 0; index < model_.cam_from_world.size(); ++index) {
            model_.cam_from_world[index] = cameras_.solved_pose(index);
        }
    }

 private:
    ceres::Problem::Options problem_options() {
        ceres::Problem::Options options;
        options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        return options;
    }

    /// Of a track that has a point.
    void add_track(GrowingTrack& track) {
        double* const point = track.point_in_world->data();
        for_each_inlier(track, [&](const TrackElement& seen) {
            const auto photograph = static_cast<std::size_t>(seen.photograph);
            const Rigid3& pose = model_.cam_from_world[photograph];
            // A point behind a camera has no pixel there, and the whole problem no cost.
            if (!((pose * *track.point_in_world).z() > 1e-6)) return;
            const auto camera = static_cast<std::size_t>(model_.camera_of_photograph[photograph]);
            problem_.AddResidualBlock(reprojection_cost(model_.cameras[camera].model,
                                                        model_.pixels[photograph][seen.feature])
                                          .release(),
                                      &loss_, cameras_.lens(camera), cameras_.pose(photograph),
                                      point);
        });
        if (problem_.HasParameterBlock(point)) order_->AddElementToGroup(point, 0);
    }

    void hold_still(std::size_t photograph) {
        double* const pose = cameras_.pose(photograph);
        if (problem_.HasParameterBlock(pose)) problem_.SetParameterBlockConstant(pose);
    }

    void hold_pose(std::size_t photograph) {
        double* const pose = cameras_.pose(photograph);
        if (!problem_.HasParameterBlock(pose)) return;
        order_->AddElementToGroup(pose, 1);
        problem_.SetManifold(pose, new_pose_manifold());
        if (moving_.photographs[photograph] == 0) hold_still(photograph);
    }

    GrowingModel& model_;
    const Moving& moving_;
    CameraBlocks cameras_;
    ceres::CauchyLoss loss_;
    ceres::Problem problem_;
    std::shared_ptr<ceres::ParameterBlockOrdering> order_;
};

/// The photograph and the placed ones that share most points with it.
std::vector<char> neighbourhood_of(const GrowingModel& model, int photograph) {
    constexpr std::size_t kNeighbours = 5;
    std::vector<int> shared(model.pixels.size(), 0);
    for (const std::size_t track : tracks_of(model, photograph)) {
        for_each_inlier(model.tracks[track], [&](const TrackElement& seen) {
            ++shared[static_cast<std::size_t>(seen.photograph)];
        });
    }
    std::vector<std::size_t> order(model.pixels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return shared[a] > shared[b]; });
    std::vector<char> chosen(model.pixels.size(), 0);
    // Two stay where they are, so that the neighbourhood cannot float away.
    const auto others = static_cast<std::size_t>(std::max(0, model.placed() - 3));
    std::size_t count = 0;
    for (const std::size_t other : order) {
        if (shared[other] == 0 || count == std::min(kNeighbours, others)) break;
        if (static_cast<int>(other) == photograph) continue;
        chosen[other] = 1;
        ++count;
    }
    chosen[static_cast<std::size_t>(photograph)] = 1;
    return chosen;
}

}  // namespace

void adjust_model(GrowingModel& model, const ModelAdjustmentOptions& options, Progress& progress) {
    progress.throw_if_interrupted();
    std::vector<std::size_t> tracks;
    for (std::size_t track = 0; track < model.tracks.size(); ++track) {
        if (model.tracks[track].point_in_world) tracks.push_back(track);
    }
    const Moving moving{model.is_placed, strongest(model, tracks, options.points_a_photograph),
                        options.refine_lenses};
    Adjustment adjustment(model, moving, options);
    adjustment.hold_gauge();
    adjustment.solve(options.max_iterations, progress);
    if (options.refine_lenses) update_rays(model);
}

void adjust_around(GrowingModel& model, int photograph, const ModelAdjustmentOptions& options,
                   Progress& progress) {
    progress.throw_if_interrupted();
    Moving moving{neighbourhood_of(model, photograph), {}, false};
    std::vector<std::size_t> tracks;
    for (const std::size_t track : tracks_of(model, photograph)) {
        if (model.tracks[track].point_in_world) tracks.push_back(track);
    }
    std::sort(tracks.begin(), tracks.end());
    moving.tracks = strongest(model, tracks, options.points_a_photograph);
    Adjustment(model, moving, options).solve(options.max_iterations, progress);
}

}  // namespace lumi
