#include "pipeline/chart/gnuplot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"
#include "pipeline/depth_bench/rung_chart.h"
#include "pipeline/hazards/hazard_chart.h"
#include "pipeline/pose_bench/pose_chart.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/set_variable.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A program of the shell that is found as gnuplot while this object lives; its picture is "$3".
class GnuplotStandIn {
 public:
    explicit GnuplotStandIn(const std::string& commands)
        : path_("PATH", folder_.path().string() + ":" + std::getenv("PATH")) {
        fs::permissions(folder_.put_text("gnuplot", "#!/bin/sh\n" + commands),
                        fs::perms::owner_all);
    }

 private:
    ScratchFolder folder_;
    SetVariable path_;
};

constexpr const char* kExecuted = "executed-by-gnuplot";

/// Names that would end a string, be markup, or run a program in the working folder.
const std::vector<std::string>& hostile_names() {
    static const std::vector<std::string> names{"x`touch executed-by-gnuplot`",
                                                "Bob's garden",
                                                "'quoted''twice'''",
                                                "say \"x\"; system('touch executed-by-gnuplot') #",
                                                "back\\slash\\n\\",
                                                "{/Bold a}_b^c&d~e@f <b>100% %s $0 $1",
                                                "@ARG1 <<EOD 7`7 tést"};
    return names;
}

/// A text as gnuplot writes it between tags; it leaves > as it is, which XML allows.
std::string in_svg(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    }
    return ">" + escaped + "<";
}

std::string code_of(const std::function<void()>& draw) {
    try {
        draw();
    } catch (const Error& error) {
        return error.code();
    }
    return "nothing";
}

Plot plot_of(const std::string& text) {
    Plot plot{text + " title", text + " x", text + " y", false, false, {}, {}};
    plot.series = {{text + " key", {{1, 2, {}, {}, text + " mark", false}}}};
    return plot;
}

PoseTrial pose_trial() {
    PoseTrial trial;
    trial.cost.cpu_s = 5;
    trial.photographs = trial.placed = 11;
    return trial;
}

std::vector<Trial> hazard_trials() {
    Trial trial{Hazard::kBlur, 0.0, 1, 8, {}, {}, {}, 0, {}};
    trial.lumi.ending = Ending::kRight;
    return {trial};
}

RungMeasurement rung_of(const std::string& text, double cpu_s_per_megapixel) {
    RungMeasurement rung;
    rung.scene = text + " scene";
    rung.model = text + " model";
    rung.cpu_s_per_megapixel = cpu_s_per_megapixel;
    rung.rms_error = 3;
    return rung;
}

/// In a working folder of its own, where nothing that a name says is executed.
class Gnuplot : public testing::Test {
 protected:
    Gnuplot() { fs::current_path(scratch_.path()); }
    ~Gnuplot() override {
        EXPECT_FALSE(fs::exists(scratch_ / kExecuted));
        fs::current_path(before_);
    }

    fs::path before_ = fs::current_path();
    ScratchFolder scratch_;
    SilentProgress progress_;
};

TEST_F(Gnuplot, NamesStandInAPlotAsTheyAre) {
    for (const std::string& name : hostile_names()) {
        const std::string svg = plot_svg(plot_of(name), progress_);
        for (const char* const place : {" title", " x", " y", " key", " mark"}) {
            EXPECT_THAT(svg, HasSubstr(in_svg(name + place)));
        }
    }
}

TEST_F(Gnuplot, NamesStandInAChartOfPosesAsTheyAre) {
    for (const std::string& name : hostile_names()) {
        draw_pose_chart({pose_trial()}, name, scratch_ / "poses.svg", progress_);
        EXPECT_THAT(read_whole_text(scratch_ / "poses.svg"), HasSubstr(in_svg(name)));
    }
}

