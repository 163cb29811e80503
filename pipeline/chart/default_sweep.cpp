#include "pipeline/chart/default_sweep.h"

#include <algorithm>

#include "meshing/depth/depth_model.h"

namespace lumi {
namespace {

std::vector<std::string> depth_model_literals() {
    std::vector<std::string> literals;
    for (const std::string& name : depth_model_names()) literals.push_back('"' + name + '"');
    return literals;
}

}  // namespace

ConfigList with_all_spelled_out(ConfigList list) {
    const bool is_all = list.words() == std::vector<std::string>{"all"};
    if (is_all && list.setting == "depth.model") list.literals = depth_model_literals();
    return list;
}

std::vector<ConfigList> default_sweep(const ConfigDocument& document) {
    const ConfigList depth{"depth.model", depth_model_literals()};
    const IngestOptions ingest = document.build_config_with({}).ingest;
    const int full_px =
        ingest.max_width_px > 0 ? ingest.max_width_px : IngestOptions{}.max_width_px;
    ConfigList width{"capture.max_width_px", {}};
    for (const int quarters : {2, 3, 4}) {
        width.literals.push_back(
            std::to_string(std::max(ingest.min_width_px, full_px * quarters / 4)));
    }
    return {depth, width};
}

}  // namespace lumi
