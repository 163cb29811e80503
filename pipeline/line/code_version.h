#pragma once

#include <string>

namespace lumi {

/// Version of the code behind a stage ("ingest", "calibrate", "poses", "mesh", "depth", "pack") and
/// behind "evaluate" (drawing and judging): a hash over the libraries that do its work, taken when
/// lumi was built. A result of other code is not reused.
[[nodiscard]] std::string code_version_of(const std::string& stage);

}  // namespace lumi
