#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/dataset/dataset.h"
#include "pipeline/dataset/dataset_files.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::Not;

class DatasetFile : public testing::Test {
 protected:
    DatasetFile() {
        write_whole_text(
            scratch_ / "one.toml",
            "name = \"one\"\n[capture]\nphotos = \"p1\"\n[depth]\nmax_width_px = 300\n");
        write_whole_text(scratch_.path() / "folder" / "a.txt", "no photograph");
    }
    Dataset read(const std::string& text) {
        write_whole_text(path(), text);
        return read_dataset(path());
    }
    [[nodiscard]] std::filesystem::path path() const { return scratch_ / "set.toml"; }
    ScratchFolder scratch_;
};

TEST_F(DatasetFile, GivesEverySceneItsSettings) {
    const Dataset dataset = read(
        "[settings]\ndepth.model = \"sparse\"\nthreads = 2\n[[scene]]\nconfig = \"one.toml\"\n"
        "[[scene]]\nphotos = \"folder\"\nname = \"two\"\nsettings.depth.max_neighbours = 2\n");
    EXPECT_EQ(dataset.name, "set");
    ASSERT_EQ(dataset.scenes.size(), 2U);
    EXPECT_EQ(dataset.scenes[0].name, "one");
    EXPECT_EQ(dataset.scenes[0].config.depth.model, "sparse");
    EXPECT_EQ(dataset.scenes[0].config.depth.max_width_px, 300);
    EXPECT_EQ(dataset.scenes[0].config.photographs_or_video, scratch_ / "p1");
    EXPECT_EQ(dataset.scenes[0].config.threads, 2);
    EXPECT_EQ(dataset.scenes[1].name, "two");
    EXPECT_EQ(dataset.scenes[1].config.depth.max_neighbours, 2);
    EXPECT_EQ(dataset.scenes[1].config.depth.model, "sparse");
    EXPECT_EQ(dataset.scenes[1].config.photographs_or_video, scratch_ / "folder");
    EXPECT_TRUE(is_dataset_file(path()));
    EXPECT_FALSE(is_dataset_file(scratch_ / "one.toml"));
}

TEST_F(DatasetFile, ASceneThatCannotBeReadIsThatScenesFailure) {
    write_whole_text(scratch_ / "bad.toml", "[capture]\nfotos = \"p\"\n");
    const Dataset dataset = read(
        "[[scene]]\nconfig = \"bad.toml\"\n[[scene]]\nconfig = \"none.toml\"\n[[scene]]\nconfig = "
        "\"one.toml\"\n");
    ASSERT_TRUE(dataset.scenes[0].failure && dataset.scenes[1].failure);
    EXPECT_EQ(dataset.scenes[0].failure->code(), "E-CONFIG-KEY");
    EXPECT_THAT(dataset.scenes[0].failure->advice(), HasSubstr("photos"));
    EXPECT_EQ(dataset.scenes[1].failure->code(), "E-FILE-READ");
    EXPECT_FALSE(dataset.scenes[2].failure);
}

TEST_F(DatasetFile, IsReadStrictly) {
    for (const char* wrong :
         {"[[scene]]\n", "[[scene]]\nconfig = \"one.toml\"\nphotos = \"p\"\n",
          "[[scene]]\nconfig = \"one.toml\"\n[[scene]]\nconfig = \"one.toml\"\n",
          "nmae = \"x\"\n[[scene]]\nconfig = \"one.toml\"\n",
          "[[scene]]\nconfig = \"one.toml\"\nsetings.depth.model = \"sparse\"\n"}) {
        EXPECT_THROW(static_cast<void>(read(wrong)), Error) << wrong;
    }
}

TEST_F(DatasetFile, AMisspeltKeyOfASceneComesWithASuggestion) {
    for (const char* wrong :
         {"[[scene]]\nconfg = \"one.toml\"\n",
          "[[scene]]\nconfig = \"one.toml\"\n[[scene]]\ncnofig = \"one.toml\"\n"}) {
        try {
            static_cast<void>(read(wrong));
            FAIL() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-CONFIG-KEY") << wrong;
            EXPECT_THAT(error.advice(), HasSubstr("did you mean `config`?")) << wrong;
        }
    }
}

TEST_F(DatasetFile, IsToldFromAConfigurationWhereOneCaptureIsExpected) {
    static_cast<void>(read("[[scene]]\nconfig = \"one.toml\"\n"));
    for (const auto& load :
         {+[](const std::filesystem::path& file) { return load_build_config(file); },
          +[](const std::filesystem::path& file) {
              return ConfigDocument::open(file).build_config_with({});
          }}) {
        try {
            static_cast<void>(load(path()));
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-CONFIG-DATASET");
            EXPECT_THAT(error.what(), HasSubstr("a dataset of scenes"));
        }
    }
}

