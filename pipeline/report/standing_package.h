#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// The package that stands in a workspace, beside what its configuration asks for.
struct StandingPackage {
    bool exists = false;
    std::string stale_because;  ///< "" for one that the configuration asks for (stale_package.h).

    [[nodiscard]] bool is_former() const { return exists && !stale_because.empty(); }
};

/// `stages` is what stages.json says. Files are read where the last run did not come to the
/// package.
[[nodiscard]] StandingPackage standing_package(const WorkspaceLayout& workspace,
                                               const nlohmann::ordered_json& stages);

}  // namespace lumi
