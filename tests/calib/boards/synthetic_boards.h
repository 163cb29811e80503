#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "calib/boards/board_projection.h"
#include "calib/boards/board_views.h"
#include "calib/capture/camera.h"
#include "calib/capture/image.h"

namespace lumi {

/// Poses of a board (in pitches, `columns` by `rows` points) that fills much of the picture, tilted
/// up to `max_tilt_deg` this way and that, different in every photograph; from `seed`.
[[nodiscard]] std::vector<BoardPose> hand_held_poses(const Camera& lens, int columns, int rows,
                                                     int count, double max_tilt_deg,
                                                     std::uint32_t seed);

/// Where a place of the print lies on a board that is not flat: x, y, and away from the camera, all
/// in pitches.
using BentSheet = std::function<Eigen::Vector3d(const Eigen::Vector2d& place)>;
/// A sheet rolled exactly about an axis through `middle`, square to `across` (a unit vector):
/// places keep their distances along it.
[[nodiscard]] BentSheet rolled_sheet(const Eigen::Vector2d& middle, const Eigen::Vector2d& across,
                                     double radius);

/// Exact points of a chessboard with `columns` by `rows` inner corners, flat or on a `sheet`, plus
/// normal noise; points outside the picture are not seen.
[[nodiscard]] BoardViews seen_chessboards(const Camera& lens, int columns, int rows,
                                          const std::vector<BoardPose>& poses, double noise_px,
                                          std::uint32_t seed, const BentSheet& sheet = {});

/// Brightness (0 to 1) of a place on a board, in pitches.
using BoardPrint = std::function<double(const Eigen::Vector2d& place)>;

/// Squares of side 1; inner corners at (0, 0) to (columns - 1, rows - 1); white around.
[[nodiscard]] BoardPrint printed_chessboard(int columns, int rows);
/// Dark squares of side `size` around (0, 0) to (columns - 1, rows - 1).
[[nodiscard]] BoardPrint printed_squares(int columns, int rows, double size);
/// Dark discs around the given centres.
[[nodiscard]] BoardPrint printed_discs(std::vector<Eigen::Vector2d> centres, double diameter);

struct PhotographFaults {
    double blur_px = 0.7;    ///< Standard deviation.
    double noise = 1.0;      ///< Grey levels, standard deviation.
    bool has_glare = false;  ///< A bright spot that burns out part of the picture.
    std::uint32_t seed = 1;
};

/// A photograph of a print by a camera: every pixel is the mean over its area.
[[nodiscard]] GrayImage photograph_of(const BoardPrint& print, const Camera& lens,
                                      const BoardPose& cam_from_board,
                                      const PhotographFaults& faults = {});

/// Where a place on the board is seen.
[[nodiscard]] Eigen::Vector2d seen_at(const Camera& lens, const BoardPose& cam_from_board,
                                      const Eigen::Vector2d& place);
/// The same of a place before or behind the board's plane.
[[nodiscard]] Eigen::Vector2d seen_off_plane(const Camera& lens, const BoardPose& cam_from_board,
                                             const Eigen::Vector3d& place);

}  // namespace lumi
