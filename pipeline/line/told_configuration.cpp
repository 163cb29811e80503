#include "pipeline/line/told_configuration.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

constexpr const char* kConfigNotes =
    "# max_width_px limits, in [capture], the longer side of photographs, whichever that is, and, "
    "in [depth], the\n# width of depth maps.\n";

}  // namespace

std::string configuration_sha256(const BuildConfig& config) {
    nlohmann::ordered_json told{{"hold_out_every", config.hold_out.every},
                                {"hold_out", config.hold_out.names}};
    for (const auto& [stage, parameters] : config.stage_parameters) told[stage] = parameters;
    return sha256_hex(told.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void write_configuration(const Workspace& workspace, const BuildConfig& config) {
    write_whole_text(workspace.config_path(), std::string(kWorkspaceConfigHeader) + '\n' +
                                                  kConfigNotes + config.movable_toml);
}

}  // namespace lumi
