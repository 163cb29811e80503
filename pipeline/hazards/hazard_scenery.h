#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "pipeline/synth/hashed_random.h"
#include "pipeline/synth/scene.h"

namespace lumi {

/// Rich in detail at the size of a few pixels from three units away.
[[nodiscard]] Material random_material(HashedRandom& random);

/// Upright, turned around its own axis.
[[nodiscard]] Solid box_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
                           double turn_rad = 0.0);

/// What stands before the camera, built body by body: what is not said is drawn by lot.
class HazardScenery {
 public:
    /// The wall faces -y from here.
    static constexpr double kWallY = 1.6;

    explicit HazardScenery(std::uint64_t seed);

    void add(const std::string& name, Solid solid, const Material& material, bool casts_shadow);
    void add_floor();
    void add_wall();
    /// In a row before the wall.
    void add_objects();
    /// A floor, and objects at odd places around the middle.
    void add_surroundings();
    /// Boxes that stand out of the wall by up to `relief`, in front of the middle of the room.
    void add_relief(double relief);

    [[nodiscard]] HashedRandom& random() { return random_; }
    [[nodiscard]] Scene take() { return std::move(scene_); }

 private:
    HashedRandom random_;
    Scene scene_;
};

}  // namespace lumi
