#include "pipeline/depth_bench/stability_scene.h"

#include <Eigen/Geometry>
#include <array>

#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {
namespace {

constexpr int kWidthPx = 320;
constexpr int kHeightPx = 240;
constexpr double kFocalLengthPx = 300;
constexpr double kBaselineShare = 0.05;  ///< Where that is not the hazard.

/// With detail down to about two pixels.
Material random_material(HashedRandom& random, double gloss) {
    constexpr std::array<Pattern, 3> kPatterns{Pattern::kStone, Pattern::kMarble, Pattern::kWood};
    Material material;
    material.pattern = kPatterns[random.below(kPatterns.size())];
    for (LinearColor& color : material.colors) {
        const double gray = random.between(0.25, 0.9);
        color = linear_from_srgb({static_cast<float>(gray), static_cast<float>(gray),
                                  static_cast<float>(random.between(0.2, 0.9))});
    }
    material.feature_size = random.between(0.2, 0.4);
    material.detail_contrast = random.between(0.5, 0.7);
    material.detail_size = random.between(0.08, 0.15);
    material.gloss = gloss;
    material.seed = static_cast<std::uint32_t>(random.word());
    return material;
}

class SceneBuilder {
 public:
    SceneBuilder(std::uint64_t seed, double gloss) : random_(seed, 1), gloss_(gloss) {
        scene_.lighting.towards_lamp = {random_.between(-0.6, 0.6), -1.0, 0.7};
        scene_.lighting.contact_radius = 0.0;
    }

    /// Upright boxes face the cameras; `depth` is of the face.
    void add_board(double x, double z, double depth, double width, double height) {
        constexpr double kThickness = 0.02;
        add(Box{{{x, depth + 0.5 * kThickness, z}, Eigen::Matrix3d::Identity()},
                0.5 * Eigen::Vector3d(width, kThickness, height),
                0.0});
    }
    /// A little aslant: no surface is a plane of constant depth by chance.
    void add_wall() {
        const double turn = random_.between(-0.15, 0.15);
        add(Box{{{0, kWallDistance + 0.5, 0},
                 Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix()},
                {20, 0.5, 20},
                0.0});
    }
    void add_objects() {
        constexpr int kObjects = 6;
        for (int i = 0; i < kObjects; ++i) {
            const double size = random_.between(0.25, 0.45);
            const double depth = random_.between(0.6, 0.85) * kWallDistance;
            const Eigen::Vector3d centre(depth * (0.16 * i - 0.4 + random_.between(-0.04, 0.04)),
                                         depth, depth * random_.between(-0.28, 0.28));
            const Placement turned{
                centre, Eigen::AngleAxisd(random_.between(-0.8, 0.8), Eigen::Vector3d::UnitZ())
                            .toRotationMatrix()};
            if (i % 2 == 0) {
                add(Box{turned, Eigen::Vector3d(size, 0.6 * size, 0.8 * size), 0.0});
            } else {
                add(Ellipsoid{turned, Eigen::Vector3d(0.8, 0.6, 1.0) * size});
            }
        }
    }
    [[nodiscard]] HashedRandom& random() { return random_; }
    [[nodiscard]] Scene take() { return std::move(scene_); }

 private:
    void add(Solid solid) {
        scene_.materials.push_back(random_material(random_, gloss_));
        scene_.bodies.emplace_back("body", static_cast<int>(scene_.materials.size()) - 1,
                                   std::vector{std::move(solid)}, 0.0, false);
    }

    HashedRandom random_;
    double gloss_;
    Scene scene_;
};

void add_bars(double width_px, SceneBuilder& builder) {
    constexpr int kBars = 8;
    constexpr double kDepth = 0.75 * kWallDistance;
    for (int i = 0; i < kBars; ++i) {
        const double x = kDepth * (0.12 * i - 0.42 + builder.random().between(-0.02, 0.02));
        builder.add_board(x, 0, kDepth, width_px * kDepth / kFocalLengthPx, 20);
    }
}

/// Boards that stand out of the wall by so many pixels of disparity between the outermost cameras.
void add_steps(double step_px, SceneBuilder& builder) {
    const double disparity_px = kFocalLengthPx * 2 * kBaselineShare * kWallDistance;
    const double depth = 1.0 / (1.0 / kWallDistance + step_px / disparity_px);
    for (const double column : {-0.3, 0.02, 0.34}) {
        for (const double row : {-0.22, 0.2}) {
            const double x = depth * (column + builder.random().between(-0.03, 0.03));
            const double z = depth * (row + builder.random().between(-0.03, 0.03));
            builder.add_board(x, z, depth, 0.18 * depth, 0.22 * depth);
        }
    }
}

}  // namespace

Scene stability_scene(DepthHazard hazard, double strength, std::uint64_t seed) {
    SceneBuilder builder(seed, hazard == DepthHazard::kGloss ? strength : 0.0);
    builder.add_wall();
    if (hazard == DepthHazard::kThin) {
        add_bars(strength, builder);
    } else if (hazard == DepthHazard::kSteps) {
        add_steps(strength, builder);
    } else {
        builder.add_objects();
    }
    return builder.take();
}

Capture stability_cameras(DepthHazard hazard, double strength) {
    const double baseline =
        kWallDistance * (hazard == DepthHazard::kBaseline ? strength : kBaselineShare);
    const Eigen::Vector3d target(0, kWallDistance, 0);
    Capture capture;
    capture.cameras = {pinhole_camera(kWidthPx, kHeightPx, kFocalLengthPx)};
    for (const auto& [x, z] : {std::pair{0.0, 0.0},
                               {-baseline, 0.0},
                               {baseline, 0.0},
                               {0.0, baseline},
                               {0.0, -baseline}}) {
        // Towards the target: wide baselines keep the scene in sight.
        capture.views.push_back({"view" + std::to_string(capture.views.size()) + ".png", 0,
                                 looking_at(Eigen::Vector3d(x, 0, z), target)});
    }
    return capture;
}

}  // namespace lumi
