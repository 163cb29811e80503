#include "pipeline/config/build_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "calib/lens_files/lens_files.h"
#include "calib/work/error.h"
#include "calib/work/toml_tree.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/config/explained_configuration.h"
#include "pipeline/config/lens_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

BuildConfig read(const std::string& toml) {
    return read_build_config(ConfigSection::from_text(toml, "test.toml"), "test");
}

/// The Error that reading ends in.
Error refusal_of(const std::string& toml) {
    try {
        static_cast<void>(read(toml));
    } catch (const Error& error) {
        return error;
    }
    return {ErrorKind::kUsage, "accepted", toml, ""};
}

TEST(BuildConfig, AMisspeltSourceComesWithASuggestionBeforeItIsMissed) {
    for (const std::string wrong : {"photoz", "fotos", "vidoe"}) {
        const Error error = refusal_of("[capture]\n" + wrong + " = \"p\"\n");
        EXPECT_EQ(error.code(), "E-CONFIG-KEY") << wrong;
        EXPECT_THAT(error.what(), HasSubstr("test.toml:2: unknown key `capture." + wrong + "`"));
        EXPECT_THAT(error.advice(), HasSubstr("did you mean `")) << wrong;
    }
    EXPECT_EQ(refusal_of("[capture]\n").code(), "E-CONFIG-VALUE");
}

TEST(BuildConfig, NeedsNothingButPhotographs) {
    const BuildConfig config = read("[capture]\nphotos = \"photos\"\n");
    EXPECT_EQ(config.name, "test");
    EXPECT_EQ(config.photographs_or_video.filename(), "photos");
    EXPECT_TRUE(config.imported_poses.empty());
    EXPECT_FALSE(config.given_lens.has_value());
    EXPECT_EQ(config.ingest.max_width_px, 1600);
    EXPECT_EQ(config.hold_out.every, 0);
}

/// The code of the Error that opening ends in; empty when it is read.
std::string code_of_loading(const std::filesystem::path& path) {
    try {
        static_cast<void>(load_build_config(path));
    } catch (const Error& error) {
        return error.code();
    }
    return {};
}

TEST(BuildConfig, WhatNoConfigurationCouldNameIsRefusedBeforeAnythingIsDone) {
    const ScratchFolder scratch;
    const std::string latin_1 = "caf\xe9";
    std::filesystem::create_directories(scratch / latin_1);
    std::filesystem::create_directories(scratch / "café");
    EXPECT_EQ(code_of_loading(scratch / latin_1), "E-CONFIG-NAME");
    EXPECT_EQ(code_of_loading(scratch / "café"), "");
    write_whole_text(scratch / (latin_1 + ".mp4"), std::string(8, '\0'));
    EXPECT_EQ(code_of_loading(scratch / (latin_1 + ".mp4")), "E-CONFIG-NAME");
    const std::string photos = "[capture]\nphotos = \"p\"\n";
    write_whole_text(scratch / (latin_1 + ".toml"), photos);
    EXPECT_EQ(code_of_loading(scratch / (latin_1 + ".toml")), "E-CONFIG-VALUE");
    write_whole_text(scratch / (latin_1 + ".toml"), "name = \"named\"\n" + photos);
    EXPECT_EQ(code_of_loading(scratch / (latin_1 + ".toml")), "");
}

bool crops_bars(const std::string& toml) { return read(toml).ingest.crop_bars; }

TEST(BuildConfig, BarsAreNotCutOffWhereSomethingWasMadeForTheRaster) {
    const std::string photos = "[capture]\nphotos = \"photos\"\n";
    EXPECT_TRUE(crops_bars(photos));
    EXPECT_FALSE(crops_bars(photos + "import = \"sparse/0\"\n"));
    EXPECT_FALSE(crops_bars(photos + "[calibration]\nboards = \"b\"\n"));
    EXPECT_FALSE(crops_bars(photos + "[poses]\nmasks = \"m\"\n"));
    EXPECT_FALSE(crops_bars(photos + "[depth]\nmasks = \"m\"\n"));
    EXPECT_FALSE(crops_bars(photos + "[depth]\nimport_folder = \"d\"\n"));
}

