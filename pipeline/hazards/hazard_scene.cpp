#include "pipeline/hazards/hazard_scene.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "calib/capture/degrees.h"
#include "pipeline/hazards/hazard_scenery.h"
#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {
namespace {

constexpr int kWidthPx = 400;
constexpr int kHeightPx = 300;
constexpr int kPhotographs = 8;

/// A path and the lens it is photographed with.
class Walk {
 public:
    explicit Walk(std::uint64_t seed)
        : random_(seed, 2), focal_length_px_(random_.between(0.85, 1.3) * kWidthPx) {}

    void stand(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, double zoom = 1.0) {
        cameras_.push_back(pinhole_camera(kWidthPx, kHeightPx, zoom * focal_length_px_));
        poses_.push_back(looking_at(eye, target));
    }
    [[nodiscard]] double focal_length_px() const { return focal_length_px_; }
    /// A hand is never steady: up to `amount` world units in each direction.
    [[nodiscard]] Eigen::Vector3d sway(double amount) {
        const double x = random_.symmetric();
        const double y = random_.symmetric();
        return amount * Eigen::Vector3d(x, y, random_.symmetric());
    }
    [[nodiscard]] HazardScene with(Scene scene) {
        return {std::move(scene), std::move(cameras_), std::move(poses_)};
    }

 private:
    HashedRandom random_;
    double focal_length_px_;
    std::vector<Camera> cameras_;
    std::vector<Rigid3> poses_;
};

Scene room(std::uint64_t seed) {
    HazardScenery scenery(seed);
    scenery.add_floor();
    scenery.add_wall();
    scenery.add_objects();
    return scenery.take();
}

/// From -0.5 to 0.5 over the photographs of a walk.
double part(int index, int count = kPhotographs) {
    return static_cast<double>(index) / (count - 1) - 0.5;
}

/// An arc of 50 degrees around the objects, three units away, in two heights.
HazardScene good_path(std::uint64_t seed, double zoom = 1.0, int places = kPhotographs) {
    Walk walk(seed);
    const Eigen::Vector3d target(0, 0.3, 0.5);
    std::vector<Eigen::Vector3d> eyes;
    for (int place = 0; place < places; ++place) {
        const double azimuth = 50 * kRadiansPerDegree * (places == 1 ? 0.0 : part(place, places));
        const double height = place % 2 == 0 ? 1.0 : 1.6;
        eyes.push_back(
            Eigen::Vector3d(3.2 * std::sin(azimuth), 0.3 - 3.2 * std::cos(azimuth), height) +
            walk.sway(0.06));
    }
    for (int index = 0; index < kPhotographs; ++index) {
        const auto place = static_cast<std::size_t>(index * places / kPhotographs);
        walk.stand(eyes[place], target, index % 2 == 0 ? 1.0 : zoom);
    }
    return walk.with(room(seed));
}

HazardScene baseline(std::uint64_t seed, double step_share) {
    Walk walk(seed);
    constexpr double kDistance = 3.2;
    for (int index = 0; index < kPhotographs; ++index) {
        const double along = step_share * kDistance * part(index) * (kPhotographs - 1);
        const Eigen::Vector3d eye =
            Eigen::Vector3d(along, 0.3 - kDistance, 1.2) + walk.sway(0.2 * step_share * kDistance);
        walk.stand(eye, eye + Eigen::Vector3d(0, kDistance, -0.5) + walk.sway(0.06));
    }
    return walk.with(room(seed));
}

HazardScene rotation(std::uint64_t seed, double way_share) {
    Walk walk(seed);
    for (int index = 0; index < kPhotographs; ++index) {
        const double turn = 40 * kRadiansPerDegree * part(index);
        const Eigen::Vector3d eye =
            Eigen::Vector3d(3.2 * way_share * part(index), -2.9, 1.2) + walk.sway(0.03 * way_share);
        walk.stand(eye,
                   eye + Eigen::Vector3d(std::sin(turn), std::cos(turn), -0.12) + walk.sway(0.02));
    }
    return walk.with(room(seed));
}

HazardScene planarity(std::uint64_t seed, double relief_share) {
    constexpr double kDistance = 3.2;
    HazardScenery scenery(seed);
    scenery.add_wall();
    scenery.add_relief(relief_share * kDistance);
    Walk walk(seed);
    const Eigen::Vector3d target(0, HazardScenery::kWallY, 2.0);
    for (int index = 0; index < kPhotographs; ++index) {
        const double azimuth = 50 * kRadiansPerDegree * part(index);
        const Eigen::Vector3d eye =
            target + kDistance * Eigen::Vector3d(std::sin(azimuth), -std::cos(azimuth), 0) +
            Eigen::Vector3d(0, 0, index % 2 == 0 ? -0.4 : 0.4) + walk.sway(0.06);
        walk.stand(eye, target + walk.sway(0.1));
    }
    return walk.with(scenery.take());
}

/// Two groups along the wall; the two photographs that face each other across the gap share a
/// strip of the wall's width, and less of what stands before it.
HazardScene overlap(std::uint64_t seed, double share) {
    Walk walk(seed);
    constexpr double kEyeY = -3.1;
    constexpr double kStep = 0.3;
    const double frame_width = kWidthPx / walk.focal_length_px() * (HazardScenery::kWallY - kEyeY);
    const double gap = (1.0 - share) * frame_width;
    for (int index = 0; index < kPhotographs; ++index) {
        const int half = index / (kPhotographs / 2);
        const int place = index % (kPhotographs / 2);
        const double along =
            half == 0 ? -0.5 * gap - kStep * (3 - place) : 0.5 * gap + kStep * place;
        const Eigen::Vector3d eye = Eigen::Vector3d(along, kEyeY, 1.2) + walk.sway(0.08);
        walk.stand(eye, eye + Eigen::Vector3d(0, 3.4, -0.5) + walk.sway(0.04));
    }
    return walk.with(room(seed));
}

/// Once around a box whose four sides look alike. A mark of the given width (of a side) sticks to
/// one of them; from 1 on, a floor and objects that look different everywhere are in view as well.
HazardScene repetition(std::uint64_t seed, double mark_share, int photographs = 16) {
    HazardScenery scenery(seed);
    const bool has_surroundings = mark_share >= 1.0;
    const double side = has_surroundings ? 1.0 : 2.0;
    if (has_surroundings) scenery.add_surroundings();
    Material sides = random_material(scenery.random());
    sides.pattern = Pattern::kStone;
    sides.copies_around = 4;
    scenery.add("box", box_at({0, 0, 0.5 * side}, {side, side, side}), sides, false);
    const Material mark = random_material(scenery.random());
    const double width = std::min(mark_share, 0.9) * side;
    if (width > 0) {
        scenery.add("mark", box_at({0, -0.5 * side - 0.005, 0.5 * side}, {width, 0.01, width}),
                    mark, false);
    }
    Walk walk(seed);
    for (int index = 0; index < photographs; ++index) {
        const double azimuth = 2 * std::numbers::pi * index / photographs;
        const double distance = has_surroundings ? 5.0 : 4.2;
        const Eigen::Vector3d eye =
            Eigen::Vector3d(distance * std::sin(azimuth), -distance * std::cos(azimuth),
                            has_surroundings ? 2.6 : 1.7) +
            walk.sway(0.08);
        walk.stand(eye, Eigen::Vector3d(0, 0, 0.9) + walk.sway(0.05));
    }
    return walk.with(scenery.take());
}

HazardScene forward(std::uint64_t seed, double sideways_share) {
    Walk walk(seed);
    constexpr double kWay = 1.6;
    for (int index = 0; index < kPhotographs; ++index) {
        const double sideways = sideways_share * kWay * part(index) * (index % 2 == 0 ? 1 : -1);
        const Eigen::Vector3d eye(sideways, -3.2 + kWay * part(index), 1.0);
        const Eigen::Vector3d held = eye + walk.sway(0.01 * sideways_share);
        walk.stand(held, Eigen::Vector3d(0, 1.6, 0.7));
    }
    return walk.with(room(seed));
}

/// By a lens whose focal length the focus makes longer, by up to so many per cent, at random.
HazardScene through_moving_focus(HazardScene scene, double most_percent, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> percent(0.0, most_percent);
    for (Camera& camera : scene.cameras) {
        const double focal_px = focal_length_px(camera).mean();
        camera = pinhole_camera(camera.width_px, camera.height_px,
                                focal_px * (1 + (most_percent > 0 ? percent(random) : 0.0) / 100));
    }
    return scene;
}

/// By a lens that bends angles evenly, to so many degrees in the corners.
HazardScene through_fisheye(HazardScene scene, double corner_deg) {
    for (Camera& camera : scene.cameras) {
        const double corner_px = 0.5 * std::hypot(camera.width_px, camera.height_px);
        const double focal_px = corner_px / (corner_deg * kRadiansPerDegree);
        camera = {camera.width_px,
                  camera.height_px,
                  LensModel::kOpenCvFisheye,
                  {focal_px, focal_px, 0.5 * camera.width_px, 0.5 * camera.height_px, 0, 0, 0, 0}};
    }
    return scene;
}

}  // namespace

