#include "pipeline/depth_bench/rung_chart.h"

#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/report/number_text.h"
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

/// Words in a gnuplot string: quotes and escapes are left out.
std::string plain(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter != '"' && letter != '\\' && letter != '\n') result += letter;
    }
    return result;
}

std::string gnuplot_script(const std::vector<RungMeasurement>& measured, const fs::path& svg) {
    const std::vector<std::string> scenes = scenes_of(measured);
    std::string blocks;
    std::string plots;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::string block = "$scene" + std::to_string(i);
        blocks += block + " << END\n";
        for (const RungMeasurement& rung : measured) {
            if (rung.scene != scenes[i]) continue;
            blocks += number_text(std::max(1e-3, rung.cpu_s_per_megapixel), 5) + " " +
                      number_text(rung.rms_error, 4) + " " +
                      number_text(rung.rms_standard_error, 4) + " \"" + plain(rung.model) + "\"\n";
        }
        blocks += "END\n";
        const std::string style = " lt " + std::to_string(i + 1);
        plots += (i == 0 ? "plot " : ", ") + block + " using 1:2:3 with yerrorlines pt 7" + style +
                 " title \"" + plain(scenes[i]) + "\", " + block +
                 " using 1:2:4 with labels offset 0,1 font \",9\" notitle";
    }
    return "set terminal svg size 1000,640 font \"sans-serif,13\" background \"white\"\n"
           "set output \"" +
           plain(svg.string()) +
           "\"\n"
           "set logscale x\nset offsets 0, 0, graph 0.06, 0\nset grid\nset key outside right "
           "noenhanced\n"
           "set xlabel \"CPU seconds per megapixel of depth map\"\n"
           "set ylabel \"held-out error, root mean square of 8-bit levels\"\n"
           "set title \"What each depth model costs and brings\"\nset termoption noenhanced\n" +
           blocks + plots + "\n";
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
    WholeFolder whole(folder);
    write_json_file(whole.staging() / "rungs.json", rungs_json(measured));
    write_whole_text(whole.staging() / "rungs.csv", csv_of(measured));
    const fs::path script = whole.staging() / "rungs.gnuplot";
    const fs::path svg = whole.staging() / "rungs.svg";
    write_whole_text(script, gnuplot_script(measured, svg));
    const ChildCommand command{.arguments = {"gnuplot", script.string()},
                               .log_path = whole.staging() / "gnuplot.log",
                               .time_limit_s = 60,
                               .missing_advice = "install gnuplot: apt-get install gnuplot-nox",
                               .on_output = {}};
    const ChildResult result = run_child(command, progress);
    std::error_code status;
    if (result.end != ChildEnd::kExited || result.exit_status != 0 ||
        fs::file_size(svg, status) == 0 || status) {
        throw Error(ErrorKind::kExternalProgram, "E-CHART-GNUPLOT",
                    "gnuplot: " + description_of(result, command) + ", no chart",
                    "see whether gnuplot runs: gnuplot --version");
    }
    fs::remove(script, status);
    fs::remove(whole.staging() / "gnuplot.log", status);
    whole.put_in_place();
}

}  // namespace lumi
