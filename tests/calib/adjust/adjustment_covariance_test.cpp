#include "calib/adjust/adjustment_covariance.h"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "calib/adjust/bundle_problem.h"
#include "calib/adjust/linearisation.h"
#include "calib/work/error.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Camera true_lens() { return {1000, 800, LensModel::kSimpleRadial, {900, 500, 400, -0.05}}; }

Capture small_scene(double noise_px, unsigned seed = 1) {
    SyntheticCaptureOptions scene;
    scene.views = 5;
    scene.points = 60;
    scene.noise_px = noise_px;
    scene.seed = seed;
    return synthetic_capture(true_lens(), scene);
}

BundleAdjustmentOptions least_squares() {
    BundleAdjustmentOptions options;
    options.robust_last_pass = false;
    return options;
}

/// Focal length and k1 are free: two unknowns behind six for each view.
constexpr Index kFreeOfLens = 2;

/// Pose and lens after a small step: rotation after the pose, translation, f, k1.
Eigen::Vector2d pixel_after(const Capture& capture, int view_index, const Eigen::Vector3d& point,
                            const VectorXd& step) {
    const View& view = capture.views[static_cast<std::size_t>(view_index)];
    Camera lens = camera_of(capture, view);
    lens.parameters[0] += step[6];
    lens.parameters[3] += step[7];
    const Eigen::Vector3d turn = step.head<3>();
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Eigen::Vector3d(turn.normalized())
                                                       : Eigen::Vector3d(1, 0, 0))
            .toRotationMatrix() *
        view.cam_from_world.rotation.toRotationMatrix();
    const Eigen::Vector3d translation = view.cam_from_world.translation + step.segment<3>(3);
    return project(lens, rotation * point + translation).value();
}

/// How the picture of a point moves with pose and lens, by difference quotients.
MatrixXd picture_derivative(const Capture& capture, int view, const Eigen::Vector3d& point) {
    MatrixXd derivative(2, 8);
    for (Index unknown = 0; unknown < 8; ++unknown) {
        VectorXd step = VectorXd::Zero(8);
        step[unknown] = unknown == 6 ? 1e-3 : 1e-6;
        derivative.col(unknown) =
            (pixel_after(capture, view, point, step) - pixel_after(capture, view, point, -step)) /
            (2 * step[unknown]);
    }
    return derivative;
}

/// Brings steps of all poses and the lens into the gauge in which pictures move least.
class LeastMovingGauge {
 public:
    explicit LeastMovingGauge(const Capture& capture) : views_(capture.views.size()) {
        const auto unknowns = static_cast<Index>(6 * views_) + kFreeOfLens;
        MatrixXd metric = MatrixXd::Zero(unknowns, unknowns);
        std::vector<double> count(views_, 0);
        picture_.resize(views_, MatrixXd::Zero(8, 8));
        for (const ScenePoint& point : capture.points) {
            for (const Observation& seen : point.track) {
                const MatrixXd derivative =
                    picture_derivative(capture, seen.view_index, point.position_in_world);
                const auto view = static_cast<std::size_t>(seen.view_index);
                picture_[view] += derivative.transpose() * derivative;
                ++count[view];
            }
        }
        MatrixXd gauge = MatrixXd::Zero(unknowns, 7);
        for (std::size_t view = 0; view < views_; ++view) {
            picture_[view] /= count[view];
            const MatrixXd pick = picked(view, unknowns);
            metric += pick.transpose() * picture_[view] * pick;
            const Rigid3& pose = capture.views[view].cam_from_world;
            const auto row = static_cast<Index>(6 * view);
            gauge.block<3, 3>(row, 0) = pose.rotation.toRotationMatrix();
            gauge.block<3, 3>(row + 3, 3) = pose.rotation.toRotationMatrix();
            gauge.block<3, 1>(row + 3, 6) = pose.translation;
        }
        const MatrixXd weighted = metric * gauge;
        projection_ = MatrixXd::Identity(unknowns, unknowns) -
                      gauge * (weighted.transpose() * gauge).ldlt().solve(weighted.transpose());
    }

    [[nodiscard]] const MatrixXd& projection() const { return projection_; }

    /// Pose of `view` and lens, out of all unknowns.
    [[nodiscard]] static MatrixXd picked(std::size_t view, Index unknowns) {
        MatrixXd pick = MatrixXd::Zero(8, unknowns);
        pick.block<6, 6>(0, static_cast<Index>(6 * view)).setIdentity();
        pick.block<2, 2>(6, unknowns - kFreeOfLens).setIdentity();
        return pick;
    }

