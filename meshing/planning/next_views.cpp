#include "meshing/planning/next_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/work/error.h"
#include "calib/work/median.h"
#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/forward_motion.h"
#include "meshing/cameras/preconditions.h"
#include "meshing/cameras/scene_centre.h"

namespace lumi {
namespace {

constexpr double kLeastStep = 0.01;

/// Looks along `forward` (of length one) with "up" in the picture as near to `up` as that allows.
Rigid3 upright_pose(const Eigen::Vector3d& centre, const Eigen::Vector3d& forward,
                    const Eigen::Vector3d& up) {
    Eigen::Vector3d rightward = forward.cross(up);
    if (rightward.norm() < 1e-6) rightward = forward.unitOrthogonal();
    rightward.normalize();
    Eigen::Matrix3d rows;
    rows << rightward.transpose(), forward.cross(rightward).transpose(), forward.transpose();
    Rigid3 pose{Eigen::Quaterniond(rows).normalized(), Eigen::Vector3d::Zero()};
    pose.translation = -(pose.rotation * centre);
    return pose;
}

/// The capture in the making: photographs that were taken, and those that are planned.
class Planner {
 public:
    Planner(const Capture& capture, const std::vector<int>& view_indices)
        : capture_(capture),
          view_indices_(view_indices),
          axes_(optical_axes(capture, view_indices)),
          centre_(estimate_scene_centre(axes_)),
          arrangement_(arrange(camera_star(axes_, centre_))) {
        if (arrangement_.construction == MeshConstruction::kSingle || forward_motion(axes_)) {
            throw Error(ErrorKind::kDegenerateCapture, "E-PLAN-ONESPOT",
                        "all cameras stand in one direction from the scene: nothing lies between "
                        "them that could be planned",
                        "step sideways between photographs, about a tenth of the distance to the "
                        "subject");
        }
        const double facing = share_that_faces(capture, axes_, centre_, arrangement_.inside_out);
        if (const auto why = why_no_surface({.share_that_faces_scene = facing})) {
            throw Error(ErrorKind::kDegenerateCapture, "E-PLAN-NOSURFACE",
                        "the cameras have no surface with gaps to plan in: " + *why,
                        "photograph again, from places in between, what few photographs show");
        }
        uncertainty_ = depth_uncertainty(capture, view_indices, camera_star(axes_, centre_));
    }

    [[nodiscard]] const DepthUncertainty& uncertainty() const { return uncertainty_; }

    [[nodiscard]] std::vector<Hole> holes() const {
        return holes_between(camera_star(axes_, centre_), in_a_row(), arrangement_.strip_normal,
                             uncertainty_);
    }

    /// A rough count: errors fall with the spacing, and cameras rise with its inverse in a row
    /// and with its inverse square on a surface.
    [[nodiscard]] double count_by_spacing(double wished_error_px) const {
        const std::vector<Hole> all = holes();
        if (all.empty()) return 0;
        const double finer = all[all.size() / 2].error_px / wished_error_px;
        const auto cameras = static_cast<double>(axes_.size());
        return cameras * (in_a_row() ? finer : finer * finer);
    }

    [[nodiscard]] Eigen::Vector3d place_of(const Hole& hole) const {
        return centre_ + hole.distance * hole.direction;
    }

    void add(const Hole& hole) {
        axes_.push_back({static_cast<int>(capture_.views.size()), place_of(hole), sight_at(hole),
                         subject_distance(hole)});
    }