TEST(BuildConfig, WhatItNamesForSomethingElseHoldsNoPhotographs) {
    const IngestOptions ingest = read(
                                     "[capture]\nphotos = \"photos\"\n"
                                     "[poses]\nmasks = \"photos/m\"\n"
                                     "[calibration]\nboards = \"photos/b\"\n")
                                     .ingest;
    ASSERT_EQ(ingest.other_folders.size(), 2U);
    EXPECT_EQ(ingest.other_folders[0].filename(), "b");
    EXPECT_EQ(ingest.other_folders[1].filename(), "m");
}

TEST(BuildConfig, ResolvesEveryKeyWithItsDefault) {
    const std::string resolved = read("[capture]\nphotos = \"photos\"\n").resolved_toml;
    for (const char* key : {"name",
                            "workspace",
                            "threads",
                            "[capture]",
                            "photos",
                            "video",
                            "import",
                            "max_width_px",
                            "min_width_px",
                            "min_photographs",
                            "video_fps",
                            "keep_overlays",
                            "[calibration]",
                            "camera",
                            "[poses]",
                            "lens_model",
                            "shared_lens",
                            "refine_lens",
                            "max_features",
                            "max_reprojection_error_px",
                            "min_track_length",
                            "min_registered_share",
                            "time_limit_s",
                            "colmap",
                            "[mesh]",
                            "construction",
                            "[depth]",
                            "model",
                            "max_neighbours",
                            "import_folder",
                            "import_mesh",
                            "import_volume",
                            "import_volume_threshold",
                            "masks",
                            "[package]",
                            "max_views",
                            "max_mib",
                            "keep_transients",
                            "[render]",
                            "even_exposure",
                            "fade_beyond_capture",
                            "occlusion_tolerance_px",
                            "noisy_depth_error_px",
                            "depth_views",
                            "depth_block_px",
                            "fill_holes",
                            "check_guesses",
                            "triangle_error_px",
                            "draw_thin",
                            "[evaluate]",
                            "hold_out_every",
                            "hold_out"}) {
        EXPECT_THAT(resolved, HasSubstr(key));
    }
    // What was resolved is itself a configuration, and resolves to itself.
    EXPECT_EQ(read(resolved).resolved_toml, resolved);
}

/// Calls `found` with the dotted name of every key of a configuration, and its value.
template <class Found>
void for_each_key(const std::string& toml, const Found& found) {
    const toml::table document = parsed_toml(toml, "test.toml");
    for (const auto& [key, node] : document) {
        const std::string name(key.str());
        const toml::table* section = node.as_table();
        if (section == nullptr) {
            found(name, node);
            continue;
        }
        for (const auto& [own, value] : *section) found(name + '.' + std::string(own.str()), value);
    }
}

TEST(ExplainedConfiguration, EveryKeyHasAMeaningAndEveryMeaningAKey) {
    const std::string resolved = read("[capture]\nphotos = \"photos\"\n").movable_toml;
    const std::string explained = explained_configuration(resolved);
    std::set<std::string> keys;
    for_each_key(resolved, [&](const std::string& key, const toml::node&) {
        keys.insert(key);
        ASSERT_TRUE(key_meanings().contains(key)) << key;
        EXPECT_THAT(explained, HasSubstr("  # " + key_meanings().at(key) + "\n")) << key;
    });
    for (const auto& [key, meaning] : key_meanings()) {
        EXPECT_TRUE(keys.contains(key)) << key;
        EXPECT_FALSE(meaning.empty());
        EXPECT_EQ(meaning.find('\n'), std::string::npos) << key;
    }
}

TEST(ExplainedConfiguration, SaysWhatItSaidAlsoInSeveralLines) {
    std::string names;
    for (int i = 0; i < 40; ++i) names += "\"photograph " + std::to_string(i) + ".jpg\", ";
    for (const std::string& more :
         {std::string(), "[evaluate]\nhold_out = [" + names + "]\n",
          std::string("[poses]\nmax_reprojection_error_px = 1.23456789012345\n"),
          std::string("[poses]\ncolmap = \"a\\nthreads = 3\"\n")}) {
        const std::string resolved = read("[capture]\nphotos = \"/p\"\n" + more).movable_toml;
        EXPECT_EQ(read(explained_configuration(resolved)).movable_toml, resolved);
    }
}

