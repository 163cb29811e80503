#pragma once

#include <filesystem>

#include "calib/ingest/ingest.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// Photographs or video -> working copies and photographs.json in `folder`.
[[nodiscard]] StageEvidence run_ingest_stage(const std::filesystem::path& photographs_or_video,
                                             const IngestOptions& options,
                                             const std::filesystem::path& folder, int threads,
                                             Progress& progress);

}  // namespace lumi
