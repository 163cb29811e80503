#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "tests/calib/known_poses/known_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string transforms_json(const Capture& capture, const std::string& lens,
                            const std::string& folder = "./images/") {
    std::ostringstream json;
    json.precision(17);
    json << "{" << lens << (lens.empty() ? "" : ", ") << "\"frames\": [";
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        const Axes axes = axes_of(capture.views[i]);
        json << (i > 0 ? ", " : "") << R"({"file_path": ")" << folder << capture.views[i].name
             << R"(", "transform_matrix": [)";
        for (int row = 0; row < 3; ++row) {
            json << "[" << axes.right[row] << ", " << -axes.down[row] << ", " << -axes.forward[row]
                 << ", " << axes.centre[row] << "], ";
        }
        json << "[0, 0, 0, 1]]}";
    }
    json << "]}";
    return json.str();
}

constexpr const char* kPinholeJson =
    R"("w": 640, "h": 480, "fl_x": 500, "fl_y": 510, "cx": 321.5, "cy": 238.25)";

TEST(TransformsJson, HasOpenGlAxes) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    scratch.put_text("transforms.json", transforms_json(capture, kPinholeJson));
    const PoseResult result =
        import_poses(photographs_of(capture), {}, scratch / "transforms.json");
    expect_poses(result.capture, capture, 1e-12);
    expect_lens(result.capture.cameras.at(0), true_camera(), 1e-12);
}

TEST(TransformsJson, WithAnAngleOfViewUsesThePhotographsSize) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const double angle_rad = 2 * std::atan(0.5 * 1280 / 1100.0);
    scratch.put_text("transforms.json",
                     transforms_json(capture, "\"camera_angle_x\": " + std::to_string(angle_rad)));
    const PoseResult result =
        import_poses(photographs_of(capture, 1280, 960), {}, scratch / "transforms.json");
    expect_lens(result.capture.cameras.at(0), pinhole_camera(kWidth, kHeight, 550), 1e-3);
}

TEST(TransformsJson, KeepsTheDistortionOfEachModel) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const auto lens = [&](const std::string& more) {
        scratch.put_text("t.json", transforms_json(capture, std::string(kPinholeJson) + more));
        return import_poses(photographs_of(capture), {}, scratch / "t.json").capture.cameras.at(0);
    };
    const auto distortion = [](const Camera& camera) {
        return std::vector<double>(camera.parameters.begin() + 4, camera.parameters.end());
    };
    const Camera open_cv = lens(R"(, "k1": 0.1, "k2": -0.2, "p1": 0.01, "p2": 0.02)");
    EXPECT_EQ(open_cv.model, LensModel::kOpenCv);
    EXPECT_THAT(distortion(open_cv), ElementsAre(0.1, -0.2, 0.01, 0.02));
    const Camera full = lens(R"(, "k1": 0.1, "k3": 0.3)");
    EXPECT_EQ(full.model, LensModel::kFullOpenCv);
    EXPECT_THAT(distortion(full), ElementsAre(0.1, 0, 0, 0, 0.3, 0, 0, 0));
    const Camera fisheye = lens(R"(, "camera_model": "OPENCV_FISHEYE", "k1": 0.1, "k4": 0.4)");
    EXPECT_EQ(fisheye.model, LensModel::kOpenCvFisheye);
    EXPECT_THAT(distortion(fisheye), ElementsAre(0.1, 0, 0, 0.4));
    EXPECT_THROW(static_cast<void>(lens(R"(, "k4": 0.1)")), Error);
    EXPECT_THROW(static_cast<void>(lens(R"(, "camera_model": "EQUIRECTANGULAR")")), Error);
}

TEST(TransformsJson, WithAnAngleOfViewKeepsTheRestOfTheLens) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const auto lens = [&](const std::string& more) {
        scratch.put_text("t.json", transforms_json(capture, R"("camera_angle_x": 1)" + more));
        return import_poses(photographs_of(capture), {}, scratch / "t.json").capture.cameras.at(0);
    };
    const double focal_px = 0.5 * kWidth / std::tan(0.5);
    const Camera bent = lens(R"(, "cx": 300, "cy": 250, "k1": 0.1, "p2": 0.02)");
    EXPECT_EQ(bent.model, LensModel::kOpenCv);
    EXPECT_THAT(bent.parameters, ElementsAre(focal_px, focal_px, 300, 250, 0.1, 0, 0, 0.02));
    const Camera fisheye = lens(R"(, "camera_model": "OPENCV_FISHEYE", "k1": 0.1)");
    EXPECT_EQ(fisheye.model, LensModel::kOpenCvFisheye);
    EXPECT_EQ(principal_point_px(fisheye), Eigen::Vector2d(0.5 * kWidth, 0.5 * kHeight));
    const Camera two_angles = lens(R"(, "camera_angle_y": 0.9)");
    EXPECT_EQ(focal_length_px(two_angles),
              Eigen::Vector2d(focal_px, 0.5 * kHeight / std::tan(0.45)));
    const auto code = [&](const std::string& more) {
        scratch.put_text("t.json", transforms_json(capture, R"("camera_angle_x": 1)" + more));
        return refusal(photographs_of(capture), scratch / "t.json").code();
    };
    EXPECT_EQ(code(R"(, "camera_model": "EQUIRECTANGULAR")"), "E-IMPORT-LENS");
    EXPECT_EQ(code(R"(, "k4": 0.1)"), "E-IMPORT-LENS");
    EXPECT_EQ(code(R"(, "is_fisheye": true, "p1": 0.1)"), "E-IMPORT-LENS");
    EXPECT_EQ(code(R"(, "cx": 700, "cy": 250)"), "E-IMPORT-SIZE");
}

