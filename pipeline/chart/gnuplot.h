#pragma once

#include <string>
#include <string_view>

#include "calib/work/progress.h"

namespace lumi {

/// A picture for gnuplot to draw.
struct GnuplotPicture {
    std::string title;     ///< What it shows, for messages.
    std::string canvas;    ///< Options of the SVG: "size 680,520 font 'sans-serif,15'".
    std::string commands;  ///< What draws it. Texts stand there as they are, without markup.
};

/// A text as a string in a gnuplot command, whatever it contains: nothing in it is executed or
/// ends the string. Control characters become spaces, and bytes that are not UTF-8 "\xNN". Labels
/// of ticks are formats besides: a % is to be doubled there.
[[nodiscard]] std::string gnuplot_quoted(std::string_view text);

/// Draws a picture as SVG with gnuplot. Throws Error: E-CHILD-MISSING (there is no gnuplot),
/// E-CHART-GNUPLOT (it failed, did not end or left no whole picture), E-INTERRUPTED, E-FILE-WRITE.
[[nodiscard]] std::string gnuplot_svg(const GnuplotPicture& picture, const Progress& progress);

}  // namespace lumi
