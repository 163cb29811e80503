#include "pipeline/chart/default_sweep.h"

#include <algorithm>

#include "calib/ingest/photograph_folder.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "meshing/depth_models/depth_model.h"

namespace lumi {
namespace {

std::vector<std::string> depth_model_literals() {
    std::vector<std::string> literals;
    for (const std::string& name : depth_model_names()) literals.push_back('"' + name + '"');
    return literals;
}

/// Of the copies that the configuration asks for; photographs are never enlarged.
int full_size_px(const BuildConfig& config) {
    const int asked_px = config.ingest.max_width_px;
    const int there_px = longest_side_px(config.photographs_or_video);
    if (asked_px > 0 && there_px > 0) return std::min(asked_px, there_px);
    if (asked_px > 0 || there_px > 0) return std::max(asked_px, there_px);
    return IngestOptions{}.max_width_px;
}

}  // namespace

int longest_side_px(const std::filesystem::path& photographs_or_video) {
    std::error_code status;
    if (!std::filesystem::is_directory(photographs_or_video, status)) return 0;
    int longest_px = 0;
    for (const PhotographFile& file : list_photographs(photographs_or_video, {}, {}).files) {
        try {
            const ImageSize size = read_image_size(file.path);
            longest_px = std::max({longest_px, size.width_px, size.height_px});
        } catch (const Error&) {
            continue;  // Damaged: the line leaves it out by name.
        }
    }
    return longest_px;
}

ConfigList with_all_spelled_out(ConfigList list) {
    const bool is_all = list.words() == std::vector<std::string>{"all"};
    if (is_all && list.setting == "depth.model") list.literals = depth_model_literals();
    return list;
}

std::vector<ConfigList> default_sweep(const ConfigDocument& document) {
    const ConfigList depth{"depth.model", depth_model_literals()};
    const BuildConfig config = document.build_config_with({});
    const int full_px = full_size_px(config);
    ConfigList width{"capture.max_width_px", {}};
    for (const int quarters : {2, 3, 4}) {
        const int width_px = std::max(config.ingest.min_width_px, full_px * quarters / 4);
        std::string literal = std::to_string(width_px);
        if (width.literals.empty() || width.literals.back() != literal) {
            width.literals.push_back(std::move(literal));
        }
    }
    return {depth, width};
}

}  // namespace lumi
