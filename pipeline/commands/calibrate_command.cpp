#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/boards/calibration_picture.h"
#include "calib/lens_files/lens_files.h"
#include "calib/work/error.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/report/number_text.h"
#include "pipeline/stages/calibration_json.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct CalibrateRequest {
    fs::path photographs;
    fs::path out;
    std::string board;
    std::string size;
    double square_ratio = 0.0;
    std::vector<std::string> models;
};

BoardRequest board_request(const CalibrateRequest& request) {
    BoardRequest board;
    if (!request.board.empty()) {
        board.kind = board_kind_named(request.board);
        if (!board.kind) {
            throw Error(ErrorKind::kUsage, "E-CALIBRATE-BOARD",
                        "no kind of board is called \"" + request.board + "\"",
                        "give one of: " + board_kind_names());
        }
    }
    if (!request.size.empty()) {
        char cross = 0;
        int end = 0;
        if (std::sscanf(request.size.c_str(), "%d%c%d%n", &board.columns, &cross, &board.rows,
                        &end) != 3 ||
            cross != 'x' || static_cast<std::size_t>(end) != request.size.size() ||
            board.columns < 2 || board.rows < 2) {
            throw Error(ErrorKind::kUsage, "E-CALIBRATE-SIZE",
                        "\"" + request.size + "\" is no size of a board",
                        "give COLUMNSxROWS of inner corners, discs, squares or markers, as 9x6");
        }
    }
    board.size_per_pitch = request.square_ratio;
    return board;
}

BoardCalibrationOptions calibration_options(const CalibrateRequest& request) {
    BoardCalibrationOptions options;
    if (request.models.empty()) return options;
    options.models.clear();
    for (const std::string& name : request.models) {
        const auto model = lens_model_named(name);
        if (!model) {
            throw Error(ErrorKind::kUsage, "E-CALIBRATE-MODEL",
                        "no lens model is called \"" + name + "\"",
                        "give SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV "
                        "or OPENCV_FISHEYE");
        }
        options.models.push_back(*model);
    }
    return options;
}

std::string parameter_text(const LensParameter& parameter) {
    const int digits = std::abs(parameter.value) < 10 ? 5 : 2;
    std::string text = parameter.name + " = " + number_text(parameter.value, digits);
    if (parameter.sigma == 0) return text + "  (held)";
    return text + "  +- " + number_text(parameter.sigma, digits) +
           "  95 %: " + number_text(parameter.low, digits) + " to " +
           number_text(parameter.high, digits);
}

std::vector<std::string> remarks_of(const BoardPhotographs& found,
                                    const BoardCalibration& calibration) {
    std::vector<std::string> remarks{
        "Calibrated by lumi from " + std::to_string(calibration.views.size()) +
            " photographs of a board (" + std::string(name_of(found.kind)) + "): RMS " +
            number_text(calibration.rms_px, 3) + " px, held out " +
            number_text(calibration.held_out_rms_px, 3) + " px.",
        "One standard deviation and 95 % interval of each parameter:"};
    for (const LensParameter& parameter : calibration.parameters) {
        remarks.push_back("  " + parameter_text(parameter));
    }
    return remarks;
}

/// Every format that has words for the lens; the names of the files.
std::vector<std::string> write_results(const fs::path& out, const BoardPhotographs& found,
                                       const BoardCalibration& calibration, const Json& json) {
    std::vector<std::string> written;
    const std::vector<std::string> remarks = remarks_of(found, calibration);
    for (const LensFormat format : kLensFormats) {
        const fs::path path = out / usual_file_name(format);
        try {
            write_lens_file(path, calibration.lens, format, remarks);
            written.push_back(path.string());
        } catch (const Error& error) {
            if (error.code() != "E-LENS-FORMAT") throw;
            // What an earlier run wrote would be another lens.
            fs::remove(path);
        }
    }
    write_whole_text(out / "calibration.svg", calibration_svg(calibration));
    write_whole_text(out / "calibration.json", json_text(json));
    written.push_back((out / "calibration.svg").string());
    written.push_back((out / "calibration.json").string());
    return written;
}

std::string left_out_text(const std::vector<LeftOut>& left_out) {
    std::string text;
    for (const LeftOut& photograph : left_out) {
        text += "left out " + photograph.name + " (" + photograph.code + "): " + photograph.reason +
                "\n";
    }
    return text;
}

std::string result_text(const BoardPhotographs& found, const BoardCalibration& calibration,
                        const Cost& cost) {
    std::string text =
        std::string(name_of(found.kind)) + ", " + std::to_string(found.columns) + " x " +
        std::to_string(found.rows) + ", in " + std::to_string(calibration.views.size()) + " of " +
        std::to_string(found.photographs) + " photographs\n" + left_out_text(found.left_out) +
        left_out_text(calibration.left_out) + "\n" + lens_choice_table(calibration.choice) + "\n";
    for (const std::string& drop : calibration.dropped) text += "not kept: " + drop + "\n";
    text += text_of(calibration.form) + "\n";
    for (const LensParameter& parameter : calibration.parameters) {
        text += "  " + parameter_text(parameter) + "\n";
    }
    text += "RMS " + number_text(calibration.rms_px, 3) + " px, held out " +
            number_text(calibration.held_out_rms_px, 3) + " px (distances, " +
            std::to_string(calibration.residuals.size()) + " points); " +
            number_text(cost.cpu_s, 2) + " CPU s\n";
    for (const std::string& warning : calibration.warnings) text += "warning: " + warning + "\n";
    return text;
}

void run_calibrate(const CalibrateRequest& request, const CommandContext& context) {
    const Stopwatch stopwatch;
    const BoardRequest board = board_request(request);
    const BoardCalibrationOptions options = calibration_options(request);
    const BoardPhotographs found =
        find_boards(request.photographs, board, context.threads, *context.progress);
    const BoardCalibration calibration = calibrate_boards(found.board, options, *context.progress);
    Json json = calibration_json(found, calibration);
    const Cost cost = stopwatch.elapsed();
    json["cpu_s"] = cost.cpu_s;
    json["wall_s"] = cost.wall_s;
    std::vector<std::string> written;
    if (!request.out.empty()) written = write_results(request.out, found, calibration, json);
    if (context.json) {
        json["files"] = written;
        context.print_result(json);
        return;
    }
    std::string text = result_text(found, calibration, cost);
    for (const std::string& path : written) text += path + "\n";
    context.print_result(text);
}

}  // namespace

void add_calibrate_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "calibrate", "A lens from photographs of a calibration board: model and size found",
        "lumi calibrate boards/ --out work/lens");
    const auto request = std::make_shared<CalibrateRequest>();
    command.add_option("PHOTOGRAPHS", request->photographs, "Folder with photographs of one board")
        ->required();
    command.add_option("--out", request->out,
                       "Folder for the lens (TOML, COLMAP, OpenCV, Kalibr, ROS), the picture of "
                       "coverage and residuals, and calibration.json");
    command.add_option("--board", request->board,
                       "Kind of board (default: found): " + board_kind_names());
    command.add_option("--size", request->size,
                       "COLUMNSxROWS of inner corners, discs, squares or markers (default: found)");
    command
        .add_option("--square-ratio", request->square_ratio,
                    "Side of a square or marker, or diameter of a disc, to the distance between "
                    "neighbours (default: estimated)")
        ->check(CLI::Range(0.05, 0.99));
    command
        .add_option("--models", request->models,
                    "Lens models to choose among, separated by commas (default: all seven)")
        ->delimiter(',');
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_calibrate(*request, context); };
    });
}

}  // namespace lumi
