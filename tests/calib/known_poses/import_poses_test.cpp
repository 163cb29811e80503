#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "calib/capture/colmap_model.h"
#include "calib/known_poses/name_matching.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int kWidth = 640;
constexpr int kHeight = 480;

Camera true_camera() { return {kWidth, kHeight, LensModel::kPinhole, {500, 510, 321.5, 238.25}}; }

Capture truth(int views = 4) { return synthetic_capture(true_camera(), views, 12); }

/// The photographs of a capture as ingest hands them on: originals of one size, working copies of
/// another.
std::vector<Photograph> photographs_of(const Capture& capture, int original_width = kWidth,
                                       int original_height = kHeight, int copy_width = kWidth,
                                       int copy_height = kHeight) {
    std::vector<Photograph> photographs;
    for (const View& view : capture.views) {
        Photograph photograph;
        photograph.name = view.name;
        photograph.original_width_px = original_width;
        photograph.original_height_px = original_height;
        photograph.width_px = copy_width;
        photograph.height_px = copy_height;
        photographs.push_back(photograph);
    }
    return photographs;
}

Error refusal(const std::vector<Photograph>& photographs, const std::filesystem::path& poses) {
    try {
        static_cast<void>(import_poses(photographs, poses));
    } catch (const Error& error) {
        return error;
    }
    return {ErrorKind::kUsage, "none", "was not refused", ""};
}

void expect_poses(const Capture& found, const Capture& expected, double tolerance) {
    ASSERT_EQ(found.views.size(), expected.views.size());
    for (std::size_t i = 0; i < found.views.size(); ++i) {
        const View& view = found.views[i];
        const Rigid3& truth_pose = expected.views[i].cam_from_world;
        EXPECT_EQ(view.name, expected.views[i].name);
        EXPECT_LT((centre_in_world(view.cam_from_world) - centre_in_world(truth_pose)).norm(),
                  tolerance)
            << view.name;
        EXPECT_LT(view.cam_from_world.rotation.angularDistance(truth_pose.rotation), tolerance)
            << view.name;
    }
}

void expect_lens(const Camera& found, const Camera& expected, double tolerance_px) {
    EXPECT_EQ(found.width_px, expected.width_px);
    EXPECT_EQ(found.height_px, expected.height_px);
    EXPECT_LT((focal_length_px(found) - focal_length_px(expected)).norm(), tolerance_px);
    EXPECT_LT((principal_point_px(found) - principal_point_px(expected)).norm(), tolerance_px);
}

struct Axes {
    Eigen::Vector3d right, down, forward, centre;
};

Axes axes_of(const View& view) {
    const Eigen::Matrix3d cam_from_world = view.cam_from_world.rotation.toRotationMatrix();
    return {cam_from_world.row(0), cam_from_world.row(1), cam_from_world.row(2),
            centre_in_world(view.cam_from_world)};
}

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

TEST(ImportPoses, AColmapModelComesBackAsItWas) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    write_colmap_model_binary(capture, scratch / "sparse");
    const PoseResult result = import_poses(photographs_of(capture), scratch / "sparse");
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
    const PoseResult result = import_poses(photographs, scratch / "sparse");
    expect_lens(result.capture.cameras.at(0), resized(true_camera(), 320, 240), 1e-12);
    EXPECT_LT(result.evidence.mean_reprojection_error_px, 1e-9);
    EXPECT_GT(result.evidence.observations, 40);
}

TEST(ImportPoses, TransformsJsonHasOpenGlAxes) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    scratch.put_text("transforms.json", transforms_json(capture, kPinholeJson));
    const PoseResult result = import_poses(photographs_of(capture), scratch / "transforms.json");
    expect_poses(result.capture, capture, 1e-12);
    expect_lens(result.capture.cameras.at(0), true_camera(), 1e-12);
}

TEST(ImportPoses, TransformsJsonWithAnAngleOfViewUsesThePhotographsSize) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const double angle_rad = 2 * std::atan(0.5 * 1280 / 1100.0);
    scratch.put_text("transforms.json",
                     transforms_json(capture, "\"camera_angle_x\": " + std::to_string(angle_rad)));
    const PoseResult result =
        import_poses(photographs_of(capture, 1280, 960), scratch / "transforms.json");
    expect_lens(result.capture.cameras.at(0), pinhole_camera(kWidth, kHeight, 550), 1e-3);
}

