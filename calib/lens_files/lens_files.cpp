#include "calib/lens_files/lens_files.h"

#include <algorithm>

#include "calib/lens_files/lens_readers.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

struct FormatEntry {
    LensFormat format;
    std::string_view name;
    std::string_view file_name;
};
constexpr std::array<FormatEntry, 5> kEntries{
    {{LensFormat::kToml, "toml", "camera.toml"},
     {LensFormat::kColmap, "colmap", "cameras.txt"},
     {LensFormat::kOpenCv, "opencv", "camera_opencv.yaml"},
     {LensFormat::kKalibr, "kalibr", "camchain.yaml"},
     {LensFormat::kRos, "ros", "camera_info.yaml"}}};

const FormatEntry& entry_of(LensFormat format) {
    return *std::find_if(kEntries.begin(), kEntries.end(),
                         [&](const FormatEntry& entry) { return entry.format == format; });
}

}  // namespace

std::string_view name_of(LensFormat format) { return entry_of(format).name; }

std::string_view usual_file_name(LensFormat format) { return entry_of(format).file_name; }

void write_lens_file(const std::filesystem::path& path, const Camera& lens, LensFormat format,
                     const std::vector<std::string>& remarks) {
    write_whole_text(path, lens_text(lens, format, remarks));
}

Camera read_lens_file(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".toml") return read_lens_toml(path);
    if (ending == ".txt") return read_lens_colmap(path);
    constexpr std::size_t kMaxBytes = std::size_t{1} << 20;
    if (ending == ".yaml" || ending == ".yml")
        return read_lens_yaml(read_whole_text(path, kMaxBytes), path.string());
    throw Error(ErrorKind::kBadInput, "E-LENS-FILE",
                path.string() +
                    ": a lens file ends in .toml, .txt (COLMAP's cameras.txt), .yaml "
                    "or .yml (OpenCV, Kalibr, ROS)",
                "rename the file after what it holds, or write one with lumi calibrate");
}

Camera simplest_lens(int width_px, int height_px, const Eigen::Vector2d& focal_px,
                     const Eigen::Vector2d& centre_px, const std::array<double, 8>& distortion) {
    const auto& [k1, k2, p1, p2, k3, k4, k5, k6] = distortion;
    const double fx = focal_px.x();
    const double fy = focal_px.y();
    const double cx = centre_px.x();
    const double cy = centre_px.y();
    const bool is_rational = k3 != 0 || k4 != 0 || k5 != 0 || k6 != 0;
    const bool is_round = fx == fy && p1 == 0 && p2 == 0;
    Camera lens{width_px, height_px, LensModel::kFullOpenCv, {}};
    if (is_rational) {
        lens.parameters = {fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6};
    } else if (k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0) {
        lens.model = is_round ? LensModel::kSimplePinhole : LensModel::kPinhole;
        lens.parameters = is_round ? std::vector{fx, cx, cy} : std::vector{fx, fy, cx, cy};
    } else if (is_round) {
        lens.model = k2 == 0 ? LensModel::kSimpleRadial : LensModel::kRadial;
        lens.parameters = {fx, cx, cy, k1};
        if (k2 != 0) lens.parameters.push_back(k2);
    } else {
        lens.model = LensModel::kOpenCv;
        lens.parameters = {fx, fy, cx, cy, k1, k2, p1, p2};
    }
    return lens;
}

}  // namespace lumi
