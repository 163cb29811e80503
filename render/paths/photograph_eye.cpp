#include "render/paths/photograph_eye.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <filesystem>
#include <numbers>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

/// Quarter turns clockwise that make a picture of each EXIF orientation upright (EXIF 2.3, tag
/// 0x0112); mirrored ones without their mirror.
int quarter_turns(int exif_orientation) {
    constexpr std::array<int, 9> kTurns{0, 0, 0, 2, 2, 3, 1, 1, 3};
    return kTurns[static_cast<std::size_t>(std::clamp(exif_orientation, 0, 8))];
}

/// The old left edge becomes the top one: pixel (x, y) moves to (height - y, x).
Eye turned_clockwise(const Eye& eye) {
    const Eigen::Vector2d focal = focal_length_px(eye.camera);
    const Eigen::Vector2d centre = principal_point_px(eye.camera);
    const Eigen::AngleAxisd turn(std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
    Eye result;
    result.camera = {eye.camera.height_px,
                     eye.camera.width_px,
                     LensModel::kPinhole,
                     {focal.y(), focal.x(), eye.camera.height_px - centre.y(), centre.x()}};
    result.cam_from_world =
        Rigid3{Eigen::Quaterniond(turn), Eigen::Vector3d::Zero()} * eye.cam_from_world;
    return result;
}

template <class Pixel>
Image<Pixel> turned_clockwise(const Image<Pixel>& picture) {
    Image<Pixel> turned(picture.height(), picture.width());
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            turned(picture.height() - 1 - y, x) = picture(x, y);
    return turned;
}

template <class Turned>
Turned turned_clockwise(Turned turned, int turns) {
    for (int turn = 0; turn < turns; ++turn) turned = turned_clockwise(turned);
    return turned;
}

Eigen::Vector3d mean_up_in_world(const Lumigraph& lumigraph) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    for (const LumigraphView& view : lumigraph.views) {
        const Eigen::Quaterniond world_from_cam = eye_at(view).cam_from_world.rotation.conjugate();
        const Eigen::Vector3d up = world_from_cam * -Eigen::Vector3d::UnitY();
        if (first.isZero()) first = up;
        sum += up;
    }
    // Cameras that look down from all around have no common up: then the first one's serves.
    constexpr double kSmallestAgreement = 0.05;
    const bool agree =
        sum.norm() > kSmallestAgreement * static_cast<double>(lumigraph.views.size());
    return (agree ? sum : first).normalized();
}

/// Of the upright cameras' x axes r: the mean of r r^T. u^T M u is then the mean square of the
/// sines by which they rise above a floor that u is perpendicular to.
Eigen::Matrix3d mean_square_of_rights(const Lumigraph& lumigraph) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const LumigraphView& view : lumigraph.views) {
        const Eigen::Vector3d right =
            eye_at(view).cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitX();
        sum += right * right.transpose();
    }
    return sum / static_cast<double>(lumigraph.views.size());
}

}  // namespace

Eye turned_upright(const Eye& eye, int exif_orientation) {
    return turned_clockwise(eye, quarter_turns(exif_orientation));
}

ColorImage turned_upright(const ColorImage& picture, int exif_orientation) {
    return turned_clockwise(picture, quarter_turns(exif_orientation));
}

GrayImage turned_upright(const GrayImage& picture, int exif_orientation) {
    return turned_clockwise(picture, quarter_turns(exif_orientation));
}

Eye eye_at(const LumigraphView& view) {
    return turned_upright({view.camera, view.cam_from_world}, view.exif_orientation);
}

double fitting_scale(const Eye& eye, int width_px, int height_px) {
    return std::min(static_cast<double>(width_px) / eye.camera.width_px,
                    static_cast<double>(height_px) / eye.camera.height_px);
}

Eye fitted_to(const Eye& eye, int width_px, int height_px) {
    const Eigen::Vector2d old_middle(0.5 * eye.camera.width_px, 0.5 * eye.camera.height_px);
    const Eigen::Vector2d middle(0.5 * width_px, 0.5 * height_px);
    const double scale = fitting_scale(eye, width_px, height_px);
    const Eigen::Vector2d focal = scale * focal_length_px(eye.camera);
    const Eigen::Vector2d centre = middle + scale * (principal_point_px(eye.camera) - old_middle);
    return {
        {width_px, height_px, LensModel::kPinhole, {focal.x(), focal.y(), centre.x(), centre.y()}},
        eye.cam_from_world};
}

std::optional<int> index_of_name(const std::vector<std::string>& names, const std::string& wanted) {
    std::vector<int> by_stem;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == wanted) return static_cast<int>(i);
        if (std::filesystem::path(names[i]).stem() == wanted)
            by_stem.push_back(static_cast<int>(i));
    }
    if (by_stem.size() != 1) return std::nullopt;
    return by_stem.front();
}

std::string listed_names(const std::vector<std::string>& names) {
    constexpr std::size_t kMaxListed = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMaxListed, names.size()); ++i)
        text += (i == 0 ? "" : ", ") + printable(names[i]);
    return names.size() > kMaxListed ? text + ", ..." : text;
}

std::vector<std::string> names_of_views(const Lumigraph& lumigraph) {
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    return names;
}

int index_of_view(const Lumigraph& lumigraph, const std::string& name) {
    const std::vector<std::string> names = names_of_views(lumigraph);
    if (const std::optional<int> index = index_of_name(names, name)) return *index;
    throw Error(ErrorKind::kUsage, "E-VIEW-NAME",
                "expected the name of one photograph, found '" + printable(name) + "'",
                "this package has: " + listed_names(names));
}

Eigen::Vector3d up_in_world(const Lumigraph& lumigraph) {
    // Hands hold cameras, and poses are known, no more level than this.
    constexpr double kLeastMeanSquareRoll = 0.0015;
    constexpr double kWeightOfMean = 2.0;
    constexpr int kRounds = 20;
    const Eigen::Vector3d mean = mean_up_in_world(lumigraph);
    const Eigen::Matrix3d rights = mean_square_of_rights(lumigraph);
    Eigen::Vector3d up = mean;
    for (int round = 0; round < kRounds; ++round) {
        const double mean_square_roll = std::max(kLeastMeanSquareRoll, up.dot(rights * up));
        const Eigen::Matrix3d pulled =
            rights + kWeightOfMean * mean_square_roll * Eigen::Matrix3d::Identity();
        up = pulled.ldlt().solve(mean).normalized();
    }
    return up;
}

}  // namespace lumi
