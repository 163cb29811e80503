#include "pipeline/chart/gnuplot.h"

#include <filesystem>

#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "calib/work/temporary_folder.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeLimitS = 60.0;

/// What stands for itself between gnuplot's double quotes. Digits do not, because they would go on
/// an octal number before them.
bool stands_for_itself(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == ' ' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// gnuplot's exit status says nothing about a picture that was cut short.
bool is_whole_svg(std::string_view svg) {
    return svg.substr(0, svg.find_last_not_of('\n') + 1).ends_with("</svg>");
}

}  // namespace

std::string gnuplot_quoted(std::string_view text) {
    std::string spaced(text);
    for (char& c : spaced) {
        if (is_control(c)) c = ' ';
    }
    // Octal numbers, because gnuplot runs what stands between backquotes in double quotes, and in
    // single quotes loses count of two that follow each other.
    std::string result = "\"";
    for (const char c : printable(spaced)) {
        if (stands_for_itself(c)) {
            result += c;
            continue;
        }
        result += '\\';
        for (const int shift : {6, 3, 0}) result += static_cast<char>('0' + ((c >> shift) & 7));
    }
    return result + '"';
}

std::string gnuplot_svg(const GnuplotPicture& picture, const Progress& progress) {
    const TemporaryFolder scratch;
    const fs::path script = scratch / "plot.gp";
    const fs::path drawn = scratch / "plot.svg";
    // The path comes as an argument, which gnuplot does not read as a command.
    write_whole_text(script, "set encoding utf8\nset terminal svg noenhanced " + picture.canvas +
                                 "\nset output ARG1\n" + picture.commands);
    ChildCommand command;
    command.arguments = {"gnuplot", "-c", script.string(), drawn.string()};
    command.log_path = scratch / "log";
    command.time_limit_s = kTimeLimitS;
    command.missing_advice = "install gnuplot (Debian: gnuplot-nox)";
    const ChildResult result = run_child(command, progress);
    std::error_code status;
    const std::string svg = fs::is_regular_file(drawn, status) ? read_whole_text(drawn) : "";
    if (result.end != ChildEnd::kExited || result.exit_status != 0 || !is_whole_svg(svg)) {
        throw Error(ErrorKind::kExternalProgram, "E-CHART-GNUPLOT",
                    "gnuplot made no picture of \"" + picture.title + "\": " +
                        description_of(result, command) + ": " + read_whole_text(scratch / "log"),
                    "check that gnuplot runs and that the disk is not full");
    }
    return svg;
}

}  // namespace lumi
