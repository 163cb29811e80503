#include "pipeline/report/stress_charts.h"

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::map<std::string, fs::path> charts_with_figures(const fs::path& stress_folder,
                                                    const std::string& package_sha256) {
    std::map<std::string, fs::path> charts;
    const auto figures = read_json_file(stress_folder / kStressFiguresName);
    if (figures.at("package_sha256") != package_sha256) return charts;
    for (const auto& curve : figures.at("curves")) {
        const std::string perturbation = curve.at("perturbation");
        const fs::path chart = stress_chart_path(stress_folder, perturbation);
        std::error_code status;
        if (fs::is_regular_file(chart, status)) charts.emplace(perturbation, chart);
    }
    return charts;
}

}  // namespace

fs::path stress_chart_path(const fs::path& stress_folder, const std::string& perturbation) {
    return stress_folder / (perturbation + ".svg");
}

std::map<std::string, fs::path> stress_charts_of(const WorkspaceLayout& workspace) {
    const fs::path folder = workspace.folder() / "stress";
    std::error_code status;
    if (!fs::is_regular_file(folder / kStressFiguresName, status)) return {};
    try {
        return charts_with_figures(folder, package_sha256(workspace));
    } catch (const Error&) {
        return {};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

}  // namespace lumi
