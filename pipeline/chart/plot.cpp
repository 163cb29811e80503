#include "pipeline/chart/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/work/error.h"
#include "pipeline/chart/gnuplot.h"
#include "pipeline/chart/label_choice.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

/// Colours that colour-blind eyes tell apart (Okabe and Ito, 2008), grey apart.
constexpr std::array<const char*, 7> kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000"};
constexpr std::array<int, 7> kPointTypes{7, 5, 9, 13, 11, 6, 4};
constexpr const char* kGrey = "#b0b0b0";

bool is_drawable(const Plot& plot, const PlotMark& mark) {
    return std::isfinite(mark.x) && std::isfinite(mark.y) && (!plot.has_log_x || mark.x > 0.0) &&
           (!plot.has_log_y || mark.y > 0.0);
}

/// The script's data and the commands that draw them.
class PlotScript {
 public:
    explicit PlotScript(const Plot& plot) : plot_(plot) {
        for (std::size_t i = 0; i < plot.series.size(); ++i) add_series(i);
    }

    [[nodiscard]] bool is_empty() const { return drawn_.empty(); }

    [[nodiscard]] std::string text() const {
        std::string script =
            "set title " + gnuplot_quoted(plot_.title) + "\nset xlabel " +
            gnuplot_quoted(plot_.x_label) + "\nset ylabel " + gnuplot_quoted(plot_.y_label) +
            "\nset rmargin 12\nset grid lc rgb '#e4e4e4' lt 1 lw 1\nset border 3 lc rgb '#808080'\n"
            "set tics nomirror\nset key outside top center horizontal maxrows 3\n"
            "set bars small\n";
        script += axis('x', plot_.has_log_x, least_.x) + axis('y', plot_.has_log_y, least_.y);
        script += ticks();
        for (const PlotLine& line : plot_.vertical_lines) {
            script += "set arrow from first " + shortest_number_text(line.x) +
                      ", graph 0 to first " + shortest_number_text(line.x) +
                      ", graph 1 nohead dt 2 lw 1.5 lc rgb '" +
                      kColors[line.series % kColors.size()] + "'\n";
        }
        return script + labels() + data_ + "plot " + drawn_ + "\n";
    }

 private:
    static std::string axis(char name, bool is_logarithmic, double least) {
        const std::string axis_name(1, name);
        if (is_logarithmic) return "set logscale " + axis_name + "\n";
        return least >= 0.0 ? "set " + axis_name + "range [0:*]\n" : "";
    }

    [[nodiscard]] std::string ticks() const {
        if (plot_.x_ticks.empty()) return "";
        std::string places;
        for (const double x : plot_.x_ticks)
            places += (places.empty() ? "" : ", ") + shortest_number_text(x);
        return "set xtics (" + places + ")\nset xrange [" +
               shortest_number_text(plot_.x_ticks.front()) + ":" +
               shortest_number_text(plot_.x_ticks.back()) + "]\n";
    }

    void add_series(std::size_t index) {
        const PlotSeries& series = plot_.series[index];
        std::vector<const PlotMark*> strong;
        std::vector<const PlotMark*> faint;
        std::vector<const PlotMark*> all;
        for (const PlotMark& mark : series.marks) {
            if (!is_drawable(plot_, mark)) continue;
            (mark.is_faint ? faint : strong).push_back(&mark);
            all.push_back(&mark);
            least_.x = std::min(least_.x, mark.x);
            least_.y = std::min(least_.y, mark.y);
            if (!mark.label.empty()) labelled_.push_back(&mark);
        }
        if (all.empty()) return;
        const std::string color = kColors[index % kColors.size()];
        const std::string type = std::to_string(kPointTypes[index % kPointTypes.size()]);
        if (series.is_stepped) {
            draw(all, "using 1:2 with steps lw 2 lc rgb '#808080'", series.name);
            return;
        }
        if (series.is_curve) {
            draw(all, "using 1:2 with lines lw 1 lc rgb '" + color + "'", series.name);
            return;
        }
        if (series.is_joined) draw(all, "using 1:2 with lines lw 2 lc rgb '" + color + "'", "");
        const std::string points = "using 1:2:3:4:5:6 with xyerrorbars ps 0.9 pt " + type;
        if (!faint.empty()) {
            draw(faint, points + " lc rgb '" + kGrey + "'", strong.empty() ? series.name : "");
        }
        if (!strong.empty()) draw(strong, points + " lc rgb '" + color + "'", series.name);
    }

    /// Those labels that can be read.
    [[nodiscard]] std::string labels() const {
        std::vector<PlacedLabel> placed;
        for (const PlotMark* mark : labelled_) {
            placed.push_back({share_along(mark->x, plot_.has_log_x, &PlotMark::x),
                              share_along(mark->y, plot_.has_log_y, &PlotMark::y), mark->label});
        }
        const std::vector<bool> is_readable = readable_labels(placed);
        std::string script;
        for (std::size_t i = 0; i < labelled_.size(); ++i) {
            if (!is_readable[i]) continue;
            script += "set label " + gnuplot_quoted(labelled_[i]->label) + " at " +
                      shortest_number_text(labelled_[i]->x) + "," +
                      shortest_number_text(labelled_[i]->y) +
                      " front offset 0.7,0.5 font ',12' tc rgb '#404040'\n";
        }
        return script;
    }

    /// Where a value lies on an axis, which gnuplot makes reach to whole decades, or down to 0.
    [[nodiscard]] double share_along(double value, bool is_logarithmic,
                                     double PlotMark::*coordinate) const {
        const auto along = [&](double at) { return is_logarithmic ? std::log10(at) : at; };
        double least = along(value);
        double most = least;
        for (const PlotSeries& series : plot_.series) {
            for (const PlotMark& mark : series.marks) {
                if (!is_drawable(plot_, mark)) continue;
                least = std::min(least, along(mark.*coordinate));
                most = std::max(most, along(mark.*coordinate));
            }
        }
        least = is_logarithmic ? std::floor(least) : std::min(least, 0.0);
        if (is_logarithmic) most = std::ceil(most);
        return most > least ? (along(value) - least) / (most - least) : 0.0;
    }

    void draw(const std::vector<const PlotMark*>& marks, const std::string& how,
              const std::string& name) {
        const std::string block = "$d" + std::to_string(blocks_++);
        data_ += block + " << EOD\n";
        for (const PlotMark* mark : marks) {
            const Interval x = mark->x_range.value_or(Interval{mark->x, mark->x});
            const Interval y = mark->y_range.value_or(Interval{mark->y, mark->y});
            for (const double value : {mark->x, mark->y, x.low, x.high, y.low, y.high}) {
                data_ += shortest_number_text(value) + " ";
            }
            data_ += "\n";
        }
        data_ += "EOD\n";
        drawn_ += (drawn_.empty() ? "" : ", \\\n     ") + block + " " + how +
                  (name.empty() ? " notitle" : " title " + gnuplot_quoted(name));
    }

    const Plot& plot_;
    struct {
        double x = 0.0;
        double y = 0.0;
    } least_;
    int blocks_ = 0;
    std::vector<const PlotMark*> labelled_;
    std::string data_;
    std::string drawn_;
};

}  // namespace

std::string plot_svg(const Plot& plot, const Progress& progress) {
    const PlotScript script(plot);
    if (script.is_empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-CHART-EMPTY",
                    plot.title + ": there is nothing to draw",
                    "measure at least one setting that can be built");
    }
    return gnuplot_svg(
        {plot.title, "size 680,520 font 'sans-serif,15' background rgb 'white'", script.text()},
        progress);
}

}  // namespace lumi
