#include "calib/boards/marker_codes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/aruco/dictionary.hpp>
#include <optional>
#include <set>

namespace lumi {
namespace {

struct FamilyEntry {
    const char* name;
    cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
};
/// Shorter dictionaries of ArUco are the beginnings of the longest.
constexpr std::array<FamilyEntry, 9> kFamilies{{{"36h11", cv::aruco::DICT_APRILTAG_36h11},
                                                {"36h10", cv::aruco::DICT_APRILTAG_36h10},
                                                {"25h9", cv::aruco::DICT_APRILTAG_25h9},
                                                {"16h5", cv::aruco::DICT_APRILTAG_16h5},
                                                {"aruco", cv::aruco::DICT_ARUCO_ORIGINAL},
                                                {"7x7", cv::aruco::DICT_7X7_1000},
                                                {"6x6", cv::aruco::DICT_6X6_1000},
                                                {"5x5", cv::aruco::DICT_5X5_1000},
                                                {"4x4", cv::aruco::DICT_4X4_1000}}};
constexpr int kMaxBorderBits = 2;

/// From the unit square to a quad (Heckbert 1989).
Eigen::Matrix3d quad_from_square(const DarkQuad& quad) {
    const auto& c = quad.corners_px;
    const Eigen::Vector2d sum = c[0] - c[1] + c[2] - c[3];
    Eigen::Matrix2d edges;
    edges << c[1] - c[2], c[3] - c[2];
    const Eigen::Vector2d perspective = edges.inverse() * sum;
    Eigen::Matrix3d homography;
    homography << c[1] - c[0] + perspective.x() * c[1], c[3] - c[0] + perspective.y() * c[3], c[0],
        perspective.x(), perspective.y(), 1;
    return homography;
}

/// Mean grey values of the cells of a marker, row by row; empty when it leaves the picture.
std::vector<double> cell_values(const GrayImage& picture, const DarkQuad& quad, int cells) {
    const Eigen::Matrix3d homography = quad_from_square(quad);
    std::vector<double> values;
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            double sum = 0;
            for (const double v : {0.3, 0.5, 0.7}) {
                for (const double u : {0.3, 0.5, 0.7}) {
                    const Eigen::Vector2d px =
                        (homography * Eigen::Vector3d((column + u) / cells, (row + v) / cells, 1))
                            .hnormalized();
                    if (!px.allFinite()) return {};
                    const int x = static_cast<int>(std::floor(px.x()));
                    const int y = static_cast<int>(std::floor(px.y()));
                    if (!picture.contains(x, y)) return {};
                    sum += picture(x, y);
                }
            }
            values.push_back(sum / 9);
        }
    }
    return values;
}

/// The code within the frame, 1 for bright; empty when there is no dark frame.
cv::Mat bits_of(const std::vector<double>& values, int cells, int border_bits) {
    const auto [darkest, brightest] = std::minmax_element(values.begin(), values.end());
    constexpr double kLeastContrast = 15;
    if (*brightest - *darkest < kLeastContrast) return {};
    const double middle = 0.5 * (*darkest + *brightest);
    cv::Mat bits(cells - 2 * border_bits, cells - 2 * border_bits, CV_8UC1);
    int bright_frame = 0;
    int frame = 0;
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            const bool is_bright = values[static_cast<std::size_t>(row * cells + column)] > middle;
            const bool is_frame =
                std::min(std::min(row, column), std::min(cells - 1 - row, cells - 1 - column)) <
                border_bits;
            if (is_frame) {
                ++frame;
                bright_frame += is_bright ? 1 : 0;
            } else {
                bits.at<std::uint8_t>(row - border_bits, column - border_bits) = is_bright ? 1 : 0;
            }
        }
    }
    constexpr double kMaxBrightShare = 0.08;
    if (bright_frame > kMaxBrightShare * frame) return {};
    return bits;
}

/// The quads read once for each number of cells.
class CellReader {
 public:
    CellReader(const GrayImage& picture, const std::vector<DarkQuad>& quads)
        : picture_(picture), quads_(quads) {}

    const std::vector<std::vector<double>>& values(int cells) {
        auto& values = values_[cells];
        if (values.empty()) {
            for (const DarkQuad& quad : quads_) {
                // A cell narrower than a pixel tells nothing.
                values.push_back(quad.side_px >= cells ? cell_values(picture_, quad, cells)
                                                       : std::vector<double>{});
            }
        }
        return values;
    }

 private:
    const GrayImage& picture_;
    const std::vector<DarkQuad>& quads_;
    std::map<int, std::vector<std::vector<double>>> values_;
};

MarkerFamily read_as(CellReader& reader, const FamilyEntry& entry, int border_bits) {
    const auto dictionary = cv::aruco::getPredefinedDictionary(entry.dictionary);
    const int cells = dictionary->markerSize + 2 * border_bits;
    MarkerFamily family{entry.name, border_bits, {}};
    const auto& values = reader.values(cells);
    for (std::size_t quad = 0; quad < values.size(); ++quad) {
        if (values[quad].empty()) continue;
        const cv::Mat bits = bits_of(values[quad], cells, border_bits);
        if (bits.empty()) continue;
        int id = -1;
        int rotation = 0;
        constexpr double kCorrectedShare = 0.5;
        if (!dictionary->identify(bits, id, rotation, kCorrectedShare)) continue;
        family.markers.push_back({quad, id, static_cast<std::size_t>((4 - rotation) % 4)});
    }
    return family;
}

bool is_chance(const MarkerFamily& family) {
    constexpr std::size_t kLeastMarkers = 3;
    std::set<int> ids;
    for (const MarkerReading& marker : family.markers) ids.insert(marker.id);
    return ids.size() < kLeastMarkers;
}

}  // namespace

MarkerFamily read_markers(const GrayImage& picture, const std::vector<DarkQuad>& quads) {
    CellReader reader(picture, quads);
    MarkerFamily best;
    for (int border_bits = 1; border_bits <= kMaxBorderBits; ++border_bits) {
        for (const FamilyEntry& entry : kFamilies) {
            MarkerFamily family = read_as(reader, entry, border_bits);
            if (family.markers.size() > best.markers.size() && !is_chance(family)) {
                best = std::move(family);
            }
        }
    }
    return best;
}

}  // namespace lumi