    [[nodiscard]] SuggestedView suggestion_at(const Hole& hole) const {
        const Eigen::Vector3d place = place_of(hole);
        std::vector<int> nearest = view_indices_;
        const auto distance = [&](int view) {
            return (centre_in_world(pose_of(view)) - place).norm();
        };
        const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, nearest.size()));
        std::partial_sort(nearest.begin(), nearest.begin() + count, nearest.end(),
                          [&](int a, int b) { return distance(a) < distance(b); });
        SuggestedView suggested;
        suggested.error_px = hole.error_px;
        Eigen::Vector3d up = Eigen::Vector3d::Zero();
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            const int view = nearest[static_cast<std::size_t>(i)];
            up -= pose_of(view).rotation.conjugate() * Eigen::Vector3d::UnitY();
            suggested.nearest_views[static_cast<std::size_t>(i)] = view;
            suggested.steps[static_cast<std::size_t>(i)] =
                steps_in_words(pose_of(view), place, subject_distance(hole));
        }
        suggested.cam_from_world = upright_pose(place, sight_at(hole), up);
        return suggested;
    }

 private:
    /// Where a photograph from there looks, of length one.
    [[nodiscard]] Eigen::Vector3d sight_at(const Hole& hole) const {
        return arrangement_.inside_out ? hole.direction : Eigen::Vector3d(-hole.direction);
    }
    /// Inside out the subject lies beyond the cameras, where the usual one sees it.
    [[nodiscard]] double subject_distance(const Hole& hole) const {
        if (!arrangement_.inside_out) return hole.distance;
        std::vector<double> depths;
        for (const OpticalAxis& axis : axes_) {
            if (axis.depth > 0) depths.push_back(axis.depth);
        }
        return depths.empty() ? hole.distance : median_of(std::move(depths));
    }
    [[nodiscard]] bool in_a_row() const {
        return arrangement_.construction == MeshConstruction::kLine ||
               arrangement_.construction == MeshConstruction::kPair;
    }
    [[nodiscard]] const Rigid3& pose_of(int view) const {
        return capture_.views[static_cast<std::size_t>(view)].cam_from_world;
    }

    const Capture& capture_;
    const std::vector<int>& view_indices_;
    std::vector<OpticalAxis> axes_;
    Eigen::Vector3d centre_;
    Arrangement arrangement_;
    DepthUncertainty uncertainty_;
};

/// How many photographs the wish takes.
int count_for_wish(Planner planner, double wished_error_px) {
    if (!(wished_error_px > 0)) return 0;
    if (planner.count_by_spacing(wished_error_px) > 4 * kMostPlanned) return -1;
    for (int added = 0; added <= kMostPlanned; ++added) {
        const std::vector<Hole> holes = planner.holes();
        if (holes.empty()) return -1;
        if (holes.front().error_px <= wished_error_px) return added;
        planner.add(holes.front());
    }
    return -1;
}

}  // namespace

CapturePlan plan_capture(const Capture& capture, const std::vector<int>& view_indices,
                         const CapturePlanOptions& options) {
    if (view_indices.empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-MESH-NOVIEW", "no view has a pose",
                    "register more photographs first");
    }
    Planner planner(capture, view_indices);
    CapturePlan plan;
    plan.uncertainty = planner.uncertainty();
    plan.holes = planner.holes();
    plan.photographs_for_wish = count_for_wish(planner, options.wished_error_px);
    std::vector<Hole> holes = plan.holes;
    for (int i = 0; i < options.suggestions && !holes.empty(); ++i) {
        plan.suggestions.push_back(planner.suggestion_at(holes.front()));
        planner.add(holes.front());
        holes = planner.holes();
        plan.suggestions.back().worst_error_after_px = holes.empty() ? 0.0 : holes.front().error_px;
    }
    return plan;
}

std::string steps_in_words(const Rigid3& cam_from_world, const Eigen::Vector3d& goal_in_world,
                           double subject_distance) {
    const Eigen::Vector3d step = (cam_from_world * goal_in_world) / subject_distance;
    const std::array<std::array<const char*, 2>, 3> kWords{
        {{"left", "right"}, {"up", "down"}, {"back", "closer"}}};
    std::string text;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (std::abs(step[axis]) < kLeastStep) continue;
        text += text.empty() ? "go " : ", ";
        text += kWords[static_cast<std::size_t>(axis)][step[axis] > 0 ? 1 : 0];
        text += " by " + std::to_string(std::lround(100 * std::abs(step[axis]))) + " %";
    }
    return text.empty() ? "stay there" : text + " of the distance to the subject";
}

}  // namespace lumi
