#pragma once

#include <string>

#include "calib/colmap/colmap_commands.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// Features and verified pairs by COLMAP's own extractor and matcher, all photographs with all; the
/// pairs are not judged yet.
[[nodiscard]] MatchedPhotographs match_with_colmap_alone(const MappingJob& job,
                                                         FeatureDetail detail,
                                                         const std::string& name);

/// How COLMAP runs for this job.
[[nodiscard]] ColmapProgram colmap_of(const MappingJob& job);
/// Adds the command of a run to the evidence, and what it cost.
void record(PoseEvidence& evidence, const ColmapRun& run);
/// Throws Error (E-COLMAP-TIME) unless COLMAP's `command` exited: a limit or a signal ended it.
void expect_ended(const ColmapRun& run, const MappingJob& job, const std::string& command);

}  // namespace lumi
