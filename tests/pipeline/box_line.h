#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "calib/work/progress.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/built_program.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {

/// The textured box with its true poses, and the line over it.
class BoxLine : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        scene_ = std::make_unique<ScratchFolder>();
        SilentProgress progress;
        synthesize_into(scene_->path(), textured_box_description(), 0, progress);
    }
    static void TearDownTestSuite() { scene_.reset(); }

    /// With depth from scene points and drawing that is told, unless a test is about these.
    void configure(const std::string& more, const std::string& depth = kSparseDepth,
                   const std::string& drawing = kToldDrawing) const {
        write_whole_text(config_path(), "name = \"box\"\n[capture]\nphotos = \"" +
                                            (scene_->path() / "photos").string() +
                                            "\"\nimport = \"" +
                                            (scene_->path() / "truth" / "sparse").string() +
                                            "\"\n" + more + depth + drawing);
    }
    /// States of the stages, in their order: 'r' for run, 'u' for up to date.
    std::string build(const std::string& command = "build") const {
        const Outcome outcome = lumi(command + " --json " + quoted(config_path()) +
                                     " --workspace " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        std::string states;
        const auto result = nlohmann::json::parse(outcome.out);
        for (const auto& stage : result.at("stages")) {
            states += stage.at("state") == "run" ? 'r' : 'u';
        }
        return states;
    }
    [[nodiscard]] std::filesystem::path config_path() const { return scratch_ / "box.toml"; }
    [[nodiscard]] std::filesystem::path workspace() const { return scratch_ / "work"; }
    [[nodiscard]] std::filesystem::path package() const { return workspace() / "box.lumi"; }

    static inline std::unique_ptr<ScratchFolder> scene_;
    ScratchFolder scratch_;
};

}  // namespace lumi
