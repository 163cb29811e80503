#include "calib/adjust/adjustment_covariance.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <map>

#include "calib/adjust/bundle_problem.h"
#include "calib/adjust/linearisation.h"

namespace lumi {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kGauge = 7;  ///< Place, attitude and size of the world.

/// The normal equations with the points eliminated, and what moves in the pictures.
struct Reduced {
    MatrixXd normal;             ///< Lower triangle.
    MatrixXd picture_metric;     ///< Mean over each view's points of the squared pixels moved.
    double influence_px2 = 0.0;  ///< Sum of squared residuals, each times its weight squared.
    double slope = 0.0;          ///< Sum over residuals of the mean derivative of what counts.
    double squared_slope = 0.0;
    Index residuals = 0;
    Index points = 0;
};

void add_point(const Linearisation& linearisation, const ScenePoint& point,
               const std::vector<double>& share_of_view, double cauchy_scale_px, Reduced& reduced) {
    std::vector<LinearisedSight> seen;
    Eigen::Matrix3d normal_of_point = Eigen::Matrix3d::Zero();
    std::vector<double> shares;
    for (const Observation& observation : point.track) {
        LinearisedSight linear;
        if (!linearisation.at(point, observation, linear)) continue;
        normal_of_point += linear.by_point.transpose() * linear.by_point;
        seen.push_back(linear);
        shares.push_back(share_of_view[static_cast<std::size_t>(observation.view_index)]);
    }
    const Eigen::LLT<Eigen::Matrix3d> factor(normal_of_point);
    if (seen.size() < 2 || factor.info() != Eigen::Success) return;
    ++reduced.points;

    // Unknowns of this point's cameras, each once, and their coupling with the point.
    std::map<Index, Eigen::RowVector3d> coupling;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const LinearisedSight& linear = seen[i];
        // Cauchy's loss pulls with w r, w = 1 / (1 + |r|^2 / c^2); in the plane the mean derivative
        // of that is w^2.
        const double squared_px2 = linear.residual_px.squaredNorm();
        const double weight = 1 / (1 + squared_px2 / (cauchy_scale_px * cauchy_scale_px));
        reduced.influence_px2 += weight * weight * squared_px2;
        reduced.slope += 2 * weight * weight;
        reduced.squared_slope += 2 * weight * weight * weight * weight;
        reduced.residuals += 2;
        const Index columns = linear.by_camera.cols();
        const Eigen::MatrixXd products = linear.by_camera.transpose() * linear.by_camera;
        for (Index row = 0; row < columns; ++row) {
            const Index r = linear.unknowns[static_cast<std::size_t>(row)];
            for (Index column = 0; column < columns; ++column) {
                const Index c = linear.unknowns[static_cast<std::size_t>(column)];
                if (c > r) continue;
                reduced.normal(r, c) += products(row, column);
                reduced.picture_metric(r, c) += shares[i] * products(row, column);
            }
            const auto entry = coupling.try_emplace(r, Eigen::RowVector3d::Zero()).first;
            entry->second += linear.by_camera.col(row).transpose() * linear.by_point;
        }
    }
    for (const auto& [r, row] : coupling) {
        const Eigen::Vector3d solved = factor.solve(row.transpose());
        for (const auto& [c, column] : coupling) {
            if (c > r) break;
            reduced.normal(r, c) -= column.dot(solved);
        }
    }
}

Reduced reduced_equations(const Capture& capture, const UnknownsLayout& layout,
                          double cauchy_scale_px, const Progress& progress) {
    Reduced reduced;
    reduced.normal = MatrixXd::Zero(layout.unknowns, layout.unknowns);
    reduced.picture_metric = reduced.normal;
    std::vector<double> share_of_view(capture.views.size(), 0.0);
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            share_of_view[static_cast<std::size_t>(seen.view_index)] += 1;
        }
    }
    for (double& share : share_of_view) share = share > 0 ? 1 / share : 0.0;
    const Linearisation linearisation(capture, layout);
    for (const ScenePoint& point : capture.points) {
        progress.throw_if_interrupted();
        add_point(linearisation, point, share_of_view, cauchy_scale_px, reduced);
    }
    for (MatrixXd* matrix : {&reduced.normal, &reduced.picture_metric}) {
        *matrix = matrix->selfadjointView<Eigen::Lower>();
    }
    return reduced;
}

/// Of an M-estimator with its correction for many unknowns (Huber, Robust Statistics, 1981,
/// section 7.6); all weights 1: residuals over redundancy.
double noise_variance_px2(const Reduced& reduced, Index redundancy) {
    const auto residuals = static_cast<double>(reduced.residuals);
    const double mean_slope = reduced.slope / residuals;
    const double slope_variance = reduced.squared_slope / residuals - mean_slope * mean_slope;
    const double share_of_unknowns = 1 - static_cast<double>(redundancy) / residuals;
    const double correction = 1 + share_of_unknowns * slope_variance / (mean_slope * mean_slope);
    return correction * correction * reduced.influence_px2 / static_cast<double>(redundancy) /
           (mean_slope * mean_slope);
}

/// How the poses change when the world is moved, turned and scaled: a step that no pixel notices.
MatrixXd gauge_directions(const Capture& capture, const UnknownsLayout& layout) {
    MatrixXd directions = MatrixXd::Zero(layout.unknowns, kGauge);
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        const Index first = layout.pose_of_view[view];
        if (first < 0) continue;
        const Rigid3& pose = capture.views[view].cam_from_world;
        const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
        directions.block<3, 3>(first, 0) = -rotation;
        directions.block<3, 3>(first + 3, 3) = -rotation;
        directions.block<3, 1>(first + 3, 6) = pose.translation;
    }
    return directions;
}

