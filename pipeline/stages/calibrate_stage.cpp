#include "pipeline/stages/calibrate_stage.h"

#include <nlohmann/json.hpp>

#include "calib/lens_files/lens_files.h"
#include "pipeline/stages/calibration_files.h"
#include "pipeline/stages/calibration_json.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

StageEvidence run_calibrate_stage(const std::filesystem::path& boards,
                                  const std::filesystem::path& folder, int threads,
                                  Progress& progress) {
    const BoardPhotographs found = find_boards(boards, {}, threads, progress);
    const BoardCalibration calibration = calibrate_boards(found.board, {}, progress);
    for (const auto* left_out : {&found.left_out, &calibration.left_out}) {
        for (const LeftOut& photograph : *left_out) {
            progress.note("left out " + photograph.name + " (" + photograph.code +
                          "): " + photograph.reason);
        }
    }
    if (calibration.bow) progress.note(text_of(*calibration.bow));
    for (const std::string& warning : calibration.warnings) progress.note(warning);
    write_calibration(folder, found, calibration);
    return {json_text(calibration_json(found, calibration)), "{}"};
}

Camera read_calibrated_lens(const std::filesystem::path& folder) {
    return read_lens_file(folder / usual_file_name(LensFormat::kToml));
}

}  // namespace lumi
