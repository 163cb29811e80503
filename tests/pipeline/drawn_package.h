#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "calib/pictures/image_io.h"
#include "calib/work/progress.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/built_program.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {

/// A package of the textured box with its true poses, and commands that draw it.
class DrawnPackage : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<ScratchFolder>();
        SilentProgress progress;
        synthesize_into(*folder_ / "scene", textured_box_description(), 0, progress);
        write_whole_text(*folder_ / "box.toml",
                         "name = \"box\"\nworkspace = \"work\"\n[capture]\n"
                         "photos = \"scene/photos\"\nimport = \"scene/truth/sparse\"\n"
                         "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n" +
                             std::string(kSparseDepth) + kToldDrawing);
        ASSERT_EQ(lumi("build " + quoted(*folder_ / "box.toml")).exit_code, 0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::filesystem::path workspace() { return *folder_ / "work"; }
    static std::string package() { return quoted(workspace() / "box.lumi"); }
    /// What `lumi render` draws by these arguments.
    [[nodiscard]] ColorImage drawn(const std::string& arguments) const {
        const Outcome outcome = lumi("render " + package() + " " + arguments + " --out " +
                                     quoted(scratch_ / "drawn.png"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return read_color_image(scratch_ / "drawn.png");
    }

    static inline std::unique_ptr<ScratchFolder> folder_;
    ScratchFolder scratch_;
};

}  // namespace lumi