TEST_F(Gnuplot, NamesStandInAChartOfRungsAsTheyAre) {
    for (const std::string& name : hostile_names()) {
        write_rung_chart(scratch_ / "rungs", {rung_of(name, 1), rung_of(name, 20)}, progress_);
        const std::string svg = read_whole_text(scratch_ / "rungs/rungs.svg");
        EXPECT_THAT(svg, HasSubstr(in_svg(name + " scene")));
        EXPECT_THAT(svg, HasSubstr(in_svg(name + " model")));
    }
}

TEST_F(Gnuplot, ControlCharactersBecomeSpacesAndStrayBytesNumbers) {
    EXPECT_THAT(plot_svg(plot_of("two\nlines\tand\x7f\x1b[0m caf\xe9"), progress_),
                HasSubstr(">two lines and  [0m caf\\xe9 title<"));
}

TEST_F(Gnuplot, FoldersMayHaveAnyName) {
    const fs::path folder =
        scratch_ / "|Bob's \"x\" `touch executed-by-gnuplot` 100%s {a}_b\n''~ \\";
    fs::create_directories(folder);
    const SetVariable temporary("TMPDIR", folder.string());
    write_rung_chart(folder / "rungs", {rung_of("a", 1), rung_of("a", 20)}, progress_);
    draw_hazard_chart(folder / "hazards.svg", hazard_trials(), progress_);
    draw_pose_chart({pose_trial()}, "a", folder / "poses.svg", progress_);
    for (const char* const drawn : {"rungs/rungs.svg", "hazards.svg", "poses.svg"}) {
        EXPECT_THAT(read_whole_text(folder / drawn), HasSubstr("</svg>")) << drawn;
    }
}

TEST_F(Gnuplot, APictureIsTakenOnlyWholeAndFromAProgramThatSucceeded) {
    const std::string whole = "echo '<svg></svg>' > \"$3\"\n";
    const auto drawn = [&] { return gnuplot_svg({"t", "", ""}, progress_); };
    {
        const GnuplotStandIn program(whole);
        EXPECT_EQ(drawn(), "<svg></svg>\n");
    }
    for (const std::string& commands :
         {whole + "exit 1\n", whole + "kill -9 $$\n", std::string("echo '<svg></svg><' > \"$3\"\n"),
          std::string("echo '<svg>' > \"$3\"\n"), std::string(": > \"$3\"\n"),
          std::string("exit 0\n")}) {
        const GnuplotStandIn program(commands);
        EXPECT_EQ(code_of(drawn), "E-CHART-GNUPLOT") << commands;
    }
}

TEST_F(Gnuplot, WhatItComplainsOfIsTold) {
    try {
        static_cast<void>(gnuplot_svg({"the title", "", "set nonsense\n"}, progress_));
        FAIL() << "nonsense was drawn";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHART-GNUPLOT");
        EXPECT_THAT(error.what(), HasSubstr("the title"));
        EXPECT_THAT(error.what(), HasSubstr("set nonsense"));
    }
}

TEST_F(Gnuplot, APictureFromBeforeIsNoResult) {
    const std::string before = "<svg>from before</svg>\n";
    for (const char* const old : {"poses.svg", "hazards.svg", "rungs/rungs.svg"}) {
        write_whole_text(scratch_ / old, before);
    }
    const GnuplotStandIn idle("exit 0\n");
    EXPECT_EQ(
        code_of([&] { draw_pose_chart({pose_trial()}, "t", scratch_ / "poses.svg", progress_); }),
        "E-CHART-GNUPLOT");
    EXPECT_EQ(
        code_of([&] { draw_hazard_chart(scratch_ / "hazards.svg", hazard_trials(), progress_); }),
        "E-CHART-GNUPLOT");
    EXPECT_EQ(code_of([&] { write_rung_chart(scratch_ / "rungs", {rung_of("a", 1)}, progress_); }),
              "E-CHART-GNUPLOT");
    for (const char* const old : {"poses.svg", "hazards.svg", "rungs/rungs.svg"}) {
        EXPECT_EQ(read_whole_text(scratch_ / old), before) << old;
    }
}

}  // namespace
}  // namespace lumi
