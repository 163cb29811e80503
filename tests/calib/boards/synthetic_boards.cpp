#include "tests/calib/boards/synthetic_boards.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "calib/boards/board_pose.h"
#include "calib/capture/degrees.h"
#include "calib/opencv/opencv_picture.h"

namespace lumi {
namespace {

Eigen::Matrix3d rotation_of(const BoardPose& pose) {
    const Eigen::Map<const Eigen::Vector3d> vector(pose.data());
    const double angle = vector.norm();
    if (angle == 0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

BoardPose pose_from(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
    const Eigen::AngleAxisd turn(rotation);
    const Eigen::Vector3d vector = turn.angle() * turn.axis();
    return {vector.x(), vector.y(), vector.z(), translation.x(), translation.y(), translation.z()};
}

/// Direction of a pixel, by Newton's method for perspective and directly for a fisheye.
Eigen::Vector3d ray_of(const Camera& lens, const Eigen::Vector2d& px) {
    if (lens.model != LensModel::kOpenCvFisheye) return unproject(lens, px);
    const Eigen::Vector2d offset =
        (px - principal_point_px(lens)).cwiseQuotient(focal_length_px(lens));
    const double bent = offset.norm();
    if (bent < 1e-9) return Eigen::Vector3d::UnitZ();
    double theta = bent;
    for (int step = 0; step < 20; ++step) {
        const double t2 = theta * theta;
        const double* k = lens.parameters.data() + 4;
        const double value = theta * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
        const double slope =
            1 + t2 * (3 * k[0] + t2 * (5 * k[1] + t2 * (7 * k[2] + t2 * 9 * k[3])));
        theta -= (value - bent) / slope;
    }
    const Eigen::Vector2d sideways = offset / bent * std::sin(theta);
    return {sideways.x(), sideways.y(), std::cos(theta)};
}

/// Unit directions of the corners of all pixels, row by row; found once for photographs by one lens
/// one after another.
const std::vector<Eigen::Vector3d>& rays_of_corners(const Camera& lens) {
    static Camera last;
    static std::vector<Eigen::Vector3d> rays;
    if (!rays.empty() && last == lens) return rays;
    last = lens;
    rays.clear();
    for (int y = 0; y <= lens.height_px; ++y) {
        for (int x = 0; x <= lens.width_px; ++x) {
            rays.push_back(ray_of(lens, {x, y}).normalized());
        }
    }
    return rays;
}

/// Mean of what `brightness_at` says of places (u, v) within a pixel, on a grid. Where the
/// outermost places see the same, so do those between them: what is printed is larger than a pixel.
template <class BrightnessAt>
double mean_over_pixel(const BrightnessAt& brightness_at) {
    constexpr int kSamples = 4;
    constexpr double kFirst = 0.5 / kSamples;
    const double corner = brightness_at(kFirst, kFirst);
    if (corner == brightness_at(1 - kFirst, kFirst) &&
        corner == brightness_at(kFirst, 1 - kFirst) &&
        corner == brightness_at(1 - kFirst, 1 - kFirst)) {
        return corner;
    }
    double sum = 0;
    for (int sample = 0; sample < kSamples * kSamples; ++sample) {
        sum += brightness_at((sample % kSamples + 0.5) / kSamples,
                             (sample / kSamples + 0.5) / kSamples);
    }
    return sum / (kSamples * kSamples);
}

}  // namespace

std::vector<BoardPose> hand_held_poses(const Camera& lens, int columns, int rows, int count,
                                       double max_tilt_deg, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Eigen::Vector3d middle(0.5 * (columns - 1), 0.5 * (rows - 1), 0);
    const double extent = std::max(columns, rows);
    std::vector<BoardPose> poses;
    for (int index = 0; index < count; ++index) {
        const double around = 2 * std::numbers::pi * index / count + 0.3 * uniform(random);
        const double tilt =
            max_tilt_deg * (0.4 + 0.6 * std::abs(uniform(random))) * kRadiansPerDegree;
        const Eigen::Vector3d tilt_axis(std::cos(around), std::sin(around), 0);
        const Eigen::Matrix3d rotation =
            (Eigen::AngleAxisd(tilt, tilt_axis) *
             Eigen::AngleAxisd(0.6 * uniform(random), Eigen::Vector3d::UnitZ()))
                .toRotationMatrix();
        const double focal_per_width = focal_length_px(lens).x() / lens.width_px;
        const double depth = extent * focal_per_width * (1.6 + 0.4 * uniform(random));
        const Eigen::Vector3d place(0.25 * uniform(random) * depth / focal_per_width,
                                    0.18 * uniform(random) * depth / focal_per_width, depth);
        poses.push_back(pose_from(rotation, place - rotation * middle));
    }
    return poses;
}

Eigen::Vector2d seen_at(const Camera& lens, const BoardPose& cam_from_board,
                        const Eigen::Vector2d& place) {
    BoardView view;
    view.points.push_back({place, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
    return predicted_px(view, lens, 0.0, cam_from_board).front();
}

Eigen::Vector2d seen_off_plane(const Camera& lens, const BoardPose& cam_from_board,
                               const Eigen::Vector3d& place) {
    BoardPose moved = cam_from_board;
    Eigen::Map<Eigen::Vector3d>(moved.data() + 3) += place.z() * rotation_of(cam_from_board).col(2);
    return seen_at(lens, moved, place.head<2>());
}

BentSheet rolled_sheet(const Eigen::Vector2d& middle, const Eigen::Vector2d& across,
                       double radius) {
    return [=](const Eigen::Vector2d& place) -> Eigen::Vector3d {
        const double along = across.dot(place - middle);
        const Eigen::Vector2d rolled = place + (radius * std::sin(along / radius) - along) * across;
        return {rolled.x(), rolled.y(), radius * (1 - std::cos(along / radius))};
    };
}

BoardViews seen_chessboards(const Camera& lens, int columns, int rows,
                            const std::vector<BoardPose>& poses, double noise_px,
                            std::uint32_t seed, const BentSheet& sheet) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    BoardViews board;
    board.width_px = lens.width_px;
    board.height_px = lens.height_px;
    for (const BoardPose& pose : poses) {
        BoardView view;
        view.photograph = "photograph " + std::to_string(board.views.size());
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const Eigen::Vector2d place(column, row);
                const Eigen::Vector2d px =
                    sheet ? seen_off_plane(lens, pose, sheet(place)) : seen_at(lens, pose, place);
                if (!px.allFinite() || !is_inside(lens, px)) continue;
                view.points.push_back(
                    {place, Eigen::Vector2d::Zero(),
                     px + noise_px * Eigen::Vector2d(normal(random), normal(random))});
            }
        }
        board.views.push_back(std::move(view));
    }
    return board;
}

BoardPrint printed_chessboard(int columns, int rows) {
    return [=](const Eigen::Vector2d& place) {
        const int column = static_cast<int>(std::floor(place.x())) + 1;
        const int row = static_cast<int>(std::floor(place.y())) + 1;
        const bool is_on_board = column >= 0 && row >= 0 && column <= columns && row <= rows;
        return is_on_board && (column + row) % 2 == 0 ? 0.1 : 0.9;
    };
}

BoardPrint printed_squares(int columns, int rows, double size) {
    return [=](const Eigen::Vector2d& place) {
        const Eigen::Vector2d nearest = place.array().round();
        const bool is_on_board =
            nearest.x() >= 0 && nearest.y() >= 0 && nearest.x() < columns && nearest.y() < rows;
        return is_on_board && (place - nearest).cwiseAbs().maxCoeff() <= size / 2 ? 0.1 : 0.9;
    };
}

BoardPrint printed_discs(std::vector<Eigen::Vector2d> centres, double diameter) {
    return [centres = std::move(centres), diameter](const Eigen::Vector2d& place) {
        const bool is_in_disc =
            std::any_of(centres.begin(), centres.end(), [&](const Eigen::Vector2d& centre) {
                return (place - centre).squaredNorm() <= diameter * diameter / 4;
            });
        return is_in_disc ? 0.1 : 0.9;
    };
}

GrayImage photograph_of(const BoardPrint& print, const Camera& lens,
                        const BoardPose& cam_from_board, const PhotographFaults& faults) {
    const Eigen::Matrix3d board_from_cam = rotation_of(cam_from_board).transpose();
    const Eigen::Vector3d centre =
        -(board_from_cam * Eigen::Map<const Eigen::Vector3d>(cam_from_board.data() + 3));
    cv::Mat brightness(lens.height_px, lens.width_px, CV_32FC1);
    std::vector<Eigen::Vector3d> rays = rays_of_corners(lens);
    for (Eigen::Vector3d& ray : rays) ray = board_from_cam * ray;
    const auto per_row = static_cast<std::size_t>(lens.width_px) + 1;
    for (int y = 0; y < lens.height_px; ++y) {
        const Eigen::Vector3d* above = rays.data() + static_cast<std::size_t>(y) * per_row;
        const Eigen::Vector3d* below = above + per_row;
        for (int x = 0; x < lens.width_px; ++x, ++above, ++below) {
            brightness.at<float>(y, x) =
                static_cast<float>(mean_over_pixel([&](double u, double v) {
                    const Eigen::Vector3d ray = (1 - v) * ((1 - u) * above[0] + u * above[1]) +
                                                v * ((1 - u) * below[0] + u * below[1]);
                    const double distance = -centre.z() / ray.z();
                    // Beside the board stands a grey wall.
                    return distance > 0 ? print((centre + distance * ray).head<2>()) : 0.5;
                }));
        }
    }
    if (faults.blur_px > 0) cv::GaussianBlur(brightness, brightness, {}, faults.blur_px);
    std::mt19937 random(faults.seed);
    std::normal_distribution<double> normal(0.0, faults.noise);
    GrayImage picture(lens.width_px, lens.height_px);
    const Eigen::Vector2d spot(0.45 * lens.width_px, 0.4 * lens.height_px);
    for (int y = 0; y < lens.height_px; ++y) {
        for (int x = 0; x < lens.width_px; ++x) {
            double value = 255 * static_cast<double>(brightness.at<float>(y, x));
            if (faults.has_glare) {
                const double distance = (Eigen::Vector2d(x, y) - spot).norm() / lens.width_px;
                value += 500 * std::exp(-distance * distance / (2 * 0.04 * 0.04));
            }
            picture(x, y) = static_cast<std::uint8_t>(
                std::clamp(std::lround(value + normal(random)), 0L, 255L));
        }
    }
    return picture;
}

}  // namespace lumi
