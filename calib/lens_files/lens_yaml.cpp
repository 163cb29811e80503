#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/lens_files/lens_files.h"
#include "calib/lens_files/lens_readers.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

/// OpenCV, Kalibr and ROS count from the centre of the first pixel.
const Eigen::Vector2d kFirstPixelCentre(0.5, 0.5);

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-LENS-FILE", where + ": " + what,
                "give a YAML file of OpenCV, Kalibr (camchain), ROS (camera_info) or BoofCV for "
                "one camera, or write one with lumi calibrate");
}

/// Reads values of one document with the place in every message.
class YamlReader {
 public:
    YamlReader(YAML::Node node, std::string where)
        : node_(std::move(node)), where_(std::move(where)) {}

    [[nodiscard]] bool has(const std::string& key) const {
        return node_.IsMap() && node_[key].IsDefined();
    }
    [[nodiscard]] YamlReader at(const std::string& key) const {
        if (!has(key)) refuse(where_, "expected a key `" + key + "`");
        return {node_[key], where_ + ": " + key};
    }
    [[nodiscard]] std::string text() const {
        if (!node_.IsScalar()) refuse(where_, "expected a text");
        return node_.Scalar();
    }
    [[nodiscard]] double number() const {
        double value = 0;
        if (!node_.IsScalar() || !YAML::convert<double>::decode(node_, value) ||
            !std::isfinite(value)) {
            refuse(where_, "expected a finite number");
        }
        return value;
    }
    [[nodiscard]] int whole_number() const {
        const double value = number();
        constexpr double kLargest = 1e6;
        if (value != std::floor(value) || std::abs(value) > kLargest) {
            refuse(where_, "expected a whole number");
        }
        return static_cast<int>(value);
    }
    [[nodiscard]] std::vector<YamlReader> elements() const {
        if (!node_.IsSequence()) refuse(where_, "expected a list of numbers");
        constexpr std::size_t kLongest = 64;
        if (node_.size() > kLongest) refuse(where_, "the list is too long");
        std::vector<YamlReader> result;
        for (std::size_t index = 0; index < node_.size(); ++index) {
            result.push_back({node_[index], where_ + "[" + std::to_string(index) + "]"});
        }
        return result;
    }
    [[nodiscard]] std::vector<double> numbers() const {
        std::vector<double> values;
        for (const YamlReader& element : elements()) values.push_back(element.number());
        return values;
    }
    /// A matrix as OpenCV and ROS write it: rows, cols, data.
    [[nodiscard]] std::vector<double> matrix(int rows, int columns) const {
        std::vector<double> values = at("data").numbers();
        const int stated_rows = at("rows").whole_number();
        const int stated_columns = at("cols").whole_number();
        if (stated_rows < 0 || stated_columns < 0 ||
            static_cast<long>(stated_rows) * stated_columns != static_cast<long>(values.size())) {
            refuse(where_, "rows x cols is not the number of data");
        }
        const bool has_shape = stated_rows == rows && stated_columns == columns;
        if (rows > 0 && !has_shape) {
            refuse(where_, "expected a " + std::to_string(rows) + " x " + std::to_string(columns) +
                               " matrix");
        }
        return values;
    }
    [[noreturn]] void contradict(const std::string& what) const { refuse(where_, what); }

 private:
    YAML::Node node_;
    std::string where_;
};

Camera fisheye_lens(int width_px, int height_px, const Eigen::Vector2d& focal_px,
                    const Eigen::Vector2d& centre_px, const std::vector<double>& k) {
    return {width_px,
            height_px,
            LensModel::kOpenCvFisheye,
            {focal_px.x(), focal_px.y(), centre_px.x(), centre_px.y(), k[0], k[1], k[2], k[3]}};
}

/// OpenCV's order k1 k2 p1 p2 k3 k4 k5 k6; what follows (thin prism, tilt) must be zero.
std::array<double, 8> brown_coefficients(const std::vector<double>& values,
                                         const YamlReader& place) {
    std::array<double, 8> distortion{};
    for (std::size_t index = 0; index < values.size(); ++index) {
        if (index < distortion.size()) {
            distortion[index] = values[index];
        } else if (values[index] != 0) {
            place.contradict("thin prism and tilted sensor terms are not known here");
        }
    }
    return distortion;
}

