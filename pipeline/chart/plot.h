#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/evaluate/bootstrap.h"

namespace lumi {

/// A point of a plot.
struct PlotMark {
    double x = 0.0;
    double y = 0.0;
    std::optional<Interval> x_range = {};  ///< Error bars.
    std::optional<Interval> y_range = {};
    std::string label = {};  ///< Written beside it; empty: none.
    bool is_faint = false;   ///< Grey: something else is better.
};

struct PlotSeries {
    std::string name = {};  ///< In the key; empty: not named there.
    std::vector<PlotMark> marks = {};
    bool is_joined = false;   ///< By straight lines.
    bool is_curve = false;    ///< By straight lines, without marks.
    bool is_stepped = false;  ///< By steps, as a front is; without marks.
};

/// A dashed line across the plot at `x`, in the colour of a series.
struct PlotLine {
    double x = 0.0;
    std::size_t series = 0;
};

/// What is drawn: marks over two axes. An axis that is not logarithmic begins at 0 unless something
/// lies below.
struct Plot {
    std::string title;
    std::string x_label;
    std::string y_label;
    bool has_log_x = false;
    bool has_log_y = false;
    std::vector<PlotSeries> series = {};
    std::vector<PlotLine> vertical_lines = {};  ///< Such as breaking points.
    /// Where the first axis is labelled: it runs from the first to the last of these, which may be
    /// the smallest. Empty: round numbers, from small to large.
    std::vector<double> x_ticks = {};
};

/// Draws a plot as SVG with gnuplot. Series without marks, and marks that are not finite or that a
/// logarithm does not know, are left out. Throws what gnuplot_svg throws, and Error (E-CHART-EMPTY:
/// nothing is left to draw).
[[nodiscard]] std::string plot_svg(const Plot& plot, const Progress& progress);

}  // namespace lumi