TEST(TransformsJson, OfWindowsIsReadToo) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    std::string json = transforms_json(capture, kPinholeJson);
    const std::string slashes = "./images/view";
    for (auto at = json.find(slashes); at != std::string::npos; at = json.find(slashes)) {
        json.replace(at, slashes.size(), R"(.\\images\\view)");
    }
    scratch.put_text("t.json", "\xEF\xBB\xBF" + json);
    expect_poses(import_poses(photographs_of(capture), {}, scratch / "t.json").capture, capture,
                 1e-12);
}

TEST(TransformsJson, MayNameAPhotographTwiceUnlessItContradictsItself) {
    const ScratchFolder scratch;
    Capture capture = truth();
    capture.views.push_back(capture.views.front());
    scratch.put_text("t.json", transforms_json(capture, kPinholeJson));
    const PoseResult result = import_poses(photographs_of(truth()), {}, scratch / "t.json");
    expect_poses(result.capture, truth(), 1e-12);
    EXPECT_TRUE(result.not_registered.empty());
    capture.views.back().cam_from_world.translation.x() += 1;
    scratch.put_text("t.json", transforms_json(capture, kPinholeJson));
    EXPECT_EQ(refusal(photographs_of(truth()), scratch / "t.json").code(), "E-IMPORT-JSON");
}

TEST(TransformsJson, RefusesHalfASize) {
    const ScratchFolder scratch;
    const Capture capture = truth(1);
    for (const std::string size : {R"("w": 640)", R"("h": 480)"}) {
        scratch.put_text("t.json",
                         transforms_json(capture, size + R"(, "fl_x": 500, "cx": 320, "cy": 240)"));
        EXPECT_EQ(refusal(photographs_of(capture), scratch / "t.json").code(), "E-IMPORT-JSON");
    }
}

TEST(TransformsJson, MayGiveALensForEachFrame) {
    const ScratchFolder scratch;
    const Capture capture = truth(2);
    std::string json = transforms_json(capture, kPinholeJson);
    const std::string second = R"("file_path": "./images/view 001.jpg")";
    json.replace(json.find(second), second.size(), second + R"(, "fl_x": 700, "fl_y": 710)");
    scratch.put_text("transforms.json", json);
    const Capture found =
        import_poses(photographs_of(capture), {}, scratch / "transforms.json").capture;
    ASSERT_EQ(found.cameras.size(), 2U);
    EXPECT_EQ(focal_length_px(camera_of(found, found.views[0])), Eigen::Vector2d(500, 510));
    EXPECT_EQ(focal_length_px(camera_of(found, found.views[1])), Eigen::Vector2d(700, 710));
}

TEST(TransformsJson, RefusesDeepJsonInsteadOfExhaustingTheStack) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const auto nested = [](std::size_t depth) {
        return "{\"frames\": " + std::string(depth, '[') + std::string(depth, ']') + "}";
    };
    for (const std::size_t depth : {40U, 100000U, 5000000U}) {
        scratch.put_text("transforms.json", nested(depth));
        const Error error = refusal(photographs_of(capture), scratch / "transforms.json");
        EXPECT_EQ(error.code(), "E-IMPORT-JSON");
        EXPECT_THAT(error.what(), HasSubstr("nested")) << depth;
    }
}

TEST(TransformsJson, RefusesEveryTruncation) {
    const ScratchFolder scratch;
    const Capture capture = truth(1);
    const std::string json = transforms_json(capture, kPinholeJson);
    ASSERT_EQ(refusal(photographs_of(capture), scratch.path()).code(), "E-IMPORT-FORMAT");
    for (std::size_t length = 0; length < json.size(); length += 3) {
        scratch.put_text("transforms.json", json.substr(0, length));
        EXPECT_THAT(refusal(photographs_of(capture), scratch / "transforms.json").code(),
                    ::testing::AnyOf("E-IMPORT-JSON", "E-IMPORT-FORMAT"))
            << "length " << length;
    }
}

TEST(TransformsJson, RefusesMatricesThatAreNoRotations) {
    const ScratchFolder scratch;
    const Capture capture = truth(1);
    const std::string matrix = R"({"frames": [{"file_path": "view 000.jpg", "fl_x": 500, "w": 640,
        "h": 480, "transform_matrix": [[)";
    for (const std::string rows : {"2,0,0,0],[0,2,0,0],[0,0,2,0", "-1,0,0,0],[0,1,0,0],[0,0,1,0",
                                   "1,1,0,0],[0,1,0,0],[0,0,1,0"}) {
        scratch.put_text("transforms.json", matrix + rows + "]]}]}");
        EXPECT_EQ(refusal(photographs_of(capture), scratch / "transforms.json").code(),
                  "E-IMPORT-POSES")
            << rows;
    }
    scratch.put_text("transforms.json", matrix + "1e999,0,0,0],[0,1,0,0],[0,0,1,0" + "]]}]}");
    EXPECT_EQ(refusal(photographs_of(capture), scratch / "transforms.json").code(),
              "E-IMPORT-JSON");
}

}  // namespace
}  // namespace lumi
