#include "pipeline/pose_bench/pose_chart.h"

#include <algorithm>
#include <limits>
#include <map>

#include "calib/work/whole_file.h"
#include "pipeline/chart/gnuplot.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

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

bool is_lens_trial(const PoseMeans& means) { return means.lens_model != "auto"; }

/// The features kept, or the lens model; the series says the rest.
std::string label_of(const PoseMeans& means) {
    return is_lens_trial(means) ? means.lens_model : std::to_string(means.max_features);
}

std::string series_of(const PoseMeans& means) {
    if (means.is_colmap_alone) return name_of(means);
    if (is_lens_trial(means)) {
        return "lens models, " + std::to_string(means.max_features) + " features";
    }
    return name_of(means) + ", " + std::to_string(means.max_width_px) + " px";
}

/// A little more than the trials take, because gnuplot rounds a logarithmic axis far outwards.
std::string time_range(const std::vector<PoseTrial>& trials) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const PoseTrial& trial : trials) {
        least = std::min(least, trial.cost.cpu_s);
        most = std::max(most, trial.cost.cpu_s);
    }
    return "[" + number_text(std::max(least, 0.01) / 1.3, 3) + ":" +
           number_text(1.8 * std::max(most, 0.01), 3) + "]";
}

/// What stands beside the mark of a trial.
std::string mark_text(const PoseTrial& trial) {
    const std::string text = label_of(trial.means);
    if (trial.placed >= trial.photographs) return text;
    return text + ", " + std::to_string(trial.placed) + " placed";
}

/// The places of a series as lines of numbers, and the commands that write beside them.
struct SeriesCommands {
    std::string places;
    std::string labels;
};

SeriesCommands series_commands(const std::vector<const PoseTrial*>& trials, bool by_truth) {
    SeriesCommands series;
    for (const PoseTrial* const trial : trials) {
        const auto height = height_of(*trial, by_truth);
        if (!height) continue;
        const std::string x = number_text(trial->cost.cpu_s, 3);
        const std::string y = number_text(*height, 4);
        series.places += x + " " + y + "\n";
        series.labels += "set label " + gnuplot_quoted(mark_text(*trial)) + " at " + x + "," + y +
                         " left offset 0.6,0.5 font 'sans,9' front\n";
    }
    return series;
}

/// The series and the plot of them all.
std::string plot_commands(const std::vector<PoseTrial>& trials, bool by_truth) {
    std::map<std::string, std::vector<const PoseTrial*>> members_of;
    for (const PoseTrial& trial : trials) members_of[series_of(trial.means)].push_back(&trial);
    std::string before;
    std::string plot = "plot ";
    int number = 0;
    for (const auto& [name, members] : members_of) {
        const SeriesCommands series = series_commands(members, by_truth);
        if (series.places.empty()) continue;
        const std::string block = "$series" + std::to_string(number);
        before += series.labels + block + " << EOD\n" + series.places + "EOD\n";
        // Lens models have no order that a line could follow.
        const char* const style = is_lens_trial(members.front()->means) ? "points" : "linespoints";
        plot += std::string(number == 0 ? "" : ", ") + block + " using 1:2 with " + style + " lt " +
                std::to_string(number + 1) + " pt 7 title " + gnuplot_quoted(name);
        ++number;
    }
    return before + plot + "\n";
}

std::string chart_commands(const std::vector<PoseTrial>& trials, const std::string& title) {
    const bool by_truth = has_truth(trials);
    return "set title " + gnuplot_quoted(title) +
           "\nset logscale x\nset xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)\n"
           "set grid\nset bmargin 8\nset key below maxcols 2\n"
           "set xlabel 'CPU seconds from photographs to poses; at each mark the features kept of a "
           "photograph, or the lens model'\nset xrange " +
           time_range(trials) + "\nset offsets 0, 0, graph 0.05, graph 0.05\nset ylabel '" +
           (by_truth ? "median position error, mm" : "photographs not placed, %") + "'\n" +
           plot_commands(trials, by_truth);
}

}  // namespace

std::vector<PoseMeans> chart_means(int max_width_px) {
    std::vector<PoseMeans> means;
    const auto add_mapper = [&](PoseProgram mapper) {
        for (const int width_px : {max_width_px, max_width_px / 2}) {
            for (const int features : {1024, 2048, 4096, 8192}) {
                means.push_back({PoseProgram::kLumi, mapper, false, features, width_px});
            }
        }
    };
    add_mapper(PoseProgram::kLumi);
    for (const char* const model :
         {"SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "FULL_OPENCV", "OPENCV_FISHEYE"}) {
        means.push_back({PoseProgram::kLumi, PoseProgram::kLumi, false, 4096, max_width_px, model});
    }
    add_mapper(PoseProgram::kColmap);
    for (const PoseProgram mapper : {PoseProgram::kLumi, PoseProgram::kColmap}) {
        for (const int features : {1024, 2048}) {
            means.push_back({PoseProgram::kColmap, mapper, false, features, max_width_px});
        }
    }
    return means;
}

std::string trials_csv(const std::vector<PoseTrial>& trials) {
    std::string text =
        "front_end,mapper,colmap_alone,max_features,max_width_px,lens_model,cpu_s,wall_s,"
        "photographs,placed,"
        "points,lens,focal_px,median_position_error,mean_position_error,max_position_error,"
        "refusal\n";
    for (const PoseTrial& trial : trials) {
        const PoseMeans& means = trial.means;
        text += std::string(name_of(means.front_end)) + "," + std::string(name_of(means.mapper)) +
                "," + (means.is_colmap_alone ? "1" : "0") + "," +
                std::to_string(means.max_features) + "," + std::to_string(means.max_width_px) +
                "," + means.lens_model + "," + number_text(trial.cost.cpu_s, 3) + "," +
                number_text(trial.cost.wall_s, 3) + "," + std::to_string(trial.photographs) + "," +
                std::to_string(trial.placed) + "," + std::to_string(trial.points) + ",\"" +
                trial.lens + "\"," + number_text(trial.focal_px, 2) + ",";
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
                     const std::filesystem::path& file, const Progress& progress) {
    write_whole_text(file, gnuplot_svg({title, "size 1000,640 font 'sans,13' background 'white'",
                                        chart_commands(trials, title)},
                                       progress));
}

}  // namespace lumi
