#include "tests/meshing/cameras/arrangements.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <set>

#include "calib/capture/degrees.h"
#include "calib/capture/rigid3.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/kernel.h"

namespace lumi {
namespace {

class Arrangements : public testing::TestWithParam<ArrangedCapture> {
 protected:
    Arrangements()
        : built_(build_camera_mesh(GetParam().capture, all_views(GetParam().capture), {})) {}

    [[nodiscard]] std::size_t view_count() const { return GetParam().capture.views.size(); }
    [[nodiscard]] bool inside_out() const {
        return built_.evidence.explanation.find("inside out") != std::string::npos;
    }
    /// Where rays to the scene come from in this arrangement.
    [[nodiscard]] Eigen::Vector3d direction_from_scene(std::mt19937& random) const {
        for (;;) {
            const Eigen::Vector3d direction = random_direction(random);
            if (direction.dot(GetParam().side) >
                std::cos(GetParam().spread_deg * kRadiansPerDegree)) {
                return direction;
            }
        }
    }
    /// From a target to where it is looked at from: in a room somewhere near its middle.
    [[nodiscard]] Eigen::Vector3d direction_from(const Eigen::Vector3d& target,
                                                 std::mt19937& random) const {
        if (!inside_out()) return direction_from_scene(random);
        return (0.4 * random_direction(random) - target).normalized();
    }
    /// The scene's points that rays are tried at: those in the kernel, where the theorem holds.
    [[nodiscard]] Points targets() const {
        if (inside_out() || built_.mesh.faces.empty()) return GetParam().scene;
        const auto planes = face_planes(built_.mesh);
        Points inside;
        for (const Eigen::Vector3d& point : GetParam().scene) {
            if (kernel_clearance(planes, point - built_.mesh.scene_centre_in_world) > 0) {
                inside.push_back(point);
            }
        }
        return inside;
    }
    [[nodiscard]] std::optional<std::vector<double>> weights(const Eigen::Vector3d& eye,
                                                             const Eigen::Vector3d& target) const {
        const auto ray = weights_of_ray(built_.mesh, eye, target - eye);
        if (!ray) return std::nullopt;
        return weights_by_view(*ray, view_count());
    }
    static double distance(const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
        return sum;
    }

