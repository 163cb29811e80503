#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "calib/boards/board_views.h"

namespace lumi {

/// Heights of a bent board over the plane that touches it in its middle, away from the camera:
/// a u^2 + b u v + c v^2 at the place (u, v) from its middle, all in pitches. A board that is bent
/// by a hundredth of its width is that to a ten-thousandth. Constant and linear terms would be
/// part of the pose.
using BoardBow = std::array<double, 3>;

inline constexpr BoardBow kNotBent{0.0, 0.0, 0.0};

/// Where a photograph counts the middle of the board, and how far it counts turned against the
/// others (see BoardView).
struct BoardFrame {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double cosine = 1.0;
    double sine = 0.0;
};
[[nodiscard]] BoardFrame frame_of(const BoardView& view);

/// A place on the print, on the bent board. Paper bends and does not stretch: places keep their
/// distance from the middle along the sheet (the exponential map of the surface, to second order
/// in its slope; exact to third order for a rolled sheet). Without that a board that is bent by a
/// fiftieth of its width would look shorter by a fifth of a pixel.
template <class T>
Eigen::Matrix<T, 3, 1> on_bent_board(const T& x, const T& y, const BoardFrame& frame,
                                     const T* bow) {
    const T from_x = x - frame.middle.x();
    const T from_y = y - frame.middle.y();
    const T u = frame.cosine * from_x + frame.sine * from_y;
    const T v = frame.cosine * from_y - frame.sine * from_x;
    const T height = bow[0] * u * u + bow[1] * u * v + bow[2] * v * v;
    const T inwards_u = height * (2.0 * bow[0] * u + bow[1] * v) / 3.0;
    const T inwards_v = height * (bow[1] * u + 2.0 * bow[2] * v) / 3.0;
    return {x - (frame.cosine * inwards_u - frame.sine * inwards_v),
            y - (frame.sine * inwards_u + frame.cosine * inwards_v), height};
}

/// The bow as seen from counting that is turned by an angle: three by three.
[[nodiscard]] Eigen::Matrix3d bow_turned_by(double turn_rad);

/// How far a board is bent.
struct BoardBend {
    BoardBow per_pitch{};  ///< See BoardBow.
    /// Between its highest and its lowest place, to the longer side of what was seen of it.
    double share_of_width = 0.0;
    double sigma_share = 0.0;  ///< One standard deviation of that.
    double depth_pitches = 0.0;
    double width_pitches = 0.0;
};
/// "the board is bent by 0.47 +- 0.06 % of its width, which the fit allows for".
[[nodiscard]] std::string text_of(const BoardBend& bend);
/// From the covariance of the bow, over the largest part of the board in one photograph.
[[nodiscard]] BoardBend bend_of(const BoardViews& board, double size_per_pitch, const BoardBow& bow,
                                const Eigen::Matrix3d& covariance);

}  // namespace lumi
