#include <CLI/CLI.hpp>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/stages/calibration_files.h"
#include "pipeline/stages/calibration_json.h"
#include "pipeline/text/number_text.h"

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
        counted(found.photographs, "photograph") + "\n" + left_out_text(found.left_out) +
        left_out_text(calibration.left_out) + "\n" + lens_choice_table(calibration.choice) + "\n";
    for (const std::string& drop : calibration.dropped) text += "not kept: " + drop + "\n";
    text += text_of(calibration.form) + "\n";
    for (const LensParameter& parameter : calibration.parameters) {
        text += "  " + parameter_text(parameter) + "\n";
    }
    text += "RMS " + number_text(calibration.rms_px, 3) + " px, held out " +
            held_out_text(calibration) + " (distances, " +
            std::to_string(calibration.residuals.size()) + " points); " +
            number_text(cost.cpu_s, 2) + " CPU s\n";
    if (calibration.bow) text += text_of(*calibration.bow) + "\n";
    for (const std::string& warning : calibration.warnings) text += "warning: " + warning + "\n";
    return text;
}

void run_calibrate(const CalibrateRequest& request, const CommandContext& context) {
    if (!request.out.empty()) require_writable_folder(request.out);
    const Stopwatch stopwatch;
    const BoardRequest board = board_request(request);
    const BoardCalibrationOptions options = calibration_options(request);
    const BoardPhotographs found =
        find_boards(request.photographs, board, context.threads, *context.progress);
    BoardCalibration calibration = calibrate_boards(found.board, options, *context.progress);
    calibration.warnings.insert(calibration.warnings.begin(), found.warnings.begin(),
                                found.warnings.end());
    const Cost cost = stopwatch.elapsed();
    std::vector<std::string> written;
    if (!request.out.empty()) written = write_calibration(request.out, found, calibration);
    if (context.json) {
        Json json = calibration_json(found, calibration);
        json["cpu_s"] = cost.cpu_s;
        json["wall_s"] = cost.wall_s;
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
                       "COLUMNSxROWS of inner corners, discs, squares or markers: photographs of a "
                       "larger pattern are left out, and it is said where none shows as much "
                       "(default: found; asymmetric and hexagonal circles: not used)");
    command
        .add_option("--square-ratio", request->square_ratio,
                    "Side of a square or marker, or diameter of a disc, to the distance between "
                    "neighbours (default: estimated)")
        ->check(number_from_to(0.05, 0.99));
    command
        .add_option("--models", request->models,
                    "Lens models to choose among, separated by commas (default: all seven)")
        ->delimiter(',');
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_calibrate(*request, context); };
    });
}

}  // namespace lumi
