#include "calib/boards/calibration_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

constexpr double kPictureWidth = 640;
constexpr double kSide = 300;  ///< Of the two plots to the right.
constexpr double kMargin = 30;

std::string label(double x, double y, const std::string& text, const char* anchor = "start") {
    return formatted("<text x='%.1f' y='%.1f' text-anchor='%s'>", x, y, anchor) + text +
           "</text>\n";
}

std::string frame(double x, double y, double width, double height) {
    return formatted(
        "<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='#fff' stroke='#888'/>\n", x, y,
        width, height);
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
    return formatted("<line x1='%.2f' y1='%.2f' x2='%.2f' y2='%.2f' stroke='%s'/>\n", x1, y1, x2,
                     y2, color);
}

/// From blue (none) over grey to red (three times the RMS or more).
std::string color_of(double share) {
    const double t = std::clamp(share / 3, 0.0, 1.0);
    return formatted("rgb(%.0f,%.0f,%.0f)", 40 + 190 * t, 90 - 60 * t, 200 - 170 * t);
}

double enlargement(const BoardCalibration& calibration) {
    const double wanted = 0.03 * calibration.lens.width_px / std::max(calibration.rms_px, 1e-6);
    const double power = std::pow(10.0, std::floor(std::log10(std::max(1.0, wanted))));
    for (const double step : {5.0, 2.0, 1.0}) {
        if (step * power <= wanted) return step * power;
    }
    return 1.0;
}

std::string coverage_plot(const BoardCalibration& calibration, double left, double top) {
    const double scale = kPictureWidth / calibration.lens.width_px;
    const double height = scale * calibration.lens.height_px;
    const double times = enlargement(calibration);
    std::string svg = frame(left, top, kPictureWidth, height);
    for (const BoardResidual& residual : calibration.residuals) {
        const double x = left + scale * residual.px.x();
        const double y = top + scale * residual.px.y();
        const Eigen::Vector2d tip = scale * times * residual.error_px;
        const std::string color =
            color_of(residual.error_px.norm() / std::max(calibration.rms_px, 1e-9));
        svg += line(x, y, x + tip.x(), y + tip.y(), color.c_str());
        svg += formatted("<circle cx='%.1f' cy='%.1f' r='1.3' fill='%s'/>\n", x, y, color.c_str());
    }
    const Eigen::Vector2d centre = scale * principal_point_px(calibration.lens);
    svg += line(left + centre.x() - 6, top + centre.y(), left + centre.x() + 6, top + centre.y(),
                "#000");
    svg += line(left + centre.x(), top + centre.y() - 6, left + centre.x(), top + centre.y() + 6,
                "#000");
    return svg + label(left, top - 8,
                       formatted("where the board was seen; residuals enlarged %.0f times", times));
}

std::string residual_plot(const BoardCalibration& calibration, double left, double top) {
    const double reach = std::max(4 * calibration.rms_px / std::sqrt(2.0), 1e-6);
    const double scale = kSide / 2 / reach;
    const double x0 = left + kSide / 2;
    const double y0 = top + kSide / 2;
    std::string svg = frame(left, top, kSide, kSide) + line(left, y0, left + kSide, y0, "#ccc") +
                      line(x0, top, x0, top + kSide, "#ccc");
    for (const BoardResidual& residual : calibration.residuals) {
        if (residual.error_px.cwiseAbs().maxCoeff() > reach) continue;
        svg += formatted("<circle cx='%.1f' cy='%.1f' r='1.2' fill='#28c' fill-opacity='0.5'/>\n",
                         x0 + scale * residual.error_px.x(), y0 + scale * residual.error_px.y());
    }
    for (const double times : {1.0, 2.0}) {
        svg += formatted("<circle cx='%.1f' cy='%.1f' r='%.1f' fill='none' stroke='#c22'/>\n", x0,
                         y0, times * scale * calibration.rms_px / std::sqrt(2.0));
    }
    return svg + label(left, top - 8, formatted("residuals, +-%.2f px", reach));
}

std::string radial_plot(const BoardCalibration& calibration, double left, double top) {
    constexpr std::size_t kBins = 12;
    const Eigen::Vector2d centre_px = principal_point_px(calibration.lens);
    double farthest_px = 1;
    for (const BoardResidual& residual : calibration.residuals) {
        farthest_px = std::max(farthest_px, (residual.px - centre_px).norm());
    }
    const double reach = std::max(2 * calibration.rms_px, 1e-6);
    const double y0 = top + kSide / 2;
    std::array<double, kBins> sums{};
    std::array<double, kBins> counts{};
    std::string svg = frame(left, top, kSide, kSide) + line(left, y0, left + kSide, y0, "#ccc");
    for (const BoardResidual& residual : calibration.residuals) {
        const Eigen::Vector2d outwards = residual.px - centre_px;
        const double radius_px = std::max(outwards.norm(), 1e-9);
        const double along = residual.error_px.dot(outwards) / radius_px;
        const auto bin =
            std::min(kBins - 1, static_cast<std::size_t>(radius_px / farthest_px * kBins));
        sums[bin] += along;
        counts[bin] += 1;
        if (std::abs(along) > reach) continue;
        svg += formatted("<circle cx='%.1f' cy='%.1f' r='1.1' fill='#999' fill-opacity='0.5'/>\n",
                         left + kSide * radius_px / farthest_px, y0 - along / reach * kSide / 2);
    }
    std::string points;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        if (counts[bin] == 0) continue;
        points += formatted("%.1f,%.1f ", left + kSide * (static_cast<double>(bin) + 0.5) / kBins,
                            y0 - sums[bin] / counts[bin] / reach * kSide / 2);
    }
    return svg + "<polyline points='" + points +
           "' fill='none' stroke='#c22' stroke-width='2'/>\n" +
           label(left, top - 8, formatted("outward residual, +-%.2f px, against radius", reach)) +
           label(left + kSide, top + kSide + 16, formatted("%.0f px", farthest_px), "end");
}

}  // namespace

std::string calibration_svg(const BoardCalibration& calibration) {
    const double picture_height =
        kPictureWidth / calibration.lens.width_px * calibration.lens.height_px;
    const double top = 60;
    const double right = kMargin + kPictureWidth + kMargin;
    const double second_top = top + kSide + 50;
    const double width = right + kSide + kMargin;
    const double height = std::max(top + picture_height, second_top + kSide) + kMargin;
    std::string svg = formatted(
        "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f' "
        "viewBox='0 0 %.0f %.0f' font-family='sans-serif' font-size='13'>\n"
        "<rect width='100%%' height='100%%' fill='#fff'/>\n",
        width, height, width, height);
    svg += label(
        kMargin, 26,
        text_of(calibration.form) +
            formatted(": %zu photographs, %zu points, RMS %.3f px, held out ",
                      calibration.views.size(), calibration.residuals.size(), calibration.rms_px) +
            (calibration.held_out_rms_px ? formatted("%.3f px", *calibration.held_out_rms_px)
                                         : "not predicted"));
    svg += coverage_plot(calibration, kMargin, top);
    svg += residual_plot(calibration, right, top);
    svg += radial_plot(calibration, right, second_top);
    return svg + "</svg>\n";
}

}  // namespace lumi
