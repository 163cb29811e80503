#include <algorithm>
#include <array>
#include <charconv>

#include "calib/lens_files/lens_files.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr double kHalfPixel = 0.5;

/// The shortest text that is read back to the same bits, always recognisable as not whole.
std::string number(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    std::string result(text.data(), end);
    if (result.find_first_of(".en") == std::string::npos) result += ".0";
    return result;
}

std::string joined(const std::vector<double>& values, const std::string& separator) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : separator) + number(value);
    return text;
}

std::string comments(const std::vector<std::string>& remarks) {
    std::string text;
    for (const std::string& remark : remarks) text += "# " + remark + "\n";
    return text;
}

/// k1 k2 p1 p2 k3 k4 k5 k6 of a lens that is not a fisheye.
std::array<double, 8> brown(const Camera& lens) {
    std::array<double, 8> distortion{};
    const std::size_t first = first_distortion_parameter(lens.model);
    std::copy(lens.parameters.begin() + static_cast<std::ptrdiff_t>(first), lens.parameters.end(),
              distortion.begin());
    return distortion;
}

bool is_fisheye(const Camera& lens) { return lens.model == LensModel::kOpenCvFisheye; }

bool is_rational(const Camera& lens) {
    if (is_fisheye(lens)) return false;
    const std::array<double, 8> distortion = brown(lens);
    return std::any_of(distortion.begin() + 4, distortion.end(), [](double k) { return k != 0; });
}

/// As many coefficients as the format asks for, or the four of a fisheye.
std::vector<double> coefficients(const Camera& lens, std::size_t least) {
    if (is_fisheye(lens)) return {lens.parameters.begin() + 4, lens.parameters.end()};
    const std::array<double, 8> distortion = brown(lens);
    const std::size_t count = is_rational(lens) ? 8 : least;
    return {distortion.begin(), distortion.begin() + static_cast<std::ptrdiff_t>(count)};
}

std::vector<double> camera_matrix(const Camera& lens) {
    const Eigen::Vector2d focal_px = focal_length_px(lens);
    const Eigen::Vector2d centre_px = principal_point_px(lens).array() - kHalfPixel;
    return {focal_px.x(), 0, centre_px.x(), 0, focal_px.y(), centre_px.y(), 0, 0, 1};
}

std::string toml_text(const Camera& lens, const std::vector<std::string>& remarks) {
    return comments(remarks) + "model = \"" + std::string(name_of(lens.model)) +
           "\"\nwidth_px = " + std::to_string(lens.width_px) +
           "\nheight_px = " + std::to_string(lens.height_px) + "\nparameters = [" +
           joined(lens.parameters, ", ") + "]\n";
}

std::string colmap_text(const Camera& lens, const std::vector<std::string>& remarks) {
    return "# Camera list with one line of data per camera:\n"
           "#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n" +
           comments(remarks) + "1 " + std::string(name_of(lens.model)) + " " +
           std::to_string(lens.width_px) + " " + std::to_string(lens.height_px) + " " +
           joined(lens.parameters, " ") + "\n";
}

std::string opencv_matrix(const std::string& name, int rows, int columns,
                          const std::vector<double>& values) {
    return name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
           "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: [ " +
           joined(values, ", ") + " ]\n";
}

std::string opencv_text(const Camera& lens, const std::vector<std::string>& remarks) {
    const std::vector<double> distortion = coefficients(lens, 5);
    return "%YAML:1.0\n---\n" + comments(remarks) +
           "image_width: " + std::to_string(lens.width_px) +
           "\nimage_height: " + std::to_string(lens.height_px) +
           "\nfisheye_model: " + (is_fisheye(lens) ? "1" : "0") + "\n" +
           opencv_matrix("camera_matrix", 3, 3, camera_matrix(lens)) +
           opencv_matrix("distortion_coefficients", static_cast<int>(distortion.size()), 1,
                         distortion);
}

std::string kalibr_text(const Camera& lens, const std::vector<std::string>& remarks) {
    if (is_rational(lens)) {
        throw Error(ErrorKind::kBadInput, "E-LENS-FORMAT",
                    "Kalibr's radtan model has no k3 to k6, and this lens needs them",
                    "leave out the format, or calibrate with --models up to OPENCV");
    }
    const std::vector<double> matrix = camera_matrix(lens);
    return comments(remarks) + "cam0:\n  camera_model: pinhole\n  intrinsics: [" +
           joined({matrix[0], matrix[4], matrix[2], matrix[5]}, ", ") +
           "]\n  distortion_model: " + (is_fisheye(lens) ? "equidistant" : "radtan") +
           "\n  distortion_coeffs: [" + joined(coefficients(lens, 4), ", ") + "]\n  resolution: [" +
           std::to_string(lens.width_px) + ", " + std::to_string(lens.height_px) +
           "]\n  rostopic: /cam0/image_raw\n";
}

std::string ros_matrix(const std::string& name, int rows, int columns,
                       const std::vector<double>& values) {
    return name + ":\n  rows: " + std::to_string(rows) + "\n  cols: " + std::to_string(columns) +
           "\n  data: [" + joined(values, ", ") + "]\n";
}

std::string ros_text(const Camera& lens, const std::vector<std::string>& remarks) {
    const std::vector<double> distortion = coefficients(lens, 5);
    const std::vector<double> k = camera_matrix(lens);
    const std::string model = is_fisheye(lens)    ? "equidistant"
                              : is_rational(lens) ? "rational_polynomial"
                                                  : "plumb_bob";
    return comments(remarks) + "image_width: " + std::to_string(lens.width_px) +
           "\nimage_height: " + std::to_string(lens.height_px) + "\ncamera_name: camera\n" +
           ros_matrix("camera_matrix", 3, 3, k) + "distortion_model: " + model + "\n" +
           ros_matrix("distortion_coefficients", 1, static_cast<int>(distortion.size()),
                      distortion) +
           ros_matrix("rectification_matrix", 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
           ros_matrix("projection_matrix", 3, 4, {k[0], 0, k[2], 0, 0, k[4], k[5], 0, 0, 0, 1, 0});
}

}  // namespace

std::string lens_text(const Camera& lens, LensFormat format,
                      const std::vector<std::string>& remarks) {
    validate(lens, "the lens to be written");
    switch (format) {
        case LensFormat::kToml:
            return toml_text(lens, remarks);
        case LensFormat::kColmap:
            return colmap_text(lens, remarks);
        case LensFormat::kOpenCv:
            return opencv_text(lens, remarks);
        case LensFormat::kKalibr:
            return kalibr_text(lens, remarks);
        case LensFormat::kRos:
            break;
    }
    return ros_text(lens, remarks);
}

}  // namespace lumi