HazardScene hazard_scene(Hazard hazard, double strength, std::uint64_t seed) {
    switch (hazard) {
        case Hazard::kBaseline:
            return baseline(seed, strength);
        case Hazard::kRotation:
            return rotation(seed, strength);
        case Hazard::kPlanarity:
            return planarity(seed, strength);
        case Hazard::kOverlap:
            return overlap(seed, strength);
        case Hazard::kRepetition:
            return repetition(seed, strength);
        case Hazard::kSteps:
            return repetition(seed, 0.0, static_cast<int>(std::lround(360.0 / strength)));
        case Hazard::kForward:
            return forward(seed, strength);
        case Hazard::kFisheye:
            return through_fisheye(good_path(seed), strength);
        case Hazard::kZoom:
            return good_path(seed, strength);
        case Hazard::kFocus:
            return through_moving_focus(good_path(seed), strength, seed);
        case Hazard::kDuplicates:
            return good_path(seed, 1.0, static_cast<int>(strength));
        case Hazard::kTexture:
        case Hazard::kNoise:
        case Hazard::kBlur:
        case Hazard::kShutter:
        case Hazard::kExposure:
        case Hazard::kClutter:
        case Hazard::kFocalPrior:
            return good_path(seed);
    }
    return good_path(seed);
}

}  // namespace lumi