    /// Mean over points and coordinates of the squared pixels by which a step moves the picture.
    [[nodiscard]] double moved_px2(std::size_t view, const VectorXd& step) const {
        const VectorXd own = picked(view, step.size()) * step;
        return 0.5 * own.dot(picture_[view] * own);
    }

 private:
    std::size_t views_;
    std::vector<MatrixXd> picture_;
    MatrixXd projection_;
};

/// Of all poses and f, k1, by Ceres's dense singular value decomposition, first view fixed.
MatrixXd dense_covariance_of_ceres(Capture capture) {
    const auto unknowns = static_cast<Index>(6 * capture.views.size()) + kFreeOfLens;
    ceres::Problem problem;
    CameraBlocks cameras = camera_blocks(capture);
    build_bundle_problem(problem, capture, cameras, {}, nullptr);
    std::vector<const double*> blocks;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        blocks.push_back(cameras.pose(view));
    }
    blocks.push_back(cameras.lens(0));
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    ceres::Covariance covariance(options);
    EXPECT_TRUE(covariance.Compute(blocks, &problem));
    std::vector<Index> sizes;
    for (const double* const block : blocks) {
        sizes.push_back(
            problem.IsParameterBlockConstant(block) ? 6 : problem.ParameterBlockTangentSize(block));
    }
    // Tangent spaces by block: a pose has 6, and one whose translation is held along an axis 5.
    MatrixXd result = MatrixXd::Zero(unknowns, unknowns);
    const auto place = [&](std::size_t block, Index row) {
        if (block + 1 == blocks.size()) return unknowns - kFreeOfLens + row;
        const auto first = static_cast<Index>(6 * block);
        if (sizes[block] == 6 || row < 3) return first + row;
        const auto* manifold = problem.GetManifold(blocks[block]);
        Eigen::Matrix<double, 7, 5, Eigen::RowMajor> jacobian;
        manifold->PlusJacobian(blocks[block], jacobian.data());
        Index coordinate = 0;
        jacobian.block<3, 1>(4, row).maxCoeff(&coordinate);
        return first + 3 + coordinate;
    };
    for (std::size_t a = 0; a < blocks.size(); ++a) {
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> block(sizes[a],
                                                                                         sizes[b]);
            EXPECT_TRUE(
                covariance.GetCovarianceBlockInTangentSpace(blocks[a], blocks[b], block.data()));
            // A step of Ceres's quaternion manifold is half a rotation vector.
            const auto scale = [&](std::size_t of, Index index) {
                return of + 1 < blocks.size() && index < 3 ? 2.0 : 1.0;
            };
            for (Index row = 0; row < sizes[a]; ++row) {
                for (Index column = 0; column < sizes[b]; ++column) {
                    result(place(a, row), place(b, column)) =
                        scale(a, row) * scale(b, column) * block(row, column);
                }
            }
        }
    }
    return result;
}

TEST(AdjustmentCovariance, EqualsCeresDenseCovarianceInTheSameGauge) {
    Capture capture = small_scene(0.5);
    SilentProgress progress;
    const BundleFit fit = fit_bundle(capture, {}, progress);
    const auto covariance = adjustment_covariance(capture, least_squares(), SilentProgress());
    ASSERT_TRUE(covariance.has_value());

    const auto views = static_cast<int>(capture.views.size());
    const int redundancy = fit.residuals - 3 * static_cast<int>(capture.points.size()) -
                           (6 * views - 7) - static_cast<int>(kFreeOfLens);
    const double variance_px2 = fit.residual_sum_px2 / redundancy;
    EXPECT_NEAR(covariance->noise_px, std::sqrt(variance_px2), 1e-6);

    const LeastMovingGauge gauge(capture);
    const MatrixXd expected = variance_px2 * gauge.projection() *
                              dense_covariance_of_ceres(capture) * gauge.projection().transpose();
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        const MatrixXd own =
            expected.block<6, 6>(static_cast<Index>(6 * view), static_cast<Index>(6 * view));
        EXPECT_LT((covariance->poses[view] - own).norm(), 1e-4 * own.norm()) << "view " << view;
        const MatrixXd pick = LeastMovingGauge::picked(view, expected.rows());
        const MatrixXd with_lens = pick * expected * pick.transpose();
        double sum_px2 = 0;
        double count = 0;
        for (const ScenePoint& point : capture.points) {
            for (const Observation& seen : point.track) {
                if (seen.view_index != static_cast<int>(view)) continue;
                const MatrixXd derivative =
                    picture_derivative(capture, seen.view_index, point.position_in_world);
                sum_px2 += (derivative * with_lens * derivative.transpose()).trace();
                count += 2;
            }
        }
        EXPECT_NEAR(covariance->jitter_px[view], std::sqrt(sum_px2 / count),
                    1e-4 * covariance->jitter_px[view]);
    }
    const MatrixXd lens = expected.bottomRightCorner<2, 2>();
    EXPECT_NEAR(covariance->lenses[0](0, 0), lens(0, 0), 1e-4 * lens(0, 0));
    EXPECT_NEAR(covariance->lenses[0](3, 3), lens(1, 1), 1e-4 * lens(1, 1));
    EXPECT_NEAR(covariance->lenses[0](0, 3), lens(0, 1), 1e-4 * std::abs(lens(0, 1)));
    EXPECT_EQ(covariance->lenses[0](1, 1), 0.0);
}

