#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/ingest/ingest.h"
#include "calib/lens/lens_choice.h"
#include "calib/poses/residual_pattern.h"
#include "calib/work/config_section.h"
#include "calib/work/progress.h"

namespace lumi {

/// Whose program does a step.
enum class PoseProgram { kLumi, kColmap };

/// As configurations name it: "lumi" or "colmap".
[[nodiscard]] std::string_view name_of(PoseProgram program);

/// How poses are found.
struct PoseOptions {
    /// What is estimated when no lens is given: a model, or "auto" (as the photographs support).
    std::string lens_model = "auto";
    bool shared_lens = true;  ///< One lens for photographs of one camera and zoom.
    bool refine_lens = true;  ///< Refine a given lens where held-out photographs ask for it.
    int max_features = 4096;  ///< Per photograph. > 0.
    double max_reprojection_error_px = 2.0;      ///< Observations beyond this are outliers. > 0.
    int min_track_length = 2;                    ///< Points seen by fewer views are dropped. >= 2.
    double min_registered_share = 0.4;           ///< Below this share the stage refuses. (0, 1].
    double time_limit_s = 3600;                  ///< For each external program. > 0.
    PoseProgram front_end = PoseProgram::kLumi;  ///< Finds features and matches.
    PoseProgram mapper = PoseProgram::kLumi;     ///< Places photographs.
    std::string colmap = "colmap";               ///< The program to run for COLMAP.
    /// Masks of what holds still while the camera moves, as in drawn_mask; empty: everything does.
    std::filesystem::path mask_folder = {};
};

/// While fewer of the photographs than this are placed, the mapper tries harder; what is then made
/// of them is a part of what was photographed.
inline constexpr double kEnoughPlacedShare = 0.8;

void validate(const PoseOptions& options);
[[nodiscard]] PoseOptions read_pose_options(const ConfigSection& section);

/// One run of COLMAP, as it was.
struct ColmapCall {
    std::string command_line;
    double wall_s = 0.0;
    double cpu_s = 0.0;
};

/// A lens after the refinement. Entries belong to those of Capture::cameras.
struct LensEvidence {
    LensForm form;
    int views = 0;
    std::vector<double> sigma;         ///< Standard deviation of each parameter; 0 where held.
    std::optional<LensChoice> choice;  ///< What was compared; empty when nothing was.
    /// Parameters within two standard deviations of nothing, and principal points that pictures do
    /// not agree on.
    std::vector<std::string> dropped;
};

/// How far the estimate of a view may be off: one standard deviation, by adjustment_covariance,
/// wider where residuals have a shape (see refine), and attitudes wider where each picture seems to
/// have a middle of its own (E-POSES-SHIFTED).
struct ViewUncertainty {
    std::string name;
    double jitter_px = 0.0;       ///< Of the scene's picture in this view, one coordinate.
    double position_sigma = 0.0;  ///< Of the optical centre, in units of the world.
    double rotation_sigma_deg = 0.0;
};

/// What speaks for the poses.
struct PoseEvidence {
    int photographs_total = 0;
    int photographs_registered = 0;
    int points = 0;
    int observations = 0;
    double mean_reprojection_error_px = 0.0;
    double median_triangulation_angle_deg = 0.0;
    int models_found = 0;  ///< Separate models that the mapper ended with.
    std::string start;     ///< Which attempt at mapping succeeded.
    int pairs_verified = 0;
    double planar_or_rotation_share = 0.0;  ///< Verified pairs that a homography explains.
    double noise_px = 0.0;                  ///< Of one observed coordinate; 0: not known.
    std::vector<LensEvidence> lenses;
    std::vector<ViewUncertainty> views;  ///< Empty: not known.
    ResidualPattern residual_pattern;    ///< Of the adjusted model.
    double contradicted_share = 0.0;  ///< Of the matches in verified pairs: the model denies them.
    std::vector<ColmapCall> calls;
    std::vector<std::string> warnings;  ///< What to know before trusting these poses.
};

struct PoseResult {
    Capture capture;  ///< With lens distortion, in the pixels of the working copies.
    std::vector<LeftOut> not_registered;
    PoseEvidence evidence;
};

/// Where the photographs stood: from features and geometry by our own front end and mapper (or by
/// COLMAP's as a child process, every result verified), and a robust bundle adjustment.
/// `given_lens`, when present, is the lens of all photographs (for the size it names; it is
/// rescaled). `scratch_folder` is emptied and used.
///
/// Throws Error: E-POSES-FEW (fewer than two photographs were given, or fewer could be placed than
/// the share), E-POSES-... with the code of the CaptureReason that explains best why the
/// photographs do not tell where they were taken, E-ADJUST-..., E-COLMAP-... and E-CHILD-... when
/// the program itself failed, E-INTERRUPTED.
[[nodiscard]] PoseResult estimate_poses(const std::vector<Photograph>& photographs,
                                        const std::optional<Camera>& given_lens,
                                        const PoseOptions& options,
                                        const std::filesystem::path& scratch_folder, int threads,
                                        Progress& progress);

/// Poses from elsewhere instead: a COLMAP model folder, `transforms.json`, `poses_bounds.npy`, a
/// Middlebury `*_par.txt` or a folder of Strecha `.camera` files, by content. Photographs are
/// matched by name (or by stem where the format has none), lenses are rescaled to the working
/// copies, and points without a track are kept. Poses without names are those of all pictures in
/// the order of their names, also of those that ingest has `left_out`. Throws Error (E-IMPORT-...)
/// naming file and line; E-IMPORT-SIZE when the lens describes pictures of another shape than those
/// on disk.
[[nodiscard]] PoseResult import_poses(const std::vector<Photograph>& photographs,
                                      const std::vector<LeftOut>& left_out,
                                      const std::filesystem::path& poses);

}  // namespace lumi