/// As it stands after "expected" where a value is refused; empty where it is not, or for its type.
std::string expected_instead(const std::string& key, const std::string& value) {
    const std::size_t dot = key.find('.');
    const std::string section = dot == std::string::npos ? "" : "[" + key.substr(0, dot) + "]\n";
    const std::string line = key.substr(dot == std::string::npos ? 0 : dot + 1) + " = " + value;
    const Error refused = refusal_of(
        key.starts_with("capture.")
            ? section + "photos = \"photos\"\n" + line + "\n"
            : (dot == std::string::npos ? line + "\n" : "") + "[capture]\nphotos = \"photos\"\n" +
                  (dot == std::string::npos ? "" : section + line + "\n"));
    const std::string said = refused.what();
    const std::string before = "`" + key + "`: expected ";
    const std::size_t at = said.find(before);
    return at == std::string::npos ? "" : said.substr(at + before.size());
}

TEST(ExplainedConfiguration, NamesTheValuesThatAWrongOneIsAnsweredWith) {
    int checked = 0;
    for_each_key(read("[capture]\nphotos = \"photos\"\n").resolved_toml,
                 [&](const std::string& key, const toml::node& node) {
                     const bool is_text = node.is_string();
                     if (key == "name" || key == "capture.photos" || key == "calibration.camera" ||
                         !(is_text || node.is_number()))
                         return;
                     const std::string expected =
                         expected_instead(key, is_text ? "\"no such word\"" : "-7");
                     if (expected.empty()) return;
                     ++checked;
                     EXPECT_THAT(key_meanings().at(key), HasSubstr(expected));
                 });
    EXPECT_GT(checked, 25);
}

TEST(BuildConfig, RefusesAnUnknownKeyInEverySectionWithASuggestion) {
    for (const char* section :
         {"capture", "calibration", "poses", "mesh", "depth", "package", "render", "evaluate"}) {
        std::string toml = "[" + std::string(section) + "]\nno_such_key = 1\n";
        if (std::string(section) != "capture") toml += "[capture]\n";
        const Error error = refusal_of(toml + "photos = \"p\"\n");
        EXPECT_EQ(error.code(), "E-CONFIG-KEY") << section;
        EXPECT_THAT(error.what(), HasSubstr(std::string(section) + ".no_such_key"));
    }
    const Error error = refusal_of("[capture]\nphotos = \"p\"\nmax_widht_px = 3\n");
    EXPECT_EQ(error.code(), "E-CONFIG-KEY");
    EXPECT_THAT(error.what(), HasSubstr("test.toml:3"));
    EXPECT_THAT(error.advice(), HasSubstr("max_width_px"));
    EXPECT_EQ(refusal_of("naem = \"x\"\n[capture]\nphotos = \"p\"\n").code(), "E-CONFIG-KEY");
}

TEST(BuildConfig, RefusesWhatContradictsItself) {
    for (const char* toml :
         {"",
          "[capture]\nphotos = \"p\"\nvideo = \"v.mp4\"\n",
          "[capture]\nphotos = \"p\"\n[evaluate]\nhold_out_every = 1\n",
          "[capture]\nphotos = \"p\"\n[evaluate]\nhold_out_every = -8\n",
          "[capture]\nphotos = \"p\"\n[evaluate]\nhold_out_every = 8\nhold_out = [\"a\"]\n",
          "[capture]\nphotos = \"p\"\n[package]\nmax_views = -7\n",
          "[capture]\nphotos = \"p\"\n[package]\nmax_mib = -0.5\n",
          "[capture]\nphotos = \"p\"\n[package]\nviews = \"some\"\n",
          "[capture]\nphotos = \"p\"\n[render]\ndepth_views = 2\n",
          "[capture]\nphotos = \"p\"\n[render]\ndepth_block_px = 3\n",
          "[capture]\nphotos = \"p\"\n[render]\nfill_holes = \"some\"\n",
          "[capture]\nphotos = \"p\"\n[render]\ndraw_thin = \"some\"\n",
          "[capture]\nphotos = \"p\"\n[render]\ncheck_guesses = \"some\"\n",
          "[capture]\nphotos = \"p\"\n[render]\ndepth_block_px = 0.5\n",
          "[capture]\nphotos = \"p\"\n[render]\ndepth_block_px = nan\n",
          "[capture]\nphotos = \"p\"\n[render]\ntriangle_error_px = 0.01\n",
          "[capture]\nphotos = \"p\"\n[render]\ntriangle_error_px = nan\n",
          "[capture]\nphotos = \"p\"\n[render]\nnoisy_depth_error_px = 0.01\n",
          "[capture]\nphotos = \"p\"\n[render]\nnoisy_depth_error_px = 11\n",
          "[capture]\nphotos = \"p\"\n[render]\nnoisy_depth_error_px = nan\n",
          "[capture]\nphotos = \"p\"\n[render]\nocclusion_tolerance_px = -1\n",
          "[capture]\nphotos = \"p\"\n[render]\nocclusion_tolerance_px = nan\n",
          "threads = -1\n[capture]\nphotos = \"p\"\n",
          "name = \"a/b\"\n[capture]\nphotos = \"p\"\n",
          "name = \"..\"\n[capture]\nphotos = \"p\"\n"}) {
        EXPECT_EQ(refusal_of(toml).code(), "E-CONFIG-VALUE") << toml;
    }
}