TEST_F(DatasetFile, TheNameOfASceneIsOneOfItsSettings) {
    const Dataset dataset = read("[[scene]]\nconfig = \"one.toml\"\nname = \"it's \\\"two\\\"\"\n");
    EXPECT_EQ(dataset.scenes[0].name, "it's \"two\"");
    EXPECT_EQ(dataset.scenes[0].config.name, dataset.scenes[0].name);
    write_whole_text(scratch_ / "config.toml", dataset.scenes[0].config.resolved_toml);
    EXPECT_EQ(ConfigSection::from_file(scratch_ / "config.toml").text("name", ""),
              dataset.scenes[0].name);
}

TEST_F(DatasetFile, AFolderIsNamedWhole) {
    for (const char* folder : {"garden.1", "garden.2"})
        write_whole_text(scratch_.path() / folder / "a.txt", "no photograph");
    const Dataset dataset = read(
        "[[scene]]\nphotos = \"garden.1\"\n[[scene]]\nphotos = \"garden.2/\"\n"
        "[[scene]]\nphotos = \"not.there\"\n[[scene]]\nconfig = \"one.toml\"\n");
    std::vector<std::string> names;
    for (const DatasetScene& scene : dataset.scenes) names.push_back(scene.name);
    EXPECT_THAT(names, testing::ElementsAre("garden.1", "garden.2", "not.there", "one"));
}

TEST_F(DatasetFile, ANameThatLeadsElsewhereIsRefused) {
    const std::string scene = "[[scene]]\nconfig = \"one.toml\"\n";
    for (const char* name : {"../../escaped", "../out/of", "..", "/out", ""}) {
        const std::string setting = "name = \"" + std::string(name) + "\"\n";
        for (const std::string& text : {setting + scene, scene + setting}) {
            try {
                static_cast<void>(read(text));
                FAIL() << text;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), "E-CONFIG-VALUE") << text;
                EXPECT_THAT(error.what(), HasSubstr(path().string())) << text;
            }
        }
    }
}

TEST(DatasetFiles, HoldTheTextOfAFailureThatIsNotUtf8) {
    const ScratchFolder scratch;
    SceneOutcome bad;
    bad.name = "bad";
    bad.failure = Error(ErrorKind::kBadInput, "E-FILE-READ", "n\xff.jpg", "rename n\xff.jpg");
    const SilentProgress progress;
    write_dataset_files(scratch.path(), "set", {bad}, progress);
    const auto scene = read_json_file(scratch / "dataset.json").at("scenes").at(0);
    EXPECT_EQ(scene.at("failure"), "n\\xff.jpg");
    EXPECT_EQ(scene.at("failure_advice"), "rename n\\xff.jpg");
    for (const char* name : {"dataset.csv", "dataset.html"})
        EXPECT_THAT(read_whole_text(scratch / name), HasSubstr("E-FILE-READ: n\\xff.jpg -"))
            << name;
}

TEST(DatasetFiles, TellFailuresBesideResultsAndEscapeThem) {
    const ScratchFolder scratch;
    SceneOutcome good;
    good.name = "good";
    good.cpu_s = 12.5;
    good.mean = ViewScore{.name = "mean", .psnr_db = 25.0};
    good.mean->flip = 0.125;
    SceneOutcome bad;
    bad.name = "<b>bad";
    bad.failure = Error(ErrorKind::kDegenerateCapture, "E-POSES-ROTATION",
                        "only turned, on the spot", "step <i>sideways</i>");
    const SilentProgress progress;
    write_dataset_files(scratch.path(), "set", {good, bad}, progress);
    const std::string page = read_whole_text(scratch / "dataset.html");
    EXPECT_THAT(page, HasSubstr("1 of 2 scenes"));
    EXPECT_THAT(page, HasSubstr("E-POSES-ROTATION"));
    EXPECT_THAT(page, HasSubstr("step &lt;i&gt;sideways"));
    EXPECT_THAT(page, Not(HasSubstr("<b>bad")));
    EXPECT_EQ(read_json_file(scratch / "dataset.json").at("scenes").at(1).at("failure_advice"),
              "step <i>sideways</i>");
    EXPECT_THAT(read_whole_text(scratch / "dataset.csv"), HasSubstr("\"E-POSES-ROTATION: only"));
    EXPECT_THAT(read_whole_text(scratch / "dataset.svg"), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace lumi
