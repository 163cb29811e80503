#include "calib/boards/board_bow.h"

#include <algorithm>
#include <cmath>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

Eigen::Vector3d monomials(const Eigen::Vector2d& place) {
    return {place.x() * place.x(), place.x() * place.y(), place.y() * place.y()};
}

}  // namespace

BoardFrame frame_of(const BoardView& view) {
    return {view.middle, std::cos(view.turn_rad), std::sin(view.turn_rad)};
}

Eigen::Matrix3d bow_turned_by(double turn_rad) {
    // Of a form with u = cosine * x + sine * y and v = cosine * y - sine * x, in x and y.
    const double c = std::cos(turn_rad);
    const double s = std::sin(turn_rad);
    Eigen::Matrix3d turned;
    turned << c * c, -c * s, s * s,            //
        2 * c * s, c * c - s * s, -2 * c * s,  //
        s * s, c * s, c * c;
    return turned;
}

BoardBend bend_of(const BoardViews& board, double size_per_pitch, const BoardBow& bow,
                  const Eigen::Matrix3d& covariance) {
    const auto largest = std::max_element(
        board.views.begin(), board.views.end(),
        [](const BoardView& a, const BoardView& b) { return a.points.size() < b.points.size(); });
    const Eigen::Map<const Eigen::Vector3d> form(bow.data());
    const BoardFrame frame = frame_of(*largest);
    Eigen::Vector3d highest = Eigen::Vector3d::Zero();
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();
    Eigen::Vector2d least = Eigen::Vector2d::Zero();
    Eigen::Vector2d most = Eigen::Vector2d::Zero();
    for (const BoardPoint& point : largest->points) {
        const Eigen::Vector2d from = point.place + size_per_pitch * point.along_size - frame.middle;
        const Eigen::Vector2d place(frame.cosine * from.x() + frame.sine * from.y(),
                                    frame.cosine * from.y() - frame.sine * from.x());
        const Eigen::Vector3d terms = monomials(place);
        if (form.dot(terms) > form.dot(highest)) highest = terms;
        if (form.dot(terms) < form.dot(lowest)) lowest = terms;
        least = least.cwiseMin(place);
        most = most.cwiseMax(place);
    }
    const Eigen::Vector3d depth = highest - lowest;
    BoardBend bend;
    bend.per_pitch = bow;
    bend.width_pitches = (most - least).maxCoeff();
    bend.depth_pitches = form.dot(depth);
    bend.share_of_width = bend.depth_pitches / bend.width_pitches;
    bend.sigma_share = std::sqrt(depth.dot(covariance * depth)) / bend.width_pitches;
    return bend;
}

std::string text_of(const BoardBend& bend) {
    return "the board is bent by " +
           formatted("%.2f +- %.2f", 100 * bend.share_of_width, 100 * bend.sigma_share) +
           " % of its width, which the fit allows for";
}

}  // namespace lumi