/// The step from the true poses and lens to the estimated ones.
VectorXd step_between(const Capture& truth, const Capture& estimate) {
    VectorXd step(static_cast<Index>(6 * truth.views.size()) + kFreeOfLens);
    for (std::size_t view = 0; view < truth.views.size(); ++view) {
        const Rigid3& a = truth.views[view].cam_from_world;
        const Rigid3& b = estimate.views[view].cam_from_world;
        const Eigen::AngleAxisd turn(
            Eigen::Matrix3d((b.rotation * a.rotation.conjugate()).toRotationMatrix()));
        step.segment<3>(static_cast<Index>(6 * view)) = turn.angle() * turn.axis();
        step.segment<3>(static_cast<Index>(6 * view + 3)) = b.translation - a.translation;
    }
    step.tail<2>() << estimate.cameras[0].parameters[0] - truth.cameras[0].parameters[0],
        estimate.cameras[0].parameters[3] - truth.cameras[0].parameters[3];
    return step;
}

/// Draws of noise on one scene: what was predicted, and what came.
struct Repetitions {
    std::vector<double> moved_px2;
    std::vector<double> predicted_px2;
    double share_contained = 0;  ///< Of pose coordinates in their 95 % intervals.
    int focal_contained = 0;
};

template <class Noise, class Adjust>
Repetitions repeated(int draws, Noise noise, Adjust adjust,
                     const BundleAdjustmentOptions& options) {
    const Capture truth = small_scene(0.0);
    const LeastMovingGauge gauge(truth);
    constexpr double kTwoSided95 = 1.96;
    Repetitions result;
    result.moved_px2.assign(truth.views.size(), 0.0);
    result.predicted_px2.assign(truth.views.size(), 0.0);
    int intervals = 0;
    int containing = 0;
    for (int draw = 0; draw < draws; ++draw) {
        Capture capture = truth;
        for (ScenePoint& point : capture.points) {
            for (Observation& seen : point.track) seen.pixel += noise();
        }
        adjust(capture);
        const auto covariance = adjustment_covariance(capture, options, SilentProgress());
        EXPECT_TRUE(covariance.has_value());
        if (!covariance) return result;
        const VectorXd step = gauge.projection() * step_between(truth, capture);
        for (std::size_t view = 0; view < truth.views.size(); ++view) {
            result.moved_px2[view] += gauge.moved_px2(view, step) / draws;
            const double jitter_px = covariance->jitter_px[view];
            result.predicted_px2[view] += jitter_px * jitter_px / draws;
            for (Index row = 0; row < 6; ++row) {
                ++intervals;
                containing += std::abs(step[static_cast<Index>(6 * view) + row]) <=
                              kTwoSided95 * std::sqrt(covariance->poses[view](row, row));
            }
        }
        result.focal_contained +=
            std::abs(step[step.size() - 2]) <= kTwoSided95 * std::sqrt(covariance->lenses[0](0, 0));
    }
    result.share_contained = static_cast<double>(containing) / intervals;
    return result;
}

void expect_predicted(const Repetitions& repetitions) {
    for (std::size_t view = 0; view < repetitions.moved_px2.size(); ++view) {
        EXPECT_NEAR(std::sqrt(repetitions.moved_px2[view] / repetitions.predicted_px2[view]), 1.0,
                    0.13)
            << "view " << view;
    }
    EXPECT_NEAR(repetitions.share_contained, 0.95, 0.025);
    EXPECT_GE(repetitions.focal_contained, 89);  // Of 100; two in a thousand fall below 89.
}

