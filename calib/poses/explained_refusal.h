#pragma once

#include <string>
#include <vector>

#include "calib/doctor/diagnosis.h"
#include "calib/ingest/ingest.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// What the doctor would have seen, from what the pose stage has found out; `matched` may be empty
/// (no photographs) when not even pairs came out.
[[nodiscard]] CaptureEvidence evidence_of(const MappingJob& job, const MatchedPhotographs& matched);

/// Throws Error (E-POSES-...) for what the evidence names as the worst trouble; `fallback` with
/// `what` when it names none.
[[noreturn]] void refuse_explained(const MappingJob& job, const MatchedPhotographs& matched,
                                   CaptureReason fallback, const std::string& what);

/// The same where matches contradict one another, or are too few in places: only what spoils
/// matches explains that, or, where nothing better than kUncertain is known, a walk straight ahead.
/// Throws Error (E-POSES-...) for poor pictures, clutter or such a walk, else for `fallback`.
[[noreturn]] void refuse_contradiction(const MappingJob& job, const MatchedPhotographs& matched,
                                       CaptureReason fallback, const std::string& what);

}  // namespace lumi
