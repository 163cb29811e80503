#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// The best of the models a mapper run left in `models`, by registered photographs, then by
/// points; with the photographs' own names. Empty when there is none.
struct BestModel {
    Capture capture;
    int models_found = 0;
};
[[nodiscard]] std::optional<BestModel> read_best_model(const std::filesystem::path& models,
                                                       const std::vector<Photograph>& photographs);

/// Runs COLMAP's mapper from strict to gentle until nearly all photographs are placed, and returns
/// the best model of all runs; empty when no run made one. The last rung matches again with more
/// features; where its model is taken, `matched` is replaced. Throws Error (E-COLMAP-TIME) when no
/// run made a model and one of them had to be ended.
[[nodiscard]] std::optional<Capture> map_by_ladder(const MappingJob& job,
                                                   MatchedPhotographs& matched);

}  // namespace lumi
