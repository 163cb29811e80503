#include "calib/work/config_section.h"

#include <gmock/gmock.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

template <class Work>
Error error_of(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error;
    }
    return {ErrorKind::kBadInput, "none", "nothing was thrown", ""};
}

TEST(ConfigSection, AnswersFromTheFileAndOtherwiseTheFallback) {
    const auto file = ConfigSection::from_text(
        "name = \"x\"\n[depth]\nplanes = 64\nscale = 0.5\nwhole = 2\nfill = true\n"
        "list = [\"a\", \"b\"]\nnumbers = [1, 2.5]\n",
        "c.toml");
    EXPECT_EQ(file.text("name", ""), "x");
    const ConfigSection depth = file.section("depth");
    EXPECT_EQ(depth.integer("planes", 1), 64);
    EXPECT_EQ(depth.number("scale", 1), 0.5);
    EXPECT_EQ(depth.number("whole", 1), 2.0);
    EXPECT_TRUE(depth.boolean("fill", false));
    EXPECT_THAT(depth.texts("list", {}), ElementsAre("a", "b"));
    EXPECT_THAT(depth.numbers("numbers", {}), ElementsAre(1, 2.5));
    EXPECT_EQ(depth.integer("absent", 7), 7);
    EXPECT_EQ(file.section("absent").number("absent", 0.25), 0.25);
    EXPECT_NO_THROW(file.expect_all_keys_known());
}

TEST(ConfigSection, AnUnknownKeyIsRefusedWithItsLineAndTheNearestKnownKey) {
    const auto file = ConfigSection::from_text("[capture]\n\nmax_widht_px = 800\n", "c.toml");
    static_cast<void>(file.section("capture").integer("max_width_px", 1600));
    static_cast<void>(file.section("capture").text("photos", ""));
    const Error error = error_of([&] { file.expect_all_keys_known(); });
    EXPECT_EQ(error.code(), "E-CONFIG-KEY");
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_THAT(error.what(), HasSubstr("c.toml:3"));
    EXPECT_THAT(error.what(), HasSubstr("capture.max_widht_px"));
    EXPECT_THAT(error.advice(), HasSubstr("max_width_px"));
}

TEST(ConfigSection, AnUnknownTableIsRefusedToo) {
    const auto file = ConfigSection::from_text("[captre]\nphotos = \"x\"\n", "c.toml");
    static_cast<void>(file.section("capture"));
    const Error error = error_of([&] { file.expect_all_keys_known(); });
    EXPECT_EQ(error.code(), "E-CONFIG-KEY");
    EXPECT_THAT(error.advice(), HasSubstr("capture"));
}

TEST(ConfigSection, RefusesValuesOfAnotherTypeWithTheirLine) {
    const auto file = ConfigSection::from_text(
        "[s]\ntext = 1\ninteger = 1.5\nnumber = \"1\"\nboolean = 1\ninfinite = inf\nlist = [1]\n",
        "c.toml");
    const ConfigSection s = file.section("s");
    const auto where = [&](const auto& work) { return std::string(error_of(work).what()); };
    EXPECT_THAT(where([&] { static_cast<void>(s.text("text", "")); }), HasSubstr("c.toml:2"));
    EXPECT_THAT(where([&] { static_cast<void>(s.integer("integer", 0)); }), HasSubstr("c.toml:3"));
    EXPECT_THAT(where([&] { static_cast<void>(s.number("number", 0)); }), HasSubstr("c.toml:4"));
    EXPECT_THAT(where([&] { static_cast<void>(s.boolean("boolean", true)); }),
                HasSubstr("c.toml:5"));
    EXPECT_THAT(where([&] { static_cast<void>(s.number("infinite", 0)); }), HasSubstr("c.toml:6"));
    EXPECT_THAT(where([&] { static_cast<void>(s.texts("list", {})); }), HasSubstr("c.toml:7"));
}

TEST(ConfigSection, RefusesBrokenSyntaxWithLineAndColumn) {
    const Error error =
        error_of([] { static_cast<void>(ConfigSection::from_text("a = 1\nb = [1,\n", "c.toml")); });
    EXPECT_EQ(error.code(), "E-CONFIG-SYNTAX");
    EXPECT_THAT(error.what(), HasSubstr("c.toml:"));
}

