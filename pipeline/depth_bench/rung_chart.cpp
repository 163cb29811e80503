#include "pipeline/depth_bench/rung_chart.h"

#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/whole_file.h"
#include "pipeline/chart/gnuplot.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<std::string> scenes_of(const std::vector<RungMeasurement>& measured) {
    std::vector<std::string> scenes;
    std::set<std::string> seen;
    for (const RungMeasurement& rung : measured) {
        if (seen.insert(rung.scene).second) scenes.push_back(rung.scene);
    }
    return scenes;
}

std::string csv_of(const std::vector<RungMeasurement>& measured) {
    std::string text =
        "scene,model,cpu_s_per_megapixel,rms_error,rms_standard_error,psnr_covered_db,psnr_db,"
        "coverage,ssim,confident_share,right_share,right_visible_share,expected_peak_mib,peak_"
        "mib\n";
    for (const RungMeasurement& rung : measured) {
        text += rung.scene + "," + rung.model;
        for (const double value :
             {rung.cpu_s_per_megapixel, rung.rms_error, rung.rms_standard_error,
              rung.held_out.psnr_covered_db.value_or(0.0), rung.held_out.psnr_db,
              rung.held_out.coverage, rung.held_out.ssim, rung.confident_share}) {
            text += "," + number_text(value, 4);
        }
        text += "," + (rung.right_share ? number_text(*rung.right_share, 4) : "") + "," +
                (rung.right_visible_share ? number_text(*rung.right_visible_share, 4) : "") + "," +
                number_text(rung.expected_peak_mib, 0) + "," +
                (rung.peak_mib ? number_text(*rung.peak_mib, 0) : "") + "\n";
    }
    return text;
}

std::string chart_commands(const std::vector<RungMeasurement>& measured) {
    const std::vector<std::string> scenes = scenes_of(measured);
    std::string before;
    std::string plots;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::string block = "$scene" + std::to_string(i);
        std::string labels;
        before += block + " << END\n";
        for (const RungMeasurement& rung : measured) {
            if (rung.scene != scenes[i]) continue;
            const std::string x = number_text(std::max(1e-3, rung.cpu_s_per_megapixel), 5);
            const std::string y = number_text(rung.rms_error, 4);
            before += x + " " + y + " " + number_text(rung.rms_standard_error, 4) + "\n";
            labels += "set label " + gnuplot_quoted(rung.model) + " at " + x + "," + y +
                      " center offset 0,1 font ',9' front\n";
        }
        before += "END\n" + labels;
        plots += (i == 0 ? "plot " : ", ") + block + " using 1:2:3 with yerrorlines pt 7 lt " +
                 std::to_string(i + 1) + " title " + gnuplot_quoted(scenes[i]);
    }
    return "set logscale x\nset offsets 0, 0, graph 0.06, 0\nset grid\nset key outside right\n"
           "set xlabel 'CPU seconds per megapixel of depth map'\n"
           "set ylabel 'held-out error, root mean square of 8-bit levels'\n"
           "set title 'What each depth model costs and brings'\n" +
           before + plots + "\n";
}

}  // namespace

Json rungs_json(const std::vector<RungMeasurement>& measured) {
    Json rungs = Json::array();
    for (const RungMeasurement& rung : measured) {
        Json json{{"scene", rung.scene},
                  {"model", rung.model},
                  {"cpu_s_per_megapixel", rung.cpu_s_per_megapixel},
                  {"rms_error", rung.rms_error},
                  {"rms_standard_error", rung.rms_standard_error},
                  {"psnr_db", rung.held_out.psnr_db},
                  {"coverage", rung.held_out.coverage},
                  {"ssim", rung.held_out.ssim},
                  {"sparse_residual_px", rung.sparse_residual_px},
                  {"confident_share", rung.confident_share},
                  {"expected_peak_mib", rung.expected_peak_mib}};
        if (rung.peak_mib) json["peak_mib"] = *rung.peak_mib;
        if (rung.held_out.psnr_covered_db) json["psnr_covered_db"] = *rung.held_out.psnr_covered_db;
        if (rung.right_share) json["right_share"] = *rung.right_share;
        if (rung.right_visible_share) json["right_visible_share"] = *rung.right_visible_share;
        if (!rung.choice.empty()) json["choice"] = rung.choice;
        rungs.push_back(std::move(json));
    }
    return Json{{"rungs", std::move(rungs)}};
}

void write_rung_chart(const fs::path& folder, const std::vector<RungMeasurement>& measured,
                      const Progress& progress) {
    const std::string svg = gnuplot_svg(
        {"what each depth model costs and brings",
         "size 1000,640 font 'sans-serif,13' background 'white'", chart_commands(measured)},
        progress);
    write_json_file(folder / "rungs.json", rungs_json(measured));
    write_whole_text(folder / "rungs.csv", csv_of(measured));
    write_whole_text(folder / "rungs.svg", svg);
}

}  // namespace lumi
