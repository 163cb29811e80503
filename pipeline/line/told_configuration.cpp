#include "pipeline/line/told_configuration.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/explained_configuration.h"

namespace lumi {
namespace {

constexpr const char* kConfigNotes =
    "# [sweep] (lists of values to try, modes, repeats) and [growth] (photographs, max_width_px) "
    "are "
    "read by\n# lumi chart, [stress] (modes, perturbations, max_loss_db, seed) by lumi stress.\n";

}  // namespace

std::string configuration_sha256(const BuildConfig& config) {
    nlohmann::ordered_json told{{"hold_out_every", config.hold_out.every},
                                {"hold_out", config.hold_out.names}};
    for (const auto& [stage, parameters] : config.stage_parameters) told[stage] = parameters;
    return sha256_hex(told.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void write_configuration(const Workspace& workspace, const BuildConfig& config) {
    write_whole_text(workspace.config_path(), std::string(kWorkspaceConfigHeader) + '\n' +
                                                  kConfigNotes +
                                                  explained_configuration(config.movable_toml));
}

}  // namespace lumi