TEST(ConfigSection, TheResolvedTextHoldsEveryDefaultAndReadsBackToTheSame) {
    const auto file = ConfigSection::from_text("[a]\nx = 3\n", "c.toml");
    static_cast<void>(file.section("a").integer("x", 1));
    static_cast<void>(file.section("a").number("y", 0.1));
    static_cast<void>(file.section("b").text("z", "say \"hi\"\n"));
    const auto again = ConfigSection::from_text(file.resolved(), "resolved");
    EXPECT_EQ(again.section("a").integer("x", 0), 3);
    EXPECT_EQ(again.section("a").number("y", 0), 0.1);
    EXPECT_EQ(again.section("b").text("z", ""), "say \"hi\"\n");
    EXPECT_NO_THROW(again.expect_all_keys_known());
}

TEST(ConfigSection, TheResolvedTextHasTheShortestNumbersThatReadBack) {
    const auto resolved_with = [](double number) {
        const auto file = ConfigSection::from_text("", "c.toml");
        static_cast<void>(file.number("x", number));
        static_cast<void>(file.numbers("list", {0.4, 2.0}));
        return file.resolved();
    };
    EXPECT_THAT(resolved_with(0.4), HasSubstr("x = 0.4\n"));
    EXPECT_THAT(resolved_with(0.4), HasSubstr("[ 0.4, 2.0 ]"));
    const double third = 1.0 / 3;
    EXPECT_EQ(ConfigSection::from_text(resolved_with(third), "c.toml").number("x", 0), third);
}

TEST(ConfigSection, PathsAreRelativeToTheFile) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "configs/c.toml", "photos = \"../photos\"\nabsolute = \"/data\"\n");
    const auto file = ConfigSection::from_file(scratch / "configs/c.toml");
    EXPECT_EQ(file.path("photos"), scratch / "photos");
    EXPECT_EQ(file.path("absolute"), "/data");
    EXPECT_THAT(file.path("absent").string(), IsEmpty());
}

TEST(ConfigSection, ResolvedForAnyFolderEveryPathIsAbsolute) {
    const auto file = ConfigSection::from_text(
        "photos = \"photos\"\nprogram = \"bin/x\"\n[[box]]\nmask = \"../m\"\n", "c.toml", "/a/b");
    static_cast<void>(file.path("photos"));
    static_cast<void>(file.path("absent"));
    static_cast<void>(file.text("program", ""));
    static_cast<void>(file.sections("box").at(0).path("mask"));
    const auto moved =
        ConfigSection::from_text(file.resolved_for_any_folder(), "moved", "/elsewhere");
    EXPECT_EQ(moved.text("photos", ""), "/a/b/photos");
    EXPECT_EQ(moved.text("absent", "x"), "");
    EXPECT_EQ(moved.text("program", ""), "bin/x");
    EXPECT_EQ(moved.sections("box").at(0).text("mask", ""), "/a/m");
    EXPECT_THAT(file.resolved(), HasSubstr("photos = 'photos'"));
}

TEST(ConfigSection, AChangeKeepsTheLinesOfAllElse) {
    const auto file = ConfigSection::from_text("[a]\n\nx = 1\n[b]\ny = 2\n", "c.toml", "/",
                                               {{"a.z.w", "3"}, {"b.y", "true"}});
    EXPECT_EQ(file.section("a").section("z").integer("w", 0), 3);
    const auto said = [&](const std::string& section, const std::string& key) {
        return std::string(
            error_of([&] { file.section(section).refuse(key, "something else"); }).what());
    };
    EXPECT_THAT(said("a", "x"), StartsWith("c.toml:3: `a.x`"));
    EXPECT_THAT(said("b", "y"), StartsWith("c.toml with b.y = true: `b.y`"));
    EXPECT_THAT(said("b", "absent"), StartsWith("c.toml: `b.absent`"));
}

TEST(ConfigSection, WhatIsMissingIsToBeAddedAndWhatIsThereToBeCorrected) {
    const auto file = ConfigSection::from_text("x = 1\n", "c.toml");
    const auto advice = [&](const std::string& key) {
        return error_of([&] { file.refuse(key, "something else"); }).advice();
    };
    EXPECT_EQ(advice("absent"), "add this key");
    EXPECT_THAT(advice("x"), StartsWith("correct this key"));
}

TEST(ConfigSection, ListsTablesOfAnArrayInOrder) {
    const auto file = ConfigSection::from_text("[[box]]\nx = 1\n[[box]]\nx = 2\ny = 3\n", "c.toml");
    const auto boxes = file.sections("box");
    ASSERT_EQ(boxes.size(), 2U);
    EXPECT_EQ(boxes[0].integer("x", 0), 1);
    EXPECT_EQ(boxes[1].integer("x", 0), 2);
    const Error error = error_of([&] { file.expect_all_keys_known(); });
    EXPECT_THAT(error.what(), HasSubstr("c.toml:5"));
    EXPECT_THAT(file.sections("absent"), IsEmpty());
}

}  // namespace
}  // namespace lumi
