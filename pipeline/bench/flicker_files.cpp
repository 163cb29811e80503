#include "pipeline/bench/flicker_files.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>

#include "calib/pictures/image_io.h"
#include "calib/work/median.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// How much differences are strengthened so that they are seen.
constexpr int kGain = 4;

Plot plot_of(const std::vector<FlickerFigures>& all) {
    Plot plot;
    plot.title = "How much pictures change from frame to frame";
    plot.x_label = "frame";
    plot.y_label = "mean change, steps of 1/255";
    plot.has_log_y = true;
    for (const FlickerFigures& figures : all) {
        PlotSeries series;
        series.name = figures.mode;
        series.is_curve = true;
        for (std::size_t i = 0; i < figures.changes.size(); ++i) {
            PlotMark mark;
            mark.x = static_cast<double>(i + 1);
            mark.y = figures.changes[i];
            series.marks.push_back(mark);
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

ColorImage side_by_side(const Jump& jump) {
    const int width = jump.before.width();
    ColorImage picture(3 * width, jump.before.height());
    const auto strengthened = [](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::min(255, kGain * std::abs(a - b)));
    };
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const Rgb8& before = jump.before(x, y);
            const Rgb8& after = jump.after(x, y);
            picture(x, y) = before;
            picture(width + x, y) = after;
            picture(2 * width + x, y) = {strengthened(before.r, after.r),
                                         strengthened(before.g, after.g),
                                         strengthened(before.b, after.b)};
        }
    }
    return picture;
}

}  // namespace

Json flicker_json(const std::vector<FlickerFigures>& all) {
    Json modes = Json::object();
    for (const FlickerFigures& figures : all) {
        const std::vector<double>& changes = figures.changes;
        const double sum = std::accumulate(changes.begin(), changes.end(), 0.0);
        modes[figures.mode] = {
            {"flicker", optional_json(figures.flicker)},
            {"worst_flicker", optional_json(figures.worst_flicker)},
            {"mean_change", sum / static_cast<double>(changes.size())},
            {"p99_change", quantile_of(changes, 0.99)},
            {"largest_change", *std::max_element(changes.begin(), changes.end())},
            {"jump", figures.jump.change},
            {"jump_pixel_share", figures.jump.pixel_share},
            {"jump_frame", figures.jump.frame},
            {"changes", changes}};
    }
    return Json{{"modes", std::move(modes)}};
}

void write_flicker_files(const std::filesystem::path& folder,
                         const std::vector<FlickerFigures>& all, const Progress& progress) {
    write_whole_text(folder / "flicker.svg", plot_svg(plot_of(all), progress));
    for (const FlickerFigures& figures : all) {
        std::string name = figures.mode;
        std::replace(name.begin(), name.end(), ' ', '-');
        write_png(folder / ("jump-" + name + ".png"), side_by_side(figures.jump));
    }
    write_json_file(folder / "flicker.json", flicker_json(all));
}

}  // namespace lumi