TEST(ImportPoses, TransformsJsonKeepsTheDistortionOfEachModel) {
    const ScratchFolder scratch;
    const Capture capture = truth();
    const auto lens = [&](const std::string& more) {
        scratch.put_text("t.json", transforms_json(capture, std::string(kPinholeJson) + more));
        return import_poses(photographs_of(capture), scratch / "t.json").capture.cameras.at(0);
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

TEST(ImportPoses, TransformsJsonMayGiveALensForEachFrame) {
    const ScratchFolder scratch;
    const Capture capture = truth(2);
    std::string json = transforms_json(capture, kPinholeJson);
    const std::string second = R"("file_path": "./images/view 001.jpg")";
    json.replace(json.find(second), second.size(), second + R"(, "fl_x": 700, "fl_y": 710)");
    scratch.put_text("transforms.json", json);
    const Capture found =
        import_poses(photographs_of(capture), scratch / "transforms.json").capture;
    ASSERT_EQ(found.cameras.size(), 2U);
    EXPECT_EQ(focal_length_px(camera_of(found, found.views[0])), Eigen::Vector2d(500, 510));
    EXPECT_EQ(focal_length_px(camera_of(found, found.views[1])), Eigen::Vector2d(700, 710));
}

TEST(ImportPoses, RefusesDeepJsonInsteadOfExhaustingTheStack) {
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

TEST(ImportPoses, RefusesEveryTruncationOfTransformsJson) {
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

TEST(ImportPoses, RefusesMatricesThatAreNoRotations) {
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

/// A .npy file of version 1.
Bytes npy(const std::string& type, const std::string& shape, const std::vector<double>& values) {
    std::string header =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    header.resize((header.size() + 10 + 63) / 64 * 64 - 10, ' ');
    std::string text = "\x93NUMPY";
    text +=
        {'\1', '\0', static_cast<char>(header.size() & 255), static_cast<char>(header.size() >> 8)};
    text += header;
    Bytes bytes(text.begin(), text.end());
    for (const double value : values) {
        std::uint8_t raw[8];
        const auto single = static_cast<float>(value);
        const std::size_t size = type == "<f8" ? 8 : 4;
        if (size == 8) {
            std::memcpy(raw, &value, 8);
        } else {
            std::memcpy(raw, &single, 4);
        }
        bytes.insert(bytes.end(), raw, raw + size);
    }
    return bytes;
}

std::vector<double> llff_values(const Capture& capture, double focal) {
    std::vector<double> values;
    const double size_and_focal[3] = {kHeight, kWidth, focal};
    for (const View& view : capture.views) {
        const Axes axes = axes_of(view);
        for (int row = 0; row < 3; ++row) {
            values.insert(values.end(), {axes.down[row], axes.right[row], -axes.forward[row],
                                         axes.centre[row], size_and_focal[row]});
        }
        values.insert(values.end(), {1.0, 10.0});
    }
    return values;
}

TEST(ImportPoses, PosesBoundsHasDownRightBackAxesAndPairsByOrder) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    for (const std::string type : {"<f8", "<f4"}) {
        scratch.put("poses_bounds.npy", npy(type, "(3, 17)", llff_values(capture, 500)));
        const PoseResult result = import_poses(photographs_of(capture, kWidth, kHeight, 320, 240),
                                               scratch / "poses_bounds.npy");
        expect_poses(result.capture, capture, type == "<f8" ? 1e-12 : 1e-6);
        expect_lens(result.capture.cameras.at(0), pinhole_camera(320, 240, 250), 1e-12);
    }
    EXPECT_EQ(refusal(photographs_of(truth(4)), scratch / "poses_bounds.npy").code(),
              "E-IMPORT-COUNT");
}

TEST(ImportPoses, RefusesArraysThatAreNotWhatTheyClaim) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    const auto photographs = photographs_of(capture);
    const auto values = llff_values(capture, 500);
    const auto code = [&](const Bytes& bytes) {
        scratch.put("poses_bounds.npy", bytes);
        return refusal(photographs, scratch / "poses_bounds.npy").code();
    };
    EXPECT_EQ(code(npy("<f8", "(3, 17)", values)), "none");
    EXPECT_EQ(code(npy(">f8", "(3, 17)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(51,)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(4, 17)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(4611686018427387904, 8)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(17, 3)", values)), "E-IMPORT-POSES");
    EXPECT_EQ(code(npy("<f8", "(3, 17)", llff_values(capture, -5))), "E-IMPORT-POSES");
    auto not_finite = values;
    not_finite[3] = std::nan("");
    EXPECT_EQ(code(npy("<f8", "(3, 17)", not_finite)), "E-IMPORT-POSES");
    const Bytes whole = npy("<f8", "(3, 17)", values);
    for (std::size_t length = 6; length < whole.size(); ++length) {
        EXPECT_EQ(code(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))),
                  "E-IMPORT-NPY")
            << "length " << length;
    }
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
    const PoseResult result = import_poses(photographs_of(capture), scratch / "temple_par.txt");
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
    const PoseResult result = import_poses(photographs_of(capture), scratch / "cameras");
    expect_poses(result.capture, capture, 1e-12);
    expect_lens(result.capture.cameras.at(0), true_camera(), 1e-12);
}

TEST(ImportPoses, NamesWhatHasNoPoseAndWhatHasNoPhotograph) {
    const ScratchFolder scratch;
    const Capture capture = truth(4);
    write_colmap_model_binary(capture, scratch / "sparse");
    auto photographs = photographs_of(capture);
    photographs[1].name = "another.jpg";
    const PoseResult result = import_poses(photographs, scratch / "sparse");
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
    EXPECT_EQ(matched_names({"1.jpg"}, {"left/1.jpg", "right/1.jpg"}), (Matches{std::nullopt}));
}

}  // namespace
}  // namespace lumi
