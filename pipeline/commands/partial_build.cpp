#include "pipeline/commands/partial_build.h"

#include "calib/work/error.h"

namespace lumi {

void refuse_partial(const std::optional<PlacedPhotographs>& photographs,
                    const WorkspaceLayout& layout) {
    if (!photographs || !photographs->is_partial()) return;
    throw Error(ErrorKind::kPartialResult, "E-BUILD-PARTIAL",
                "only " + std::to_string(photographs->placed) + " of " +
                    std::to_string(photographs->total) +
                    " photographs found a place, and what was made shows what these show",
                layout.report_path().string() +
                    " says why of each; photographs between those that are far apart join them");
}

}  // namespace lumi
