#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using testing::HasSubstr;

TEST(ToldColors, WhatWasConvertedIsSaidByDoctorIngestAndReport) {
    const ScratchFolder scratch;
    for (int i = 0; i < 2; ++i) {
        FloatImage light(160, 120);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) light(x, y) = 0.002F * static_cast<float>(x + 2 * i * y);
        }
        write_float_tiff(scratch / ("photos/" + std::to_string(i) + ".tif"), light);
    }
    const auto says_it = HasSubstr("2 photographs were converted from linear light to sRGB");
    const Outcome examined =
        lumi("doctor " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "doctor"));
    EXPECT_THAT(examined.out, says_it);
    EXPECT_THAT(read_whole_text(scratch / "doctor" / "doctor" / "doctor.json"), says_it);
    const Outcome ingested =
        lumi("ingest " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "work"));
    EXPECT_EQ(ingested.exit_code, 0) << ingested.talk;
    EXPECT_THAT(ingested.talk, says_it);
    EXPECT_THAT(read_whole_text(scratch / "work" / "report.html"), says_it);
}

}  // namespace
}  // namespace lumi