TEST(BuildConfig, SaysWhichNumbersOfDrawingThereMayBe) {
    const auto refused = [](const std::string& setting) {
        const Error error = refusal_of("[capture]\nphotos = \"p\"\n[render]\n" + setting + "\n");
        return std::string(error.what()) + error.advice();
    };
    const std::string zero = "0 (as photographs ask for), ";
    EXPECT_THAT(refused("occlusion_tolerance_px = 101"), HasSubstr(zero + "or 0.1 to 100"));
    EXPECT_THAT(refused("noisy_depth_error_px = 11"), HasSubstr(zero + "or 0.1 to 10"));
    EXPECT_THAT(refused("depth_views = 5"), HasSubstr(zero + "3 or 4"));
    EXPECT_THAT(refused("depth_block_px = 3"), HasSubstr(zero + "or 1 to 2"));
    EXPECT_THAT(refused("triangle_error_px = 11"), HasSubstr(zero + "or 0.1 to 10"));
}

TEST(BuildConfig, ParametersOfAStageAreItsOwn) {
    const BuildConfig plain = read("[capture]\nphotos = \"p\"\n");
    const BuildConfig elsewhere = read("[capture]\nphotos = \"q\"\n");
    const BuildConfig finer = read("[capture]\nphotos = \"p\"\n[depth]\nmax_width_px = 1000\n");
    EXPECT_EQ(plain.stage_parameters.at("ingest"), elsewhere.stage_parameters.at("ingest"));
    EXPECT_EQ(plain.stage_parameters.at("mesh"), finer.stage_parameters.at("mesh"));
    EXPECT_NE(plain.stage_parameters.at("depth"), finer.stage_parameters.at("depth"));
}

TEST(BuildConfig, PackingIsToldWhatItDecidesByAndNoMore) {
    const auto parameters = [](const std::string& before, const std::string& more) {
        return read(before + "[capture]\nphotos = \"p\"\n" + more).stage_parameters.at("pack");
    };
    const std::string plain = parameters("", "");
    EXPECT_EQ(parameters("threads = 1\nworkspace = \"w\"\n", ""), plain);
    EXPECT_EQ(parameters("", "[depth]\nmax_width_px = 1000\n"), plain);
    EXPECT_EQ(parameters("", "[evaluate]\nhold_out_every = 4\n"), plain);
    EXPECT_NE(parameters("name = \"other\"\n", ""), plain);
    EXPECT_NE(parameters("", "[mesh]\nconstruction = \"line\"\n"), plain);
    EXPECT_NE(parameters("", "[package]\nmax_views = 3\n"), plain);
    EXPECT_NE(parameters("", "[render]\neven_exposure = false\n"), plain);
}

TEST(BuildConfig, PathsAreRelativeToTheFile) {
    const ScratchFolder scratch;
    write_whole_text(scratch.path() / "configs" / "cat.toml",
                     "[capture]\nphotos = \"../photos\"\nimport = \"sparse/0\"\n");
    const BuildConfig config = load_build_config(scratch.path() / "configs" / "cat.toml");
    EXPECT_EQ(config.name, "cat");
    EXPECT_EQ(config.photographs_or_video, scratch.path() / "photos");
    EXPECT_EQ(config.imported_poses, scratch.path() / "configs" / "sparse" / "0");
}

TEST(BuildConfig, AFolderOfPhotographsIsAConfiguration) {
    const ScratchFolder scratch;
    const std::filesystem::path photos = scratch.path() / "my \"best\" photos";
    std::filesystem::create_directories(photos);
    const BuildConfig config = load_build_config(photos / "");
    EXPECT_EQ(config.name, "my \"best\" photos");
    EXPECT_TRUE(std::filesystem::equivalent(config.photographs_or_video, photos));
}

