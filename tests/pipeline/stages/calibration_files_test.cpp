#include "pipeline/stages/calibration_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/lens/lens_form.h"
#include "calib/work/whole_file.h"
#include "pipeline/stages/calibration_json.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::Not;

BoardCalibration calibration_of_flat_board() {
    BoardCalibration calibration;
    calibration.form = all_free(LensModel::kPinhole);
    calibration.lens = {640, 480, LensModel::kPinhole, {500, 501, 320, 240}};
    LensTrial trial;
    trial.form = calibration.form;
    trial.lens = calibration.lens;
    calibration.choice.trials = {trial};
    calibration.size_per_pitch = 1.0;
    return calibration;
}

BoardCalibration calibration_of_bent_board() {
    BoardCalibration calibration = calibration_of_flat_board();
    calibration.bow = BoardBend{{0.001, 0.0, 0.0}, 0.0047, 0.0006, 0.038, 8.0};
    calibration.choice.trials.front().beside = "bent board";
    calibration.choice.trials.front().parameters_beside = 3;
    return calibration;
}

TEST(CalibrationFiles, TellMachinesHowFarTheBoardIsBentAndNothingOfAFlatOne) {
    EXPECT_TRUE(calibration_json({}, calibration_of_flat_board()).at("board").at("bow").is_null());
    const auto bent = calibration_json({}, calibration_of_bent_board());
    EXPECT_EQ(bent.at("board").at("bow").at("share_of_width"), 0.0047);
    EXPECT_EQ(bent.at("board").at("bow").at("sigma"), 0.0006);
    EXPECT_EQ(bent.at("board").at("bow").at("per_pitch").at(0), 0.001);
    EXPECT_EQ(bent.at("models").at(0).at("form"), "PINHOLE, bent board");
    EXPECT_EQ(bent.at("models").at(0).at("free_parameters"), 4 + 3);
}

TEST(CalibrationFiles, SayToWhoeverReadsTheLensThatTheBoardWasBent) {
    const ScratchFolder scratch;
    write_calibration(scratch / "flat", {}, calibration_of_flat_board());
    write_calibration(scratch / "bent", {}, calibration_of_bent_board());
    EXPECT_THAT(read_whole_text(scratch / "flat/camera.toml"), Not(HasSubstr("bent")));
    EXPECT_THAT(read_whole_text(scratch / "bent/camera.toml"),
                HasSubstr("bent by 0.47 +- 0.06 % of its width"));
}

}  // namespace
}  // namespace lumi