TEST(AdjustmentCovariance, PredictsTheJitterAndTheErrorsOfRepeatedCaptures) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise_px(0.0, 0.5);
    SilentProgress progress;
    expect_predicted(repeated(
        100, [&] { return Eigen::Vector2d(noise_px(random), noise_px(random)); },
        [&](Capture& capture) { fit_bundle(capture, {}, progress); }, least_squares()));
}

TEST(AdjustmentCovariance, PredictsThemUnderLongTailsAsWell) {
    std::mt19937 random(12);
    std::normal_distribution<double> noise_px(0.0, 0.15);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    SilentProgress progress;
    BundleAdjustmentOptions options;
    options.max_reprojection_error_px = 6;
    expect_predicted(repeated(
        100,
        [&]() -> Eigen::Vector2d {
            const double factor = unit(random) < 0.1 ? 6.0 : 1.0;
            return factor * Eigen::Vector2d(noise_px(random), noise_px(random));
        },
        [&](Capture& capture) { adjust_bundle(capture, options, progress); }, options));
}

TEST(AdjustmentCovariance, MoreObservationsAreMoreCertainByTheirRoot) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.5;
    scene.points = 100;
    Capture few = synthetic_capture(true_lens(), scene);
    scene.points = 400;
    Capture many = synthetic_capture(true_lens(), scene);
    SilentProgress progress;
    fit_bundle(few, {}, progress);
    fit_bundle(many, {}, progress);
    const auto of_few = adjustment_covariance(few, least_squares(), SilentProgress());
    const auto of_many = adjustment_covariance(many, least_squares(), SilentProgress());
    ASSERT_TRUE(of_few && of_many);
    const double ratio = std::sqrt(of_few->lenses[0](0, 0) / of_many->lenses[0](0, 0));
    EXPECT_NEAR(ratio, 2.0, 0.4);
}

TEST(AdjustmentCovariance, ViewsThatOnlyTurnAreNotDetermined) {
    // Two cameras in one place: points may lie at any depth.
    Capture capture = small_scene(0.0);
    capture.views.resize(2);
    capture.views[1].cam_from_world = capture.views[0].cam_from_world;
    for (ScenePoint& point : capture.points) {
        std::erase_if(point.track, [](const Observation& seen) { return seen.view_index > 0; });
        if (point.track.empty()) continue;
        point.track.push_back({1, point.track[0].pixel});
    }
    EXPECT_FALSE(adjustment_covariance(capture, {}, SilentProgress()).has_value());
}

TEST(AdjustmentCovariance, AHeldLensHasNone) {
    Capture capture = small_scene(0.5);
    BundleAdjustmentOptions options;
    options.refine_lens = false;
    SilentProgress progress;
    fit_bundle(capture, options, progress);
    const auto covariance = adjustment_covariance(capture, options, SilentProgress());
    ASSERT_TRUE(covariance.has_value());
    EXPECT_EQ(covariance->lenses[0], MatrixXd(MatrixXd::Zero(4, 4)));
}

TEST(AdjustmentCovariance, IsNotAskedOfMoreUnknownsThanAllowed) {
    Capture capture = small_scene(0.5);
    SilentProgress progress;
    fit_bundle(capture, least_squares(), progress);
    const int views = static_cast<int>(capture.views.size());
    const auto is_known = [&](int max_unknowns) {
        return adjustment_covariance(capture, least_squares(), progress, max_unknowns).has_value();
    };
    const int shared = static_cast<int>(unknowns_layout(capture, least_squares()).unknowns);
    ASSERT_GT(shared, 6 * views);
    EXPECT_TRUE(is_known(shared));
    EXPECT_FALSE(is_known(shared - 1));
    // The same views, each with a lens of its own.
    const Camera lens = capture.cameras[0];
    capture.cameras.assign(capture.views.size(), lens);
    for (int view = 0; view < views; ++view) {
        capture.views[static_cast<std::size_t>(view)].camera_index = view;
    }
    EXPECT_FALSE(is_known(shared));
    EXPECT_TRUE(is_known(6 * views + (shared - 6 * views) * views));
}

TEST(AdjustmentCovariance, StopsOnRequest) {
    const Capture capture = small_scene(0.5);
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(static_cast<void>(adjustment_covariance(capture, least_squares(), progress)),
                 Error);
}

}  // namespace
}  // namespace lumi
