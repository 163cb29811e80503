#include "pipeline/gallery/gallery.h"

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/gallery/gallery_pictures.h"
#include "pipeline/report/stress_charts.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kPageName = "gallery.md";
constexpr const char* kPageBeginning = "# Gallery: ";
constexpr const char* kHeldOutName = "held-out.jpg";
constexpr const char* kMethodsName = "methods.jpg";

constexpr int kStripWidthPx = 1500;
constexpr int kJpegQuality = 88;

struct KnownChart {
    fs::path path;  ///< Empty where there is none of the package.
    std::string name;
    std::string caption;
};

std::vector<KnownChart> charts_of(const WorkspaceLayout& workspace) {
    const fs::path sweep = workspace.folder().string() + "-chart";
    std::vector<KnownChart> charts{
        {sweep / "end-to-end.svg", "chart-end-to-end.svg",
         "What each second buys: photographs to the first picture"},
        {sweep / "drawing.svg", "chart-drawing.svg", "What each millisecond of a frame buys"},
        {sweep / "stage-depth.svg", "chart-depth.svg", "What each second of depth buys"},
        {sweep / "growth-cpu-photographs.svg", "growth-cpu.svg",
         "How the stages grow with the number of photographs"}};
    const auto of_stress = stress_charts_of(workspace);
    const auto add_of_stress = [&](const char* perturbation, const char* name,
                                   const char* caption) {
        const auto chart = of_stress.find(perturbation);
        const bool is_current = chart != of_stress.end();
        charts.push_back({is_current ? chart->second : fs::path(), name, caption});
    };
    add_of_stress("pose_rotation_deg", "stress-poses.svg", "What wrong poses cost");
    add_of_stress("depth_percent", "stress-depth.svg", "What wrong depth costs");
    add_of_stress("views_dropped_percent", "stress-views.svg", "What fewer photographs cost");
    return charts;
}

/// Only a gallery gives way to a gallery. Throws Error (E-OUT-EXISTS) where a file that is not
/// known for one of an earlier gallery would be replaced.
void expect_gallery_or_nothing(const fs::path& folder, const std::vector<KnownChart>& charts) {
    std::error_code status;
    if (fs::is_regular_file(folder / kPageName, status) &&
        read_whole_text(folder / kPageName).starts_with(kPageBeginning))
        return;
    std::vector<std::string> names{kPageName, kHeldOutName, kMethodsName};
    for (const KnownChart& chart : charts) names.push_back(chart.name);
    for (const std::string& name : names) {
        if (fs::exists(fs::symlink_status(folder / name, status)))
            refuse_loss(folder / name, "would be replaced, and no gallery of lumi's is beside it");
    }
}

std::string figure(const std::string& file, const std::string& caption) {
    return "![" + caption + "](" + file + ")\n\n*" + caption + "*\n\n";
}

std::string score_row(const std::string& mode, const Json& scores) {
    const Json& mean = scores.at("mean");
    const auto cell = [](const Json& value, int decimals, double factor = 1.0) {
        return (value.is_null() ? std::string("-")
                                : number_text(factor * value.get<double>(), decimals)) +
               " | ";
    };
    return "| `" + mode + "` | " + cell(mean.at("psnr_db"), 2) +
           cell(mean.at("psnr_covered_db"), 2) + cell(mean.at("ssim"), 4) +
           cell(mean.at("flip"), 4) + cell(mean.at("edge_sharpness"), 2) +
           cell(mean.at("coverage"), 1, 100.0) + cell(mean.at("ms"), 1) + "\n";
}

std::string table_of(const Json& evaluation) {
    std::string table =
        "| mode | PSNR (dB) | PSNR, covered (dB) | SSIM | FLIP | sharpness | covered (%) | ms |\n"
        "|---|---|---|---|---|---|---|---|\n";
    table += score_row(evaluation.at("mode"), evaluation);
    for (const auto& [mode, scores] : evaluation.at("modes").items()) {
        table += score_row(mode, scores);
    }
    return table + "\n";
}

}  // namespace

void write_gallery(const WorkspaceLayout& workspace, const fs::path& folder, Progress& progress) {
    const Json evaluation = read_current_evaluation(workspace);
    if (evaluation.is_null()) {
        throw Error(ErrorKind::kUsage, "E-GALLERY-EVALUATION",
                    workspace.folder().string() + ": its package was not evaluated",
                    "run `lumi evaluate` on the workspace first");
    }
    const std::vector<KnownChart> charts = charts_of(workspace);
    expect_gallery_or_nothing(folder, charts);
    progress.begin("drawing the gallery", 0);
    const Json& view = evaluation.at("views").at(evaluation.at("views").size() / 2);
    write_jpeg(folder / kHeldOutName,
               fitted_to(read_color_image(workspace.evaluation_folder() /
                                          view.at("picture").get<std::string>()),
                         kStripWidthPx),
               kJpegQuality);
    write_jpeg(folder / kMethodsName, methods_picture(read_package(workspace.package_folder())),
               kJpegQuality);

    std::string page =
        kPageBeginning + workspace.name() +
        "\n\nMade by `lumi gallery`; figures are of the version that drew them.\n\n" +
        figure(kHeldOutName,
               "A photograph that was not used; what lumi draws from its place; the error") +
        table_of(evaluation) +
        figure(kMethodsName,
               "One eye: without depth, with depth; with occlusion correction, too, blending "
               "weights (white: none of the three cameras sees it); inverse depth, the triangles "
               "of `adaptive`");
    for (const KnownChart& chart : charts) {
        std::error_code status;
        if (!fs::is_regular_file(chart.path, status)) continue;
        write_whole_text(folder / chart.name, read_whole_text(chart.path));
        page += figure(chart.name, chart.caption);
    }
    write_whole_text(folder / kPageName, page);
    // A gallery made before shows those of another package there; it does so no longer.
    for (const KnownChart& chart : charts) {
        if (chart.path.empty()) fs::remove(folder / chart.name);
    }
}

}  // namespace lumi
