#include "pipeline/line/stages_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

TEST(StagesFile, AFailureInAFolderWithAnOddNameIsWrittenDownAsItWas) {
    const ScratchFolder scratch;
    const Error failure(ErrorKind::kResources, "E-FILE-WRITE", "caf\xe9/poses: no space left",
                        "make room beside caf\xe9");
    write_stages_file(scratch / "stages.json", {}, "", "poses", failure);
    const nlohmann::ordered_json told = read_json_file(scratch / "stages.json").at("failure");
    EXPECT_EQ(told.at("code"), "E-FILE-WRITE");
    EXPECT_EQ(told.at("what"), "caf\\xe9/poses: no space left");
    EXPECT_EQ(told.at("advice"), "make room beside caf\\xe9");
}

}  // namespace
}  // namespace lumi
