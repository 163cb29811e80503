#include "pipeline/report/standing_package.h"

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/evaluate/stale_package.h"
#include "pipeline/report/report_sources.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr int kAllCores = 0;

}  // namespace

StandingPackage standing_package(const WorkspaceLayout& workspace,
                                 const nlohmann::ordered_json& stages) {
    std::error_code status;
    if (!fs::is_directory(workspace.package_folder(), status) ||
        !fs::is_directory(workspace.stage_folder("pack"), status)) {
        return {};
    }
    const bool was_just_made =
        !stages.contains("failure") && !evidence_of(stages, "pack").is_null();
    if (was_just_made) return {true, {}};
    try {
        const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
        return {true, why_package_is_stale(workspace, record, kAllCores)};
    } catch (const Error& error) {
        return {true, error.what()};
    }
}

}  // namespace lumi
