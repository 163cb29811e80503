#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Scenes whose colour and depth along any ray are known in closed form: what the renderer is
/// tested against.
enum class AnalyticScene {
    kCardBeforeWall,  ///< A rectangle at z = 3 before a wall at z = 6.
    kPrintedCard,     ///< The same with a fine pattern on the card.
    kBarBeforeWall,   ///< A bar 0.046 wide and 1.6 long at z = 3 before the wall.
    kPostBehindPost,  ///< Posts along y at z = 3 and z = 4.5 before the wall.
    kBallInSky,       ///< A ball of radius 1 around the origin before an infinitely far sky.
};

/// The Lumigraph with exact depth of a scene photographed by these cameras.
[[nodiscard]] Lumigraph photographed(AnalyticScene scene, const std::vector<Eye>& cameras);

/// What an ideal camera would photograph.
[[nodiscard]] ColorImage ideal_photograph(AnalyticScene scene, const Eye& eye);

/// Looks from `position` at `target`, with "down" nearest to +y.
[[nodiscard]] Eye eye_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
                         const Camera& camera);

/// A ring of eight cameras around one, before the wall (an open mesh); 64 x 48 pixels.
[[nodiscard]] Lumigraph card_before_wall();

/// The same photographs without a surface between them and the scene.
[[nodiscard]] Lumigraph card_without_surface();

/// The same cameras before the printed card, and three close-ups of it, which are in a shell.
[[nodiscard]] Lumigraph card_with_close_ups();

/// Three cameras around the origin. Of what it sees along the z axis, at z = 4.5, the first alone
/// sees anything: the nearer post hides it from the two others, which see the wall behind it.
[[nodiscard]] Lumigraph post_behind_post();

/// Twelve cameras all around the ball, at uneven distances (a closed mesh that is not convex).
[[nodiscard]] Lumigraph ball_in_sky();

}  // namespace lumi
