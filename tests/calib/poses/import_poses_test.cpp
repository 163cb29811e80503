#include <gmock/gmock.h>

#include <sstream>

#include "calib/capture/colmap_model.h"
#include "calib/known_poses/name_matching.h"
#include "calib/work/whole_file.h"
#include "tests/calib/known_poses/known_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using ::testing::HasSubstr;

TEST(ImportPoses, AColmapModelComesBackAsItWas) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    write_colmap_model_binary(capture, scratch / "sparse");
    const PoseResult result = import_poses(photographs_of(capture), {}, scratch / "sparse");
    expect_poses(result.capture, capture, 1e-12);
    EXPECT_EQ(result.capture.cameras, capture.cameras);
    ASSERT_EQ(result.capture.points.size(), capture.points.size());
    EXPECT_EQ(result.evidence.photographs_registered, 4);
    EXPECT_EQ(result.evidence.points, 12);
    EXPECT_LT(result.evidence.mean_reprojection_error_px, 1e-9);
    EXPECT_TRUE(result.not_registered.empty());
}

TEST(ImportPoses, LensesAndTracksFollowTheWorkingCopies) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    write_colmap_model_text(capture, scratch / "sparse");
    // The model was made with 640x480; the photographs are twice that, the working copies half.
    const auto photographs = photographs_of(capture, 1280, 960, 320, 240);
    const PoseResult result = import_poses(photographs, {}, scratch / "sparse");
    expect_lens(result.capture.cameras.at(0), resized(true_camera(), 320, 240), 1e-12);
    EXPECT_LT(result.evidence.mean_reprojection_error_px, 1e-9);
    EXPECT_GT(result.evidence.observations, 40);
}

TEST(ImportPoses, MiddleburyIsCalibrationRotationTranslation) {
    const ScratchFolder scratch;
    Capture capture = truth(3);
    std::ostringstream text;
    text.precision(17);
    text << "3\n";
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        View& view = capture.views[i];
        view.name = "temple000" + std::to_string(i) + ".png";
        text << view.name << " 500 0 321 0 510 237.75 0 0 1";
        const Eigen::Matrix3d rotation = view.cam_from_world.rotation.toRotationMatrix();
        for (int k = 0; k < 9; ++k) text << " " << rotation(k / 3, k % 3);
        for (int k = 0; k < 3; ++k) text << " " << view.cam_from_world.translation[k];
        text << "\n";
    }
    scratch.put_text("temple_par.txt", text.str());
    const PoseResult result = import_poses(photographs_of(capture), {}, scratch / "temple_par.txt");
    expect_poses(result.capture, capture, 1e-12);
    expect_lens(result.capture.cameras.at(0), true_camera(), 1e-12);
    // The lens is for the photographs' own size: on quarter-size pictures it makes no sense.
    EXPECT_EQ(refusal(photographs_of(capture, 160, 120), scratch / "temple_par.txt").code(),
              "E-IMPORT-SIZE");
    scratch.put_text("short_par.txt", "4" + text.str().substr(1));
    EXPECT_EQ(refusal(photographs_of(capture), scratch / "short_par.txt").code(), "E-IMPORT-POSES");
}

TEST(ImportPoses, StrechaIsForItsStatedSizeAndRotatesWorldFromCamera) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    for (const View& view : capture.views) {
        const Axes axes = axes_of(view);
        std::ostringstream text;
        text.precision(17);
        text << "1000 0 642.5\n0 1020 476\n0 0 1\n0 0 0\n";
        for (int row = 0; row < 3; ++row) {
            text << axes.right[row] << " " << axes.down[row] << " " << axes.forward[row] << "\n";
        }
        text << axes.centre.transpose() << "\n1280 960\n";
        write_whole_text(scratch / ("cameras/" + view.name + ".camera"), text.str());
    }
    const PoseResult result = import_poses(photographs_of(capture), {}, scratch / "cameras");
    expect_poses(result.capture, capture, 1e-12);
    expect_lens(result.capture.cameras.at(0), true_camera(), 1e-12);
}

TEST(ImportPoses, StrechaIsRefusedUnlessItHoldsACalibrationAndARotation) {
    const ScratchFolder scratch;
    const Capture capture = truth(1);
    const std::string calibration = "1000 0 642.5\n0 1020 476\n0 0 1\n";
    const std::string rotation = "1 0 0\n0 1 0\n0 0 1\n";
    const auto code = [&](const std::string& k, const std::string& axes,
                          const std::string& distortion = "0 0 0\n") {
        write_whole_text(scratch / "cameras/view 000.jpg.camera",
                         k + distortion + axes + "1 2 3\n1280 960\n");
        return refusal(photographs_of(capture), scratch / "cameras").code();
    };
    EXPECT_EQ(code(calibration, rotation), "none");
    EXPECT_EQ(refusal(photographs_of(capture), scratch / "cameras/view 000.jpg.camera").code(),
              "none")
        << "the file alone";
    for (const std::string axes : {"-1 0 0\n0 1 0\n0 0 1\n", "1 0 0\n0 0 1\n0 1 0\n",
                                   "2 0 0\n0 2 0\n0 0 2\n", "1 1 0\n0 1 0\n0 0 1\n"}) {
        EXPECT_EQ(code(calibration, axes), "E-IMPORT-POSES") << axes;
    }
    for (const std::string k :
         {"1000 9 642.5\n0 1020 476\n0 0 1\n", "1000 0 642.5\n7 1020 476\n0 0 1\n",
          "1000 0 642.5\n0 1020 476\n0 0 2\n", "1000 0 642.5\n0 1020 476\n0 1 1\n",
          "-1000 0 642.5\n0 1020 476\n0 0 1\n"}) {
        EXPECT_EQ(code(k, rotation), "E-IMPORT-POSES") << k;
    }
    EXPECT_EQ(code(calibration, rotation, "0.1 0 0\n"), "E-IMPORT-STRECHA");
    EXPECT_EQ(code(calibration, "one 0 0\n"), "E-IMPORT-STRECHA");
}

