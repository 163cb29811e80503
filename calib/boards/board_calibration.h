#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/boards/board_bow.h"
#include "calib/boards/lens_certainty.h"
#include "calib/boards/lens_fit.h"
#include "calib/capture/posed_photographs.h"
#include "calib/lens/lens_choice.h"
#include "calib/work/progress.h"

namespace lumi {

struct BoardCalibrationOptions {
    /// Lens models that are tried. Not empty.
    std::vector<LensModel> models{LensModel::kSimplePinhole, LensModel::kPinhole,
                                  LensModel::kSimpleRadial,  LensModel::kRadial,
                                  LensModel::kOpenCv,        LensModel::kFullOpenCv,
                                  LensModel::kOpenCvFisheye};
    /// One standard deviation of the focal length, as a share of it, beyond which the photographs
    /// do not tell it. > 0.
    double max_focal_uncertainty = 0.02;
};

/// A parameter of the lens with its 95 % interval (Student's t).
struct LensParameter {
    std::string name;
    double value = 0.0;
    double sigma = 0.0;  ///< 0: held.
    double low = 0.0;
    double high = 0.0;
};

/// What one photograph contributed.
struct CalibratedView {
    std::string photograph;
    std::size_t points = 0;
    double rms_px = 0.0;  ///< Of distances between predicted and seen.
    /// The same, the lens estimated without this photograph; empty where the others do not
    /// determine it.
    std::optional<double> held_out_rms_px;
    double tilt_deg = 0.0;  ///< Between the board's normal and the line of sight.
};

/// Where a point was seen, and what is left unexplained there.
struct BoardResidual {
    std::size_t view = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Eigen::Vector2d error_px = Eigen::Vector2d::Zero();  ///< Predicted minus seen.
};

struct BoardCalibration {
    Camera lens;
    LensForm form;  ///< Its model, and what measurement could not tell from nothing.
    std::vector<LensParameter> parameters;
    LensChoice choice;                 ///< Every model that was tried.
    std::vector<std::string> dropped;  ///< Parameters within two standard deviations of nothing.
    double size_per_pitch = 0.0;
    std::optional<BoardBend> bow;  ///< Of a board that is not flat, as far as photographs tell.
    double rms_px = 0.0;           ///< Of distances, over all points.
    /// The same; each photograph predicted by the others. Empty where they cannot.
    std::optional<double> held_out_rms_px;
    LensCertainty certainty;
    std::vector<CalibratedView> views;
    std::vector<BoardResidual> residuals;
    std::vector<LeftOut> left_out;  ///< Copies, and photographs whose points agree with no pose.
    std::size_t removed_points = 0;
    double covered_radius = 0.0;  ///< Of the farthest point, as a share of the half diagonal.
    double covered_area = 0.0;    ///< Share of the picture's tenths by tenths with a point.
    std::vector<std::string> warnings;
};

/// The lens from photographs of a board: robust start, refinement with a robust loss, outliers
/// removed, every model fitted, and the one kept that predicts photographs it has not seen as well
/// as the best and with the fewest parameters (see choose_lens); parameters within two standard
/// deviations of nothing go (see supported_lens). Throws Error: E-BOARDS-TOOFEW (photographs or
/// points), E-BOARDS-NOSTART, E-BOARDS-NOFIT (points lie too far from where the board would have
/// them), E-BOARDS-SEVERAL (no lens explains more than half of them), E-BOARDS-FOCAL (they cannot
/// tell the focal length, such as when every board faces the camera), E-INTERRUPTED.
[[nodiscard]] BoardCalibration calibrate_boards(const BoardViews& board,
                                                const BoardCalibrationOptions& options,
                                                Progress& progress);

}  // namespace lumi
