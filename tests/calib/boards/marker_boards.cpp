#include "tests/calib/boards/marker_boards.h"

#include <cmath>
#include <map>
#include <opencv2/aruco/dictionary.hpp>

namespace lumi {
namespace {

constexpr double kDark = 0.1;
constexpr double kBright = 0.9;

/// A marker with its frame, 1 for bright.
cv::Mat cells_of(cv::aruco::PREDEFINED_DICTIONARY_NAME name, int id, int border_bits) {
    const auto dictionary = cv::aruco::getPredefinedDictionary(name);
    const int bits = dictionary->markerSize;
    const cv::Mat inner =
        cv::aruco::Dictionary::getBitsFromByteList(dictionary->bytesList.row(id), bits);
    cv::Mat cells = cv::Mat::zeros(bits + 2 * border_bits, bits + 2 * border_bits, CV_8UC1);
    inner.copyTo(cells(cv::Rect(border_bits, border_bits, bits, bits)));
    return cells;
}

/// Brightness at a place within a marker, (0, 0) to (1, 1).
double brightness_in(const cv::Mat& cells, const Eigen::Vector2d& at) {
    const int column = std::min(cells.cols - 1, static_cast<int>(at.x() * cells.cols));
    const int row = std::min(cells.rows - 1, static_cast<int>(at.y() * cells.rows));
    return cells.at<std::uint8_t>(row, column) != 0 ? kBright : kDark;
}

}  // namespace

BoardPrint printed_charuco(int columns, int rows, double marker_size, bool is_first_cell_bright) {
    std::map<std::pair<int, int>, cv::Mat> markers;
    int id = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const bool is_bright = ((column + row) % 2 == 0) == is_first_cell_bright;
            if (is_bright) markers[{column, row}] = cells_of(cv::aruco::DICT_4X4_250, id++, 1);
        }
    }
    return [=](const Eigen::Vector2d& place) {
        const Eigen::Vector2d at = place + Eigen::Vector2d::Ones();
        const std::pair<int, int> cell{static_cast<int>(std::floor(at.x())),
                                       static_cast<int>(std::floor(at.y()))};
        if (cell.first < 0 || cell.second < 0 || cell.first >= columns || cell.second >= rows) {
            return kBright;
        }
        const auto marker = markers.find(cell);
        if (marker == markers.end()) return kDark;
        const Eigen::Vector2d within =
            (at - Eigen::Vector2d(cell.first + 0.5, cell.second + 0.5)) / marker_size +
            Eigen::Vector2d(0.5, 0.5);
        const bool is_marker = within.minCoeff() >= 0 && within.maxCoeff() < 1;
        return is_marker ? brightness_in(marker->second, within) : kBright;
    };
}

BoardPrint printed_aprilgrid(int columns, int rows, double size, int border_bits,
                             bool has_corner_squares) {
    std::map<std::pair<int, int>, cv::Mat> markers;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            markers[{column, row}] = cells_of(cv::aruco::DICT_APRILTAG_36h11,
                                              (rows - 1 - row) * columns + column, border_bits);
        }
    }
    return [=](const Eigen::Vector2d& place) {
        const Eigen::Vector2d nearest = place.array().round();
        const Eigen::Vector2d within = (place - nearest) / size + Eigen::Vector2d(0.5, 0.5);
        const auto marker =
            markers.find({static_cast<int>(nearest.x()), static_cast<int>(nearest.y())});
        if (marker != markers.end() && within.minCoeff() >= 0 && within.maxCoeff() < 1) {
            return brightness_in(marker->second, within);
        }
        const Eigen::Vector2d crossing = (place.array() - 0.5).round() + 0.5;
        const bool is_between = crossing.x() > -1 && crossing.y() > -1 && crossing.x() < columns &&
                                crossing.y() < rows &&
                                (place - crossing).cwiseAbs().maxCoeff() <= (1 - size) / 2;
        return has_corner_squares && is_between ? kDark : kBright;
    };
}

}  // namespace lumi
