#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "calib/doctor/capture_reason.h"
#include "calib/doctor/diagnosis.h"

namespace lumi {

/// What is wrong with one picture, if anything: kExposure, kNoise, kTexture or kBlur.
[[nodiscard]] std::optional<CaptureReason> trouble_with(const PhotographQuality& quality);

/// "noisy: 3 of 40 photographs, ...": so many of all are `concerned`.
[[nodiscard]] std::string picture_trouble_text(CaptureReason reason,
                                               const CaptureEvidence& evidence,
                                               std::size_t concerned);

}  // namespace lumi