TEST(ImportPoses, NamesWhatHasNoPoseAndWhatHasNoPhotograph) {
    const ScratchFolder scratch;
    const Capture capture = truth(4);
    write_colmap_model_binary(capture, scratch / "sparse");
    auto photographs = photographs_of(capture);
    photographs[1].name = "another.jpg";
    const PoseResult result = import_poses(photographs, {}, scratch / "sparse");
    EXPECT_EQ(result.capture.views.size(), 3U);
    ASSERT_EQ(result.not_registered.size(), 2U);
    EXPECT_EQ(result.not_registered[0].name, "view 001.jpg");
    EXPECT_EQ(result.not_registered[0].code, "E-IMPORT-NOPHOTO");
    EXPECT_EQ(result.not_registered[1].name, "another.jpg");
    EXPECT_EQ(result.not_registered[1].code, "E-IMPORT-NOPOSE");
    for (const ScenePoint& point : result.capture.points) {
        for (const Observation& observation : point.track) EXPECT_LT(observation.view_index, 3);
    }
    EXPECT_LT(result.evidence.mean_reprojection_error_px, 1e-9);
}

TEST(ImportPoses, RefusesPosesOfOtherPhotographsByName) {
    const ScratchFolder scratch;
    const Capture capture = truth(2);
    write_colmap_model_binary(capture, scratch / "sparse");
    auto photographs = photographs_of(capture);
    photographs[0].name = "a.jpg";
    photographs[1].name = "b.jpg";
    const Error error = refusal(photographs, scratch / "sparse");
    EXPECT_EQ(error.code(), "E-IMPORT-NAMES");
    EXPECT_THAT(error.what(), HasSubstr("view 000.jpg"));
}

TEST(ImportPoses, RefusesLensesOfOtherPictures) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    write_colmap_model_binary(capture, scratch / "sparse");
    const auto what = [&](const std::vector<Photograph>& photographs) {
        const Error error = refusal(photographs, scratch / "sparse");
        return error.code() + " " + error.what();
    };
    EXPECT_THAT(what(photographs_of(capture, 640, 400)),
                AllOf(HasSubstr("E-IMPORT-SIZE"), HasSubstr("cropped")));
    EXPECT_THAT(what(photographs_of(capture, 480, 640)),
                AllOf(HasSubstr("E-IMPORT-SIZE"), HasSubstr("upright")));
    // Undistorted pictures: each within rounding of the shape, but no two of one size.
    auto undistorted = photographs_of(capture);
    undistorted[1].original_width_px = 627;
    undistorted[1].original_height_px = 470;
    EXPECT_THAT(what(undistorted), AllOf(HasSubstr("E-IMPORT-SIZE"), HasSubstr("several sizes")));
    // 3003 x 2000 scaled to 1502 x 1000: within rounding.
    Capture large = capture;
    large.cameras[0] = pinhole_camera(3003, 2000, 2500);
    write_colmap_model_binary(large, scratch / "large");
    EXPECT_EQ(refusal(photographs_of(large, 1502, 1000, 1502, 1000), scratch / "large").code(),
              "none");
}

TEST(NameMatching, FindsTheSamePhotographUnderTheNamesThatProgramsGiveIt) {
    using Matches = std::vector<std::optional<std::size_t>>;
    EXPECT_EQ(matched_names({"b.jpg", "a.jpg"}, {"a.jpg", "b.jpg"}), (Matches{1, 0}));
    EXPECT_EQ(matched_names({"./images/a"}, {"a.jpg"}), (Matches{0}));
    EXPECT_EQ(matched_names({"../photos/left/1.jpg", "../photos/right/1.jpg"},
                            {"left/1.jpg", "right/1.jpg"}),
              (Matches{0, 1}));
    EXPECT_EQ(matched_names({"2021 20.23.45.jpg"}, {"20.23.45.jpg"}), (Matches{0}));
    EXPECT_EQ(matched_names({".\\images\\left\\1.jpg", ".\\images\\right\\1.jpg"},
                            {"left/1.jpg", "right/1.jpg"}),
              (Matches{0, 1}));
    EXPECT_EQ(matched_names({"1.jpg"}, {"left/1.jpg", "right/1.jpg"}), (Matches{std::nullopt}));
    EXPECT_EQ(matched_names({"./train/scan.0001", "./train/scan.0000"},
                            {"scan.0000.png", "scan.0001.png"}),
              (Matches{1, 0}));
}

}  // namespace
}  // namespace lumi