    BuiltCameraMesh built_;
};

TEST_P(Arrangements, HaveTheirConstructionAndKeepTheirCameras) {
    EXPECT_EQ(built_.mesh.construction, GetParam().construction) << built_.evidence.explanation;
    EXPECT_EQ(built_.evidence.cameras_kept, GetParam().cameras_kept) << built_.evidence.explanation;
    EXPECT_GE(static_cast<int>(targets().size()), GetParam().least_targets)
        << built_.evidence.explanation;
}

TEST_P(Arrangements, WeighARayTheSameFromEveryEyeAndByAtMostThreeCamerasThatSumToOne) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> along(0.1, 9);
    int answered = 0;
    for (const Eigen::Vector3d& target : targets()) {
        for (int i = 0; i < 20; ++i) {
            const Eigen::Vector3d away = direction_from(target, random);
            const auto one = weights(target + along(random) * away, target);
            const auto other = weights(target + along(random) * away, target);
            ASSERT_EQ(one.has_value(), other.has_value());
            if (!one) continue;
            ++answered;
            // The nearest cameras are those of the eye, not of the line.
            if (built_.mesh.construction != MeshConstruction::kNearest) {
                EXPECT_LT(distance(*one, *other), 1e-9);
            }
            double sum = 0;
            int cameras = 0;
            for (const double weight : *one) {
                EXPECT_TRUE(std::isfinite(weight) && weight >= 0);
                sum += weight;
                cameras += weight > 0 ? 1 : 0;
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            EXPECT_LE(cameras, 3);
        }
    }
    // Every ray within the stated side is answered.
    EXPECT_EQ(answered, static_cast<int>(20 * targets().size()));
}

TEST_P(Arrangements, GiveACameraItsOwnRays) {
    std::set<int> kept;
    for (const CameraMesh::Face& face : built_.mesh.faces) {
        for (const int corner : face) {
            kept.insert(built_.mesh.vertices[static_cast<std::size_t>(corner)].view_index);
        }
    }
    const double bound = 1e-9 + built_.evidence.worst_epipole_loss;
    for (const int view : kept) {
        const Eigen::Vector3d centre = centre_in_world(
            GetParam().capture.views[static_cast<std::size_t>(view)].cam_from_world);
        for (const Eigen::Vector3d& target : targets()) {
            if (inside_out() && (target - centre).dot(centre) <= 0) continue;
            const auto own = weights(centre, target);
            ASSERT_TRUE(own.has_value());
            EXPECT_GE((*own)[static_cast<std::size_t>(view)], 1 - bound)
                << GetParam().capture.views[static_cast<std::size_t>(view)].name;
        }
    }
}

/// The eye walks on a great circle about the target and straight through the mesh; wherever the
/// face changes between two steps, the place is narrowed down to rounding, and the weights on both
/// sides must agree.
TEST_P(Arrangements, ChangeTheWeightsContinuouslyAlongPaths) {
    std::mt19937 random(22);
    int changes = 0;
    const auto face_at = [&](const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
        const auto ray = weights_of_ray(built_.mesh, eye, target - eye);
        return ray ? ray->face_index : -2;
    };
    const Points all_targets = targets();
    for (std::size_t path = 0; path < 12 && path < all_targets.size(); ++path) {
        const Eigen::Vector3d& target = all_targets[path];
        const Eigen::Vector3d from = direction_from(target, random);
        const Eigen::Vector3d to = direction_from(target, random);
        const auto eye_at = [&](double t) -> Eigen::Vector3d {
            const Eigen::Quaterniond turn = turn_between(from, to);
            return target + (2.5 + 2 * t) * (Eigen::Quaterniond::Identity().slerp(t, turn) * from);
        };
        constexpr int kSteps = 400;
        for (int step = 0; step < kSteps; ++step) {
            double low = static_cast<double>(step) / kSteps;
            double high = static_cast<double>(step + 1) / kSteps;
            const int face = face_at(eye_at(low), target);
            if (face == face_at(eye_at(high), target)) continue;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (low + high);
                (face_at(eye_at(middle), target) == face ? low : high) = middle;
            }
            const auto before = weights(eye_at(low), target);
            const auto after = weights(eye_at(high), target);
            ASSERT_TRUE(before.has_value() && after.has_value());
            ++changes;
            EXPECT_LT(distance(*before, *after), 1e-6) << "at " << high;
        }
    }
    EXPECT_TRUE(changes > 10 || built_.mesh.faces.size() <= 8);
}

std::string name_of_case(const testing::TestParamInfo<ArrangedCapture>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(OfCameras, Arrangements, testing::ValuesIn(arranged_captures()),
                         name_of_case);

/// Any number of cameras anywhere: no crash, a named construction, weights that are finite and sum
/// to 1, or none.
TEST(AnyCameras, HaveANamedConstructionAndFiniteWeights) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int trial = 0; trial < 60; ++trial) {
        const int count = static_cast<int>(std::pow(1000.0, trial / 59.0));
        const int kind = trial % 6;
        Points centres;
        for (int i = 0; i < count; ++i) {
            Eigen::Vector3d place = random_direction(random) * (0.5 + 2 * uniform(random));
            if (kind == 1) place.z() = 0;
            if (kind == 2) place = Eigen::Vector3d(place.x(), 0, 0);
            if (kind == 3) place = Eigen::Vector3d(3, 0, 0) + 1e-7 * place;
            if (kind == 4)
                place = (i % 2 == 0 ? 3.0 : -2.0) * Eigen::Vector3d::UnitX() + 0.1 * place;
            if (kind == 5) place = place.array().round();
            centres.push_back(place);
        }
        const Capture capture = capture_of(
            centres, Eigen::Vector3d::Zero(),
            points_in_ball(trial % 3 == 0 ? 0 : 100, Eigen::Vector3d::Zero(), 1.0, random));
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        EXPECT_EQ(built.evidence.explanation.find(name_of(built.mesh.construction)), 0U);
        EXPECT_NO_THROW(validate(built.mesh, count, "here"));
        EXPECT_GE(built.evidence.cameras_kept, 1);
        for (int i = 0; i < 50; ++i) {
            const auto weights =
                weights_of_ray(built.mesh, 4 * random_direction(random), random_direction(random));
            if (!weights) continue;
            double sum = 0;
            for (const double weight : weights->weights) {
                EXPECT_TRUE(std::isfinite(weight) && weight >= 0);
                sum += weight;
            }
            EXPECT_NEAR(sum, 1, 1e-12);
        }
    }
}

TEST(Borders, FadeContinuouslyFromTheBorderOutwards) {
    for (const ArrangedCapture& arranged : arranged_captures()) {
        if (arranged.construction != MeshConstruction::kOpen &&
            arranged.construction != MeshConstruction::kLine) {
            continue;
        }
        const BuiltCameraMesh built =
            build_camera_mesh(arranged.capture, all_views(arranged.capture), {});
        const Eigen::Vector3d target = built.mesh.scene_centre_in_world;
        for (const View& view : arranged.capture.views) {
            const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
            const auto at_camera = weights_of_ray(built.mesh, centre, target - centre);
            ASSERT_TRUE(at_camera.has_value());
            EXPECT_NEAR(capture_fade(*at_camera), 1, 1e-9) << arranged.name << " " << view.name;
        }
        // Out over the border, along a circle: never brighter again, no jump.
        const Eigen::Vector3d out = arranged.side.unitOrthogonal();
        double last = 1;
        double least = 1;
        for (int step = 0; step <= 1300; ++step) {
            const double angle = step * 0.1 * kRadiansPerDegree;
            const Eigen::Vector3d eye =
                target + 5 * (std::cos(angle) * arranged.side + std::sin(angle) * out);
            const auto weights = weights_of_ray(built.mesh, eye, target - eye);
            if (!weights) break;
            const double fade = capture_fade(*weights);
            EXPECT_LT(std::abs(fade - last), 0.05) << arranged.name << " at " << angle;
            last = fade;
            least = std::min(least, fade);
        }
        if (arranged.construction == MeshConstruction::kOpen) {
            EXPECT_LT(least, 0.99) << arranged.name;
        }
    }
}

}  // namespace
}  // namespace lumi
