#include "pipeline/config/config_variant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/growth.h"
#include "pipeline/chart/sweep.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A configuration whose keys are not in the order of their names, with remarks between them.
class ConfigFile : public testing::Test {
 protected:
    ConfigDocument document(const std::string& more = "") {
        write_whole_text(path_,
                         "# About\n\nname = \"cat\"\n\n[evaluate]\nhold_out_every = 4\n\n"
                         "[capture]\nphotos = \"photos\"\n" +
                             more);
        return ConfigDocument::open(path_);
    }

    /// What is said against the file with changes.
    std::string refusal(const std::string& more, const std::vector<ConfigChange>& changes) {
        const ConfigDocument opened = document(more);
        return refusal_of([&] { static_cast<void>(opened.build_config_with(changes)); });
    }

    template <class Work>
    static std::string refusal_of(const Work& work) {
        try {
            work();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing";
    }

    ScratchFolder scratch_;
    fs::path path_ = scratch_ / "cat.toml";
};

TEST_F(ConfigFile, WhatStandsInTheFileIsRefusedByItsLineWhateverIsChanged) {
    const std::string wrong_key = "max_widht_px = 800\n";
    const std::string place = path_.string() + ":10: ";
    EXPECT_THAT(refusal(wrong_key, {}), StartsWith(place));
    EXPECT_THAT(refusal(wrong_key, {{"depth.model", "\"sparse\""}, {"threads", "1"}}),
                StartsWith(place));
    for (const char* wrong_value :
         {"[depth]\nmodel = \"nonsense\"\n", "[poses]\nmapper = \"nonsense\"\n",
          "[mesh]\nconstruction = \"nonsense\"\n", "[depth]\nmax_width_px = 3\n"}) {
        EXPECT_THAT(refusal(wrong_value, {{"threads", "1"}}),
                    StartsWith(path_.string() + ":11: `"));
    }
}

TEST_F(ConfigFile, WhatWasChangedIsRefusedAsAChange) {
    EXPECT_THAT(refusal("", {{"depth.model", "\"nonsense\""}}),
                StartsWith(path_.string() + " with depth.model = \"nonsense\": `depth.model`"));
    EXPECT_THAT(refusal("[depth]\nmodel = \"sweep\"\n", {{"depth.model", "\"nonsense\""}}),
                HasSubstr("cat.toml with depth.model = \"nonsense\": `depth.model`"));
    EXPECT_THAT(refusal("", {{"detph.model", "\"sweep\""}}),
                HasSubstr("cat.toml with detph.model = \"sweep\": unknown key `detph`"));
    EXPECT_THAT(refusal("", {{"depth.model", "[1"}}), HasSubstr("cat.toml with depth.model = [1"));
    EXPECT_THAT(refusal("", {{"name.of", "1"}}), HasSubstr("cat.toml:3: `name.of`"));
}

TEST_F(ConfigFile, ChangesTakeThePlaceOfWhatIsThereAndLeaveTheRest) {
    const BuildConfig config =
        document("[depth]\nmodel = \"sweep\"\nmax_neighbours = 3\n")
            .build_config_with({{"depth.model", "\"sparse\""}, {"evaluate.hold_out_every", "0"}});
    EXPECT_EQ(config.depth.model, "sparse");
    EXPECT_EQ(config.depth.max_neighbours, 3);
    EXPECT_EQ(config.hold_out.every, 0);
    EXPECT_EQ(config.name, "cat");
    EXPECT_EQ(config.photographs_or_video, scratch_ / "photos");
}

TEST_F(ConfigFile, ASectionForOthersIsRefusedByItsLines) {
    const auto sweep_refusal = [&](const std::string& more) {
        static_cast<void>(document(more));
        return refusal_of([&] { static_cast<void>(read_sweep(path_)); });
    };
    EXPECT_THAT(sweep_refusal("[sweep]\nrepeat = 2\ndepth.model = [\"sweep\"]\n"),
                StartsWith(path_.string() + ":11: unknown key `sweep.repeat`"));
    EXPECT_THAT(sweep_refusal("[sweep]\nrepeats = 0\n"),
                StartsWith(path_.string() + ":11: `sweep.repeats`"));
    EXPECT_THAT(sweep_refusal("[sweep]\ndepth.model = [\"sweep\", \"nonsense\"]\n"),
                StartsWith(path_.string() + " with depth.model = 'nonsense': "));
    const ConfigDocument growing = document("[growth]\nphotographs = [3.5]\n");
    EXPECT_THAT(refusal_of([&] { static_cast<void>(read_growth_plan(growing)); }),
                StartsWith(path_.string() + ":11: `growth.photographs`"));
}

TEST_F(ConfigFile, WhatIsResolvedForAnyFolderNamesTheSamePlaces) {
    const BuildConfig config =
        document("import = \"../poses\"\n[poses]\nmasks = \"masks\"\n[depth]\nmasks = \"m\"\n")
            .build_config_with({});
    fs::create_directories(scratch_ / "elsewhere");
    write_whole_text(scratch_ / "elsewhere" / "moved.toml", config.movable_toml);
    const BuildConfig moved = load_build_config(scratch_ / "elsewhere" / "moved.toml");
    EXPECT_EQ(moved.name, "cat");
    EXPECT_EQ(moved.photographs_or_video, scratch_ / "photos");
    EXPECT_EQ(moved.imported_poses, scratch_.path().parent_path() / "poses");
    EXPECT_EQ(moved.poses.mask_folder, scratch_ / "masks");
    EXPECT_EQ(moved.depth.mask_folder, scratch_ / "m");
    EXPECT_EQ(moved.movable_toml, config.movable_toml);
    EXPECT_THAT(config.resolved_toml, Not(HasSubstr(scratch_.path().string())));
}

TEST_F(ConfigFile, AFolderIsAConfigurationWhateverItIsCalled) {
    const fs::path photos = scratch_ / "back\\slash" / "it's \"so\" deep";
    fs::create_directories(photos);
    EXPECT_TRUE(fs::equivalent(
        ConfigDocument::open(photos).build_config_with({}).photographs_or_video, photos));
    EXPECT_TRUE(fs::equivalent(load_build_config(photos).photographs_or_video, photos));
}

TEST_F(ConfigFile, OneThatLiesWhereNoTextCanNameItIsRefused) {
    const fs::path config = scratch_.path() / "n\xff" / "cat.toml";
    write_whole_text(config, "[capture]\nphotos = \"photos\"\n");
    try {
        static_cast<void>(load_build_config(config));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CONFIG-NAME");
        EXPECT_THAT(error.what(), testing::HasSubstr("n\\xff: "));
    }
}

}  // namespace
}  // namespace lumi
