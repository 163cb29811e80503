#pragma once

#include <vector>

#include "calib/capture/capture.h"
#include "pipeline/synth/scene_description.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How far from the middle the bodies of a studio are photographed; they are 0.7 in radius.
inline constexpr double kStudioDistance = 2.6;

/// A few bodies that hide one another from every side.
extern const char* const kBodiesInTheWay;
/// Another one: thin things that stand apart.
extern const char* const kThinThings;
/// One picture on a flat board, with nothing before it; faces +z.
extern const char* const kFlatBoard;

/// Directions that cover the sphere evenly, in a spiral about z that begins at `turn`.
[[nodiscard]] std::vector<Eigen::Vector3d> spiral(int count, double turn);

/// Photographs with exact depth, and what is known of them.
class Studio {
 public:
    explicit Studio(const char* scene);

    void photograph_from(const Rigid3& cam_from_world);
    /// Scene points and the range of depth: once all is photographed.
    void find_points();

    Lumigraph lumigraph;
    Capture capture;

 private:
    SceneDescription description_;
};

/// A scene from so many places on a sphere around it.
[[nodiscard]] Studio from_all_around(const char* scene, int count);

/// All its views, with the camera mesh over them: once their points are found.
[[nodiscard]] Lumigraph with_camera_mesh(const Studio& studio);

/// kFlatBoard from so many places within a disc before it, whatever each of them shows.
[[nodiscard]] Studio before_a_board(int count, double radius);

}  // namespace lumi
