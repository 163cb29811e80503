#include "pipeline/chart/chart_folder.h"

namespace lumi {

WorkFolder take_chart_folder(const std::filesystem::path& folder) {
    return {folder, {"chart.json", "variants", "growth", "growth.json"}};
}

}  // namespace lumi