/// The inverse of the singular normal equations under the inner constraints B^T step = 0, with
/// B = metric * G: (N + B B^T)^-1 - G (G^T B B^T G)^-1 G^T, because N G = 0.
std::optional<MatrixXd> constrained_inverse(const Reduced& reduced, const MatrixXd& gauge) {
    MatrixXd constraints = reduced.picture_metric * gauge;
    for (Index column = 0; column < kGauge; ++column) {
        const double length = constraints.col(column).norm();
        if (!(length > 0)) return std::nullopt;
        constraints.col(column) *= std::sqrt(reduced.normal.diagonal().maxCoeff()) / length;
    }
    // Rotations, translations and lens parameters differ by many powers of ten: unit diagonal.
    MatrixXd regular = reduced.normal + constraints * constraints.transpose();
    const VectorXd scale = regular.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return std::nullopt;
    regular = scale.asDiagonal() * regular * scale.asDiagonal();
    const Eigen::LLT<MatrixXd> factor(regular);
    constexpr double kSingular = 1e-14;
    if (factor.info() != Eigen::Success || !(factor.rcond() > kSingular)) return std::nullopt;
    MatrixXd inverse = factor.solve(MatrixXd::Identity(regular.rows(), regular.cols()));
    inverse = scale.asDiagonal() * inverse * scale.asDiagonal();
    const MatrixXd coupling = constraints.transpose() * gauge;
    const MatrixXd in_gauge = (coupling.transpose() * coupling).ldlt().solve(gauge.transpose());
    return inverse - gauge * in_gauge;
}

MatrixXd lens_covariance(const MatrixXd& covariance, const std::vector<Index>& unknowns) {
    const auto count = static_cast<Index>(unknowns.size());
    MatrixXd result = MatrixXd::Zero(count, count);
    for (Index row = 0; row < count; ++row) {
        for (Index column = 0; column < count; ++column) {
            const Index r = unknowns[static_cast<std::size_t>(row)];
            const Index c = unknowns[static_cast<std::size_t>(column)];
            if (r >= 0 && c >= 0) result(row, column) = covariance(r, c);
        }
    }
    return result;
}

/// Square root of the mean over the view's observations of sigma_u^2 = J Sigma J^T.
std::vector<double> jitter_of_views(const Capture& capture, const UnknownsLayout& layout,
                                    const MatrixXd& covariance, const Progress& progress) {
    std::vector<double> sum_px2(capture.views.size(), 0.0);
    std::vector<double> coordinates(capture.views.size(), 0.0);
    const Linearisation linearisation(capture, layout);
    LinearisedSight linear;
    for (const ScenePoint& point : capture.points) {
        progress.throw_if_interrupted();
        for (const Observation& seen : point.track) {
            if (!linearisation.at(point, seen, linear)) continue;
            const Index columns = linear.by_camera.cols();
            MatrixXd block(columns, columns);
            for (Index row = 0; row < columns; ++row) {
                for (Index column = 0; column < columns; ++column) {
                    block(row, column) =
                        covariance(linear.unknowns[static_cast<std::size_t>(row)],
                                   linear.unknowns[static_cast<std::size_t>(column)]);
                }
            }
            const auto view = static_cast<std::size_t>(seen.view_index);
            sum_px2[view] += (linear.by_camera * block * linear.by_camera.transpose()).trace();
            coordinates[view] += 2;
        }
    }
    std::vector<double> jitter_px;
    for (std::size_t view = 0; view < sum_px2.size(); ++view) {
        jitter_px.push_back(coordinates[view] > 0 ? std::sqrt(sum_px2[view] / coordinates[view])
                                                  : 0.0);
    }
    return jitter_px;
}

}  // namespace

std::optional<AdjustmentCovariance> adjustment_covariance(const Capture& capture,
                                                          const BundleAdjustmentOptions& options,
                                                          const Progress& progress,
                                                          int max_unknowns) {
    const UnknownsLayout layout = unknowns_layout(capture, options);
    if (layout.unknowns < 12 || layout.unknowns > max_unknowns) return std::nullopt;
    const double scale_px = options.robust_last_pass ? cauchy_scale_px(capture)
                                                     : std::numeric_limits<double>::infinity();
    const Reduced reduced = reduced_equations(capture, layout, scale_px, progress);
    const Index redundancy = reduced.residuals - 3 * reduced.points - (layout.unknowns - kGauge);
    if (redundancy <= 0) return std::nullopt;
    std::optional<MatrixXd> covariance =
        constrained_inverse(reduced, gauge_directions(capture, layout));
    progress.throw_if_interrupted();
    if (!covariance) return std::nullopt;
    const double variance_px2 = noise_variance_px2(reduced, redundancy);
    *covariance *= variance_px2;

    AdjustmentCovariance result;
    result.noise_px = std::sqrt(variance_px2);
    for (const Index first : layout.pose_of_view) {
        result.poses.push_back(first < 0 ? Matrix6(Matrix6::Zero())
                                         : Matrix6(covariance->block<6, 6>(first, first)));
    }
    for (const std::vector<Index>& unknowns : layout.lens_unknowns) {
        result.lenses.push_back(lens_covariance(*covariance, unknowns));
    }
    result.jitter_px = jitter_of_views(capture, layout, *covariance, progress);
    return result;
}

}  // namespace lumi
