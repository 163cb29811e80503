#include "pipeline/chart/chart_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Folders of the user's may well be called so: what lies in them tells.
bool is_of_early_version(const fs::path& folder) {
    return is_record_of_lumi(folder / "chart.json") || is_record_of_lumi(folder / "growth.json") ||
           holds_workspace(folder / "variants") || holds_workspace(folder / "growth");
}

}  // namespace

WorkFolder take_chart_folder(const fs::path& folder) { return {folder, is_of_early_version}; }

}  // namespace lumi