Camera lens_of_kalibr(const YamlReader& document, const std::string& where) {
    if (document.has("cam1")) refuse(where, "holds several cameras: one is expected");
    const YamlReader camera = document.at("cam0");
    const std::string model = camera.at("camera_model").text();
    if (model != "pinhole") {
        camera.contradict("camera_model \"" + model + "\" is not known here: pinhole is expected");
    }
    const std::vector<double> intrinsics = camera.at("intrinsics").numbers();
    const std::vector<YamlReader> resolution = camera.at("resolution").elements();
    if (intrinsics.size() != 4) camera.contradict("expected four intrinsics");
    if (resolution.size() != 2) camera.contradict("expected a width and a height as resolution");
    const int width_px = resolution[0].whole_number();
    const int height_px = resolution[1].whole_number();
    const Eigen::Vector2d focal_px(intrinsics[0], intrinsics[1]);
    const Eigen::Vector2d centre_px =
        Eigen::Vector2d(intrinsics[2], intrinsics[3]) + kFirstPixelCentre;
    const std::string distortion =
        camera.has("distortion_model") ? camera.at("distortion_model").text() : "none";
    const std::vector<double> coefficients = camera.has("distortion_coeffs")
                                                 ? camera.at("distortion_coeffs").numbers()
                                                 : std::vector<double>{};
    if (distortion == "none") {
        if (std::any_of(coefficients.begin(), coefficients.end(),
                        [](double k) { return k != 0; })) {
            camera.contradict("distortion_coeffs without a distortion_model");
        }
        return simplest_lens(width_px, height_px, focal_px, centre_px, {});
    }
    if (coefficients.size() != 4) camera.contradict("expected four distortion_coeffs");
    if (distortion == "equidistant") {
        return fisheye_lens(width_px, height_px, focal_px, centre_px, coefficients);
    }
    if (distortion != "radtan") {
        camera.contradict("distortion_model \"" + distortion +
                          "\" is not known here: radtan, equidistant or none");
    }
    return simplest_lens(width_px, height_px, focal_px, centre_px,
                         brown_coefficients(coefficients, camera));
}

/// intrinsic.yaml of BoofCV: perspective with radial terms.
Camera lens_of_boofcv(const YamlReader& document) {
    const std::string model = document.has("model") ? document.at("model").text() : "pinhole";
    if (model != "pinhole" && model != "pinhole_radial_tangential") {
        document.at("model").contradict("\"" + model +
                                        "\" is not known here: pinhole_radial_tangential");
    }
    const YamlReader pinhole = document.at("pinhole");
    if (pinhole.at("skew").number() != 0) pinhole.contradict("a skew is not known here");
    std::array<double, 8> distortion{};
    if (document.has("radial_tangential")) {
        const YamlReader terms = document.at("radial_tangential");
        const std::vector<double> radial = terms.at("radial").numbers();
        if (radial.size() > 3) terms.contradict("expected at most three radial terms");
        constexpr std::array<std::size_t, 3> kPlaces{0, 1, 4};
        for (std::size_t index = 0; index < radial.size(); ++index) {
            distortion[kPlaces[index]] = radial[index];
        }
        distortion[2] = terms.at("t1").number();
        distortion[3] = terms.at("t2").number();
    }
    return simplest_lens(
        pinhole.at("width").whole_number(), pinhole.at("height").whole_number(),
        {pinhole.at("fx").number(), pinhole.at("fy").number()},
        Eigen::Vector2d(pinhole.at("cx").number(), pinhole.at("cy").number()) + kFirstPixelCentre,
        distortion);
}

bool is_fisheye(const YamlReader& document) {
    if (document.has("distortion_model")) {
        const std::string model = document.at("distortion_model").text();
        if (model == "equidistant" || model == "fisheye") return true;
        if (model != "plumb_bob" && model != "rational_polynomial") {
            document.at("distortion_model")
                .contradict("\"" + model +
                            "\" is not known here: plumb_bob, rational_polynomial or equidistant");
        }
        return false;
    }
    return document.has("fisheye_model") && document.at("fisheye_model").whole_number() != 0;
}

Camera lens_of_opencv_or_ros(const YamlReader& document) {
    const int width_px = document.at("image_width").whole_number();
    const int height_px = document.at("image_height").whole_number();
    const YamlReader place = document.at("camera_matrix");
    const std::vector<double> k = place.matrix(3, 3);
    if (k[1] != 0) place.contradict("a skew is not known here");
    if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
        place.contradict("is not a camera matrix: expected (fx 0 cx, 0 fy cy, 0 0 1)");
    }
    const YamlReader distortion = document.at("distortion_coefficients");
    const std::vector<double> coefficients = distortion.matrix(0, 0);
    const Eigen::Vector2d centre_px = Eigen::Vector2d(k[2], k[5]) + kFirstPixelCentre;
    if (is_fisheye(document)) {
        if (coefficients.size() != 4) distortion.contradict("expected four of a fisheye");
        return fisheye_lens(width_px, height_px, {k[0], k[4]}, centre_px, coefficients);
    }
    constexpr std::array<std::size_t, 6> kCounts{0, 4, 5, 8, 12, 14};
    if (std::find(kCounts.begin(), kCounts.end(), coefficients.size()) == kCounts.end()) {
        distortion.contradict("expected 4, 5, 8, 12 or 14 of them");
    }
    return simplest_lens(width_px, height_px, {k[0], k[4]}, centre_px,
                         brown_coefficients(coefficients, distortion));
}

}  // namespace

Camera read_lens_yaml(const std::string& text, const std::string& where) {
    // OpenCV begins with a directive that is not YAML's.
    std::string body = text;
    if (body.starts_with("%YAML:")) body.erase(0, std::min(body.find('\n'), body.size()));
    YAML::Node node;
    try {
        node = YAML::Load(body);
        const YamlReader document(node, where);
        if (!node.IsMap()) refuse(where, "is not a YAML file with keys");
        Camera lens = document.has("cam0")      ? lens_of_kalibr(document, where)
                      : document.has("pinhole") ? lens_of_boofcv(document)
                                                : lens_of_opencv_or_ros(document);
        validate(lens, where);
        return lens;
    } catch (const YAML::Exception& error) {
        refuse(where + ":" + std::to_string(error.mark.line + 1), error.msg);
    }
}

}  // namespace lumi
