#include "pipeline/hazards/hazard_chart.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "calib/work/whole_file.h"
#include "pipeline/chart/gnuplot.h"

namespace lumi {
namespace {

constexpr double kLeastError = 1e-3;
constexpr double kMostError = 10.0;
constexpr double kRefusedLine = 40.0;  ///< Where a refusal is drawn.

/// Position of a strength on the horizontal axis: its number, because strengths are steps from
/// harmless to hopeless of very different sizes.
std::size_t step_of(const Trial& trial) {
    const std::vector<double>& strengths = curve_of(trial.hazard).strengths;
    return static_cast<std::size_t>(std::find(strengths.begin(), strengths.end(), trial.strength) -
                                    strengths.begin());
}

double height_of(const Attempt& attempt) {
    if (attempt.ending == Ending::kRefused || attempt.ending == Ending::kFailed) {
        return kRefusedLine;
    }
    // What is turned too far is as wrong as what is moved too far.
    const double turned =
        kMaxPositionErrorShare * attempt.error.rotation_deg / kMaxRotationError_deg;
    return std::clamp(std::max(attempt.error.position_share, turned), kLeastError, kMostError);
}

/// The points of one program in one ending, as an inline data block.
std::string data_block(const std::string& name, const std::vector<const Trial*>& trials,
                       const Attempt Trial::*attempt, double shift,
                       const std::set<Ending>& endings) {
    std::ostringstream block;
    block << "$" << name << " << EOD\n";
    bool is_empty = true;
    for (const Trial* trial : trials) {
        if (!endings.contains((trial->*attempt).ending)) continue;
        block << static_cast<double>(step_of(*trial)) + shift << ' ' << height_of(trial->*attempt)
              << '\n';
        is_empty = false;
    }
    if (is_empty) block << "NaN NaN\n";
    block << "EOD\n";
    return block.str();
}

std::string tick_labels(const HazardCurve& curve) {
    std::ostringstream labels;
    for (std::size_t step = 0; step < curve.strengths.size(); ++step) {
        labels << (step == 0 ? "" : ", ") << '"' << curve.strengths[step] << "\" " << step;
    }
    return labels.str();
}

/// The first step at which some attempt of lumi does not end with right poses.
std::size_t breaking_step(const HazardCurve& curve, const std::vector<const Trial*>& trials) {
    std::size_t breaking = curve.strengths.size();
    for (const Trial* trial : trials) {
        if (trial->lumi.ending != Ending::kRight) breaking = std::min(breaking, step_of(*trial));
    }
    return breaking;
}

std::string panel_script(const HazardCurve& curve, const std::vector<const Trial*>& trials) {
    std::ostringstream script;
    const double steps = static_cast<double>(curve.strengths.size());
    script << "set title " << gnuplot_quoted(curve.name) << "\nset xlabel "
           << gnuplot_quoted(curve.strength) << "\nset xtics (" << tick_labels(curve)
           << ")\nset xrange [-0.4:" << steps - 0.6 << "]\nunset arrow\nunset label\n"
           << "set arrow 1 from -0.4," << kMaxPositionErrorShare << " to " << steps - 0.6 << ","
           << kMaxPositionErrorShare << " nohead dt 2 lc rgb \"#888888\"\n";
    const auto breaking = static_cast<double>(breaking_step(curve, trials));
    if (breaking < steps) {
        script << "set arrow 2 from " << breaking - 0.5 << "," << kLeastError << " to "
               << breaking - 0.5 << "," << kMostError << " nohead lw 1.5 lc rgb \"#c0392b\"\n";
    }
    const std::set<Ending> poses{Ending::kRight, Ending::kFalse};
    const std::set<Ending> none{Ending::kRefused, Ending::kFailed};
    script << data_block("lumi_poses", trials, &Trial::lumi, -0.07, poses)
           << data_block("lumi_false", trials, &Trial::lumi, -0.07, {Ending::kFalse})
           << data_block("lumi_none", trials, &Trial::lumi, -0.07, none)
           << data_block("colmap_poses", trials, &Trial::colmap, 0.07, poses)
           << data_block("colmap_false", trials, &Trial::colmap, 0.07, {Ending::kFalse})
           << data_block("colmap_none", trials, &Trial::colmap, 0.07, none)
           << "plot $colmap_poses with points pt 7 ps 0.55 lc rgb \"#e08a2a\" notitle, "
              "$colmap_false with points pt 2 ps 1.1 lw 1.6 lc rgb \"#e08a2a\" notitle, "
              "$colmap_none with points pt 4 ps 0.7 lc rgb \"#e08a2a\" notitle, "
              "$lumi_poses with points pt 7 ps 0.55 lc rgb \"#2f6fb0\" notitle, "
              "$lumi_false with points pt 2 ps 1.1 lw 1.6 lc rgb \"#2f6fb0\" notitle, "
              "$lumi_none with points pt 4 ps 0.7 lc rgb \"#2f6fb0\" notitle\n";
    return script.str();
}

/// Panels of one size, five to a row, however many there are.
GnuplotPicture empty_page(std::size_t panels) {
    constexpr std::size_t kColumns = 5;
    constexpr double kAbove_px = 130;
    constexpr double kPanel_px = 230;
    constexpr double kBetween_px = 92;
    constexpr double kBelow_px = 76;
    const std::size_t rows = std::max<std::size_t>(1, (panels + kColumns - 1) / kColumns);
    const auto count = static_cast<double>(rows);
    const double height_px = kAbove_px + count * kPanel_px + (count - 1) * kBetween_px + kBelow_px;
    GnuplotPicture page;
    page.title = "error against strength of hazards";
    page.canvas = "size 1500," + std::to_string(std::lround(height_px)) +
                  " font 'sans-serif,11' background '#ffffff'";
    std::ostringstream script;
    script << "set multiplot layout " << rows << "," << kColumns << " margins 0.045,0.99,"
           << kBelow_px / height_px << "," << 1 - kAbove_px / height_px << " spacing 0.03,"
           << kBetween_px / height_px
           << " title \"Error of the worst camera against strength, harmless to hopeless (blue: "
              "lumi, orange: COLMAP 3.8 alone)\\ndots: poses; crosses: false successes; squares "
              "above: no poses; dashed: bound; red: breaking point of lumi\"\n";
    page.commands = script.str();
    return page;
}

GnuplotPicture hazard_picture(const std::vector<Trial>& trials) {
    std::string panels;
    std::size_t count = 0;
    for (const HazardCurve& curve : hazard_curves()) {
        std::vector<const Trial*> own;
        for (const Trial& trial : trials) {
            if (trial.hazard == curve.hazard) own.push_back(&trial);
        }
        if (own.empty()) continue;
        panels += panel_script(curve, own);
        ++count;
    }
    GnuplotPicture picture = empty_page(count);
    std::ostringstream scales;
    scales << "set logscale y\nset yrange [" << kLeastError << ":80]\n"
           << "set ytics (\"0.1 %%\" 0.001, \"1 %%\" 0.01, \"10 %%\" 0.1, \"100 %%\" 1, \"none\" "
           << kRefusedLine << ")\nset grid y lc rgb \"#eeeeee\"\n";
    picture.commands += scales.str() + panels + "unset multiplot\n";
    return picture;
}

}  // namespace

void draw_hazard_chart(const std::filesystem::path& svg, const std::vector<Trial>& trials,
                       const Progress& progress) {
    write_whole_text(svg, gnuplot_svg(hazard_picture(trials), progress));
}

}  // namespace lumi
