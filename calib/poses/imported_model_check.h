#pragma once

#include <string>

#include "calib/capture/capture.h"

namespace lumi {

/// What imported poses say without a look at photographs. Throws Error: E-IMPORT-ONEPLACE where all
/// of several cameras stand at one place; E-IMPORT-DENIED where the points that came with them, if
/// they are observed often enough, lie behind their cameras or far beside where these saw them.
void expect_consistent(const Capture& capture);

/// How far a point may be seen from where poses put it before these are denied: ten times what
/// depth can be found with.
[[nodiscard]] double denied_error_px(const Camera& camera);

/// Throws Error (E-IMPORT-DENIED), with what is to be done.
[[noreturn]] void refuse_imported_poses(const std::string& what);

}  // namespace lumi
