#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/ingest/photograph_folder.h"
#include "calib/lens_files/lens_files.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "calib/work/stopwatch.h"
#include "pipeline/commands/commands.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The lens in intrinsic.yaml beside the photographs, when there is one that can be read.
std::optional<Camera> reference_lens(const fs::path& folder) {
    const fs::path path = folder / "intrinsic.yaml";
    if (!fs::exists(path)) return std::nullopt;
    return read_lens_file(path);
}

/// Of the mean of both axes, in per cent and in our own standard deviations.
void add_deviation(const Camera& reference, const BoardCalibration& calibration, Json& row) {
    const double ours = focal_length_px(calibration.lens).mean();
    const double theirs = focal_length_px(reference).mean();
    row["reference_focal_px"] = theirs;
    row["focal_deviation_percent"] = 100 * (ours - theirs) / theirs;
    row["focal_deviation_sigma"] = (ours - theirs) / calibration.parameters.front().sigma;
}

/// One row of the table; `refusal` gets what a folder was refused for, the first time.
Json row_for(const fs::path& folder, const CommandContext& context, std::optional<Error>& refusal) {
    const fs::path named = folder.has_filename() ? folder : folder.parent_path();
    Json row{{"set", named.filename().string()}};
    const Stopwatch stopwatch;
    try {
        const BoardPhotographs found = find_boards(folder, {}, context.threads, *context.progress);
        const BoardCalibration calibration = calibrate_boards(found.board, {}, *context.progress);
        row["board"] = name_of(found.kind);
        row["photographs"] = found.photographs;
        row["used"] = calibration.views.size();
        row["form"] = text_of(calibration.form);
        row["free_parameters"] = free_parameters(calibration.form);
        row["focal_px"] = focal_length_px(calibration.lens).mean();
        row["focal_sigma_px"] = calibration.parameters.front().sigma;
        if (calibration.bow) row["bent_percent"] = 100 * calibration.bow->share_of_width;
        row["rms_px"] = calibration.rms_px;
        if (calibration.held_out_rms_px) row["held_out_rms_px"] = *calibration.held_out_rms_px;
        if (const auto reference = reference_lens(folder)) {
            add_deviation(*reference, calibration, row);
        }
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kInterrupted) throw;
        row["refused"] = error.code();
        row["reason"] = printable(error.what());
        context.say(error.code() + ": " + printable(error.what()) + "\n");
        refusal = refusal.value_or(error);
    }
    row["cpu_s"] = stopwatch.elapsed().cpu_s;
    return row;
}

std::string cell(const Json& row, const char* key, int decimals) {
    return row.contains(key) ? number_text(row[key].get<double>(), decimals) : "-";
}

std::string table_of(const std::vector<Json>& rows) {
    std::string table =
        "| set | board | used | bent, % | lens | focal px | RMS px | held out px | reference | off "
        "by "
        "| CPU s |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Json& row : rows) {
        table += "| " + row["set"].get<std::string>() + " | ";
        if (row.contains("refused")) {
            table += row["refused"].get<std::string>() + " | | | | | | | | | ";
        } else {
            table += row["board"].get<std::string>() + " | " +
                     std::to_string(row["used"].get<int>()) + " of " +
                     std::to_string(row["photographs"].get<int>()) + " | " +
                     cell(row, "bent_percent", 2) + " | " + row["form"].get<std::string>() + " | " +
                     cell(row, "focal_px", 2) + " +- " + cell(row, "focal_sigma_px", 2) + " | " +
                     cell(row, "rms_px", 3) + " | " + cell(row, "held_out_rms_px", 3) + " | " +
                     cell(row, "reference_focal_px", 2) + " | ";
            if (row.contains("focal_deviation_percent")) {
                table += cell(row, "focal_deviation_percent", 2) + " %, " +
                         cell(row, "focal_deviation_sigma", 1) + " sigma";
            }
            table += " | ";
        }
        table += cell(row, "cpu_s", 2) + " |\n";
    }
    return table;
}

}  // namespace

void add_bench_boards_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-boards",
        "Calibrations of several folders side by side: errors, and the seconds they took",
        "lumi bench-boards boards/phone boards/fisheye");
    const auto folders = std::make_shared<std::vector<fs::path>>();
    command
        .add_option("FOLDERS", *folders,
                    "Folders with photographs of one board each; an intrinsic.yaml (BoofCV, "
                    "OpenCV, ROS) beside the photographs is compared with")
        ->required();
    command.callback([folders, &context] {
        context.chosen = [folders, &context] {
            for (const fs::path& folder : *folders)
                static_cast<void>(list_photographs(folder, {}, {}));
            std::vector<Json> rows;
            std::optional<Error> refusal;
            for (const fs::path& folder : *folders)
                rows.push_back(row_for(folder, context, refusal));
            if (context.json) {
                context.print_result(Json{{"sets", rows}});
            } else {
                context.print_result(table_of(rows));
            }
            const bool are_all_refused = std::all_of(
                rows.begin(), rows.end(), [](const Json& row) { return row.contains("refused"); });
            if (are_all_refused) throw *refusal;
        };
    });
}

}  // namespace lumi