TEST(BuildConfig, AnyFolderThatCanBeNamedHasANameForItsBuild) {
    const auto name_of_build_in = [](const std::string& folder) {
        const ScratchFolder scratch;
        std::filesystem::create_directories(scratch / folder);
        return load_build_config(scratch / folder).name;
    };
    std::string letters;
    for (int i = 0; i < 60; ++i) letters += "ж";
    EXPECT_EQ(name_of_build_in(letters), letters.substr(0, 100));
    EXPECT_EQ(name_of_build_in("a" + letters), "a" + letters.substr(0, 98)) << "whole letters";
    EXPECT_EQ(name_of_build_in(".photos"), "photos");
    EXPECT_EQ(name_of_build_in("..."), "capture");
    EXPECT_EQ(name_of_build_in("a \"b\" 100%#"), "a \"b\" 100%#");
}

TEST(BuildConfig, AVideoIsAConfiguration) {
    const ScratchFolder scratch;
    const std::filesystem::path video = scratch.path() / "a walk.mp4";
    write_whole_text(video, std::string("\0\0\0\x18"
                                        "ftypmp42",
                                        12));
    const BuildConfig config = load_build_config(video);
    EXPECT_EQ(config.name, "a walk");
    EXPECT_TRUE(std::filesystem::equivalent(config.photographs_or_video, video));
    EXPECT_EQ(ConfigDocument::open(video).build_config_with({}).photographs_or_video,
              config.photographs_or_video);
    // No text is one, however little it is a configuration.
    write_whole_text(scratch.path() / "notes.txt", "mend me");
    // Nor is a configuration, as some editors encode it.
    write_whole_text(scratch.path() / "wide.toml", std::string("\xff\xfe[\0c\0", 6));
    for (const char* name : {"notes.txt", "wide.toml"}) {
        try {
            static_cast<void>(load_build_config(scratch.path() / name));
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-CONFIG-SYNTAX") << name;
        }
    }
}

TEST(LensFile, GivesTheLens) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "camera.toml",
                     "model = \"SIMPLE_RADIAL\"\nwidth_px = 640\nheight_px = 480\n"
                     "parameters = [500.5, 320, 240, 0.01]\n");
    const Camera lens = read_lens_file(scratch / "camera.toml");
    EXPECT_EQ(lens, (Camera{640, 480, LensModel::kSimpleRadial, {500.5, 320, 240, 0.01}}));
    EXPECT_NE(lens_parameters_text(lens), lens_parameters_text(std::nullopt));
}

TEST(LensFile, ALensComesFromAFileOrFromBoardsAndNotFromBoth) {
    const std::string photos = "[capture]\nphotos = \"p\"\n";
    EXPECT_EQ(read(photos + "[calibration]\nboards = \"b\"\n").boards.filename(), "b");
    EXPECT_TRUE(read(photos).boards.empty());
    EXPECT_THROW(
        static_cast<void>(read(photos + "[calibration]\nboards = \"b\"\ncamera = \"c.toml\"\n")),
        Error);
}

TEST(LensFile, NoLensIsGivenBesideImportedPoses) {
    const std::string imported = "[capture]\nphotos = \"p\"\nimport = \"sparse/0\"\n";
    for (const char* lens : {"camera", "boards"}) {
        const Error error =
            refusal_of(imported + "[calibration]\n" + std::string(lens) + " = \"lens\"\n");
        EXPECT_EQ(error.code(), "E-CONFIG-VALUE");
        EXPECT_THAT(error.what(), HasSubstr("test.toml:5: `calibration." + std::string(lens)));
        EXPECT_THAT(error.what(), HasSubstr("capture.import"));
    }
}

TEST(LensFile, RefusesWhatIsNoLens) {
    const ScratchFolder scratch;
    const std::string size = "width_px = 640\nheight_px = 480\n";
    for (const std::string& toml :
         {std::string("model = \"NONE\"\n") + size, size + "parameters = [1, 2]\n",
          std::string("width_px = 0\nheight_px = 480\nparameters = [1, 1, 1, 1]\n"),
          size + "parameters = [-500, -500, 320, 240]\n", size + "focal = 3\n"}) {
        write_whole_text(scratch / "camera.toml", toml);
        EXPECT_THROW(static_cast<void>(read_lens_file(scratch / "camera.toml")), Error) << toml;
    }
}

}  // namespace
}  // namespace lumi
