#pragma once

#include <optional>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/adjust/held_out_views.h"
#include "calib/capture/capture.h"
#include "calib/lens/lens_choice.h"

namespace lumi {

struct LensSelectionOptions {
    HeldOutViewsOptions held_out;
    /// Forms are compared on the points that cover the pictures best, up to about so many
    /// observations a view and in all. Thinned out, they are closer to independent than features
    /// that crowd together, and more of them would make the choice no firmer than the number of
    /// views allows. > 0.
    int max_observations_per_view = 250;
    int max_observations = 8000;
    int min_views = 5;  ///< Of the camera: with fewer, nothing can be held out. >= 3.
};

/// Every lens model, with the principal point in the middle and refined.
[[nodiscard]] std::vector<LensForm> every_lens_form();

/// For a lens that was given: as it is, or with parameters refined.
[[nodiscard]] std::vector<LensForm> forms_of_given_lens(LensModel model);

/// Which of `forms` the photographs of camera `camera_index` support, by prediction of views that
/// took no part (predict_held_out_views) and choose_lens. `capture` is adjusted already, and free
/// of gross outliers; the other lenses keep what `adjustment` holds of them. Parameters that a form
/// holds start from the camera of `capture` where it has them.
///
/// All forms are fitted to everything, each from the best fit that is nested in it. Only those that
/// may still win are then cross-validated: none with more parameters than the one of least BIC,
/// which asks for less evidence than held-out error does, and none that predicts worse surely.
/// Empty when the camera has fewer than `min_views` views, or when no form can be fitted. Throws
/// Error (E-INTERRUPTED).
[[nodiscard]] std::optional<LensChoice> select_lens(const Capture& capture, int camera_index,
                                                    const std::vector<LensForm>& forms,
                                                    const BundleAdjustmentOptions& adjustment,
                                                    const LensSelectionOptions& options,
                                                    int threads, Progress& progress);

/// The points that cover the pictures best with about `max_observations` observations: long tracks
/// first, as long as they fall into a part of some picture where there is no more than a fair share
/// yet. The same points for the same capture.
[[nodiscard]] Capture representative_part(const Capture& capture, int max_observations);

}  // namespace lumi
