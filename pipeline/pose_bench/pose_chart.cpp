#include "pipeline/pose_bench/pose_chart.h"

#include <algorithm>
#include <map>

#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/report/number_text.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetresAMetre = 1000;

bool has_truth(const std::vector<PoseTrial>& trials) {
    return std::any_of(trials.begin(), trials.end(),
                       [](const PoseTrial& trial) { return trial.difference.has_value(); });
}

/// Empty when the trial has no place in the chart.
std::optional<double> height_of(const PoseTrial& trial, bool by_truth) {
    if (!by_truth) {
        return 100.0 * (trial.photographs - trial.placed) / std::max(1, trial.photographs);
    }
    if (!trial.difference) return std::nullopt;
    return kMillimetresAMetre * trial.difference->median_position;
}

/// The features kept; the series says the rest.
std::string label_of(const PoseMeans& means) { return std::to_string(means.max_features); }

std::string data_text(const std::vector<const PoseTrial*>& trials, bool by_truth) {
    std::string text;
    for (const PoseTrial* const trial : trials) {
        const auto height = height_of(*trial, by_truth);
        if (!height) continue;
        text +=
            number_text(trial->cost.cpu_s, 3) + " " + number_text(*height, 4) + " \"" +
            label_of(trial->means) +
            (trial->placed < trial->photographs ? ", " + std::to_string(trial->placed) + " placed"
                                                : "") +
            "\"\n";
    }
    return text;
}

std::string script_text(const std::vector<PoseTrial>& trials, const std::string& title,
                        const fs::path& scratch, const fs::path& output) {
    const bool by_truth = has_truth(trials);
    std::map<std::string, std::vector<const PoseTrial*>> series;
    for (const PoseTrial& trial : trials) {
        series[name_of(trial.means) +
               (trial.means.is_colmap_alone
                    ? ""
                    : ", " + std::to_string(trial.means.max_width_px) + " px")]
            .push_back(&trial);
    }
    std::string script =
        "set terminal svg size 1000,640 font 'sans,13' background 'white'\n"
        "set output '" +
        output.string() + "'\nset title '" + title +
        "' noenhanced\nset logscale x\nset xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, "
        "5000)\n"
        "set grid\nset bmargin 8\nset key below maxcols 2\n"
        "set xlabel 'CPU seconds from photographs to poses; at each mark the features kept of a "
        "photograph'\nset offsets graph 0.03, graph 0.12, "
        "graph 0.05, graph 0.05\nset ylabel '" +
        (by_truth ? "median position error, mm" : "photographs not placed, %") + "'\nplot ";
    int number = 0;
    for (const auto& [name, members] : series) {
        const std::string data = data_text(members, by_truth);
        if (data.empty()) continue;
        const fs::path file = scratch / ("series" + std::to_string(number) + ".txt");
        write_whole_text(file, data);
        const std::string quoted = "'" + file.string() + "'";
        script += std::string(number == 0 ? "" : ", ") + quoted +
                  " using 1:2 with linespoints lt " + std::to_string(number + 1) + " pt 7 title '" +
                  name + "' noenhanced, " + quoted +
                  " using 1:2:3 with labels offset 0.6,0.5 left font 'sans,9' noenhanced notitle";
        ++number;
    }
    return script + "\n";
}

}  // namespace

std::vector<PoseMeans> chart_means(int max_width_px) {
    std::vector<PoseMeans> means;
    for (const char* const mapper : {"lumi", "colmap"}) {
        for (const int width_px : {max_width_px, max_width_px / 2}) {
            for (const int features : {1024, 2048, 4096, 8192}) {
                means.push_back({"lumi", mapper, false, features, width_px});
            }
        }
    }
    for (const char* const mapper : {"lumi", "colmap"}) {
        for (const int features : {1024, 2048}) {
            means.push_back({"colmap", mapper, false, features, max_width_px});
        }
    }
    return means;
}

std::string trials_csv(const std::vector<PoseTrial>& trials) {
    std::string text =
        "front_end,mapper,colmap_alone,max_features,max_width_px,cpu_s,wall_s,photographs,placed,"
        "points,median_position_error,mean_position_error,max_position_error,refusal\n";
    for (const PoseTrial& trial : trials) {
        const PoseMeans& means = trial.means;
        text += means.front_end + "," + means.mapper + "," + (means.is_colmap_alone ? "1" : "0") +
                "," + std::to_string(means.max_features) + "," +
                std::to_string(means.max_width_px) + "," + number_text(trial.cost.cpu_s, 3) + "," +
                number_text(trial.cost.wall_s, 3) + "," + std::to_string(trial.photographs) + "," +
                std::to_string(trial.placed) + "," + std::to_string(trial.points) + ",";
        if (trial.difference) {
            text += number_text(trial.difference->median_position, 6) + "," +
                    number_text(trial.difference->mean_position, 6) + "," +
                    number_text(trial.difference->max_position, 6);
        } else {
            text += ",,";
        }
        text += "," + trial.refusal + "\n";
    }
    return text;
}

void draw_pose_chart(const std::vector<PoseTrial>& trials, const std::string& title,
                     const fs::path& file, const fs::path& scratch_folder,
                     const Progress& progress) {
    const fs::path drawn = scratch_folder / "chart.svg";
    const fs::path script = scratch_folder / "chart.gp";
    write_whole_text(script, script_text(trials, title, scratch_folder, drawn));
    ChildCommand command;
    command.arguments = {"gnuplot", script.string()};
    command.log_path = scratch_folder / "gnuplot.log";
    command.time_limit_s = 60;
    command.missing_advice = "install gnuplot (Debian: apt-get install gnuplot-nox)";
    const ChildResult result = run_child(command, progress);
    std::error_code status;
    if (result.exit_status != 0 || !(fs::file_size(drawn, status) > 0) || status) {
        throw Error(ErrorKind::kExternalProgram, "E-CHART-GNUPLOT",
                    "gnuplot made no chart: " + description_of(result, command),
                    "see " + command.log_path.string());
    }
    write_whole_text(file, read_whole_text(drawn));
}

}  // namespace lumi
